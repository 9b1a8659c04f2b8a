// Links, and the table in which a gather reads them.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/links/kernel.h"
#include "time/time_grid.h"

namespace strad {

// Transport from one node to another on an interval of time: the link brings the irradiance
// kernel(t) * L_emitter(t) to its receiver.
struct Link {
  uint32_t receiver = 0, emitter = 0;
  Interval interval;
  KernelEstimate estimate;
};

// Links by receiver. A still link has one kernel for the whole animation, a dynamic one a kernel for each
// Gauss node of its interval. Node n has the still links first_still[n] to first_still[n + 1] - 1, and
// likewise the dynamic ones.
struct LinkTable {
  struct Still {
    uint32_t emitter;
    float kernel;
  };
  struct Dynamic {
    uint32_t emitter;
    Interval interval;
    float kernel[kMaxOrder];
  };
  std::vector<uint32_t> first_still{0}, first_dynamic{0};  // nodes + 1
  std::vector<Still> still;
  std::vector<Dynamic> dynamic;
};
LinkTable make_link_table(const TimeGrid& grid, uint32_t node_count, const std::vector<Link>& links);

}  // namespace strad
