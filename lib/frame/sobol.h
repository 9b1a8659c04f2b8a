// Points of the two-dimensional (0, 2)-sequence of Sobol' (1967).
//
// Of 4^k points from a multiple of 4^k on, one lies in each of the 4^k cells of every dyadic division of the
// unit square.
#pragma once

#include <cstdint>

#include "base/rng.h"

namespace strad {

// Point `index`, its bits flipped by `scramble`, which keeps the property (Kollig & Keller 2002).
inline Point2 sobol_point(uint32_t index, uint64_t scramble) {
  uint32_t u = static_cast<uint32_t>(scramble), v = static_cast<uint32_t>(scramble >> 32);
  uint32_t of_u = 0x80000000u, of_v = 0x80000000u;
  for (; index; index >>= 1, of_u >>= 1, of_v ^= of_v >> 1) {
    if (index & 1) u ^= of_u, v ^= of_v;
  }
  return {(u + 0.5) * 0x1p-32, (v + 0.5) * 0x1p-32};
}

}  // namespace strad
