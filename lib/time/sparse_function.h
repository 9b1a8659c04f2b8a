// A function of time that is known in some cells of the time grid only.
#pragma once

#include <cstdint>
#include <vector>

#include "time/scaled_function.h"

namespace strad {

// Values at the time samples of some cells: `order` (of the time grid) values per cell, in the order of
// `cells`.
struct SparseFunction {
  std::vector<uint32_t> cells;  // ascending
  FineFunction values;
};

}  // namespace strad
