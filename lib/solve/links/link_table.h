// Links, and the table in which a gather reads them.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/links/kernel.h"
#include "time/time_grid.h"

namespace strad {

// Transport from one node to another on an interval of time: kernel(t) * L_emitter(t) of the irradiance of
// the receiver comes along the link.
struct Link {
  uint32_t receiver = 0, emitter = 0;
  Interval interval;
  KernelEstimate estimate;
};

// The links ordered by receiver: first those whose kernel never changes, and apart from them all others.
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
