// Links, and the table in which a gather reads them.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/links/kernel.h"
#include "time/time_grid.h"

namespace strad {

// Adds kernel(t) * L_emitter(t) to the irradiance of the receiver on its interval.
struct Link {
  uint32_t receiver = 0, emitter = 0;
  Interval interval;
  KernelEstimate estimate;
};

// The links in the order in which a gather wants them.
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
