// Counter-based random numbers: a value depends on its key only, never on the order of calls.
#pragma once

#include <cstdint>

namespace strad {

// Finaliser of SplitMix64 (Steele, Lea & Flood 2014): a bijective mix of 64 bits.
inline uint64_t mix64(uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}
inline uint64_t hash_of(uint64_t a, uint64_t b = 0, uint64_t c = 0) { return mix64(mix64(mix64(a) + b) + c); }

// Uniform in [0, 1) from 53 bits of `h`.
inline double unit_from(uint64_t h) { return static_cast<double>(h >> 11) * 0x1p-53; }

// Point `i` of the R2 low-discrepancy sequence (Roberts 2018), shifted by (u, v), in [0, 1)^2.
struct Point2 {
  double u, v;
};
inline Point2 r2_point(uint32_t i, double u, double v) {
  u += 0.7548776662466927 * (i + 1);
  v += 0.5698402909980532 * (i + 1);
  return {u - static_cast<double>(static_cast<int64_t>(u)), v - static_cast<double>(static_cast<int64_t>(v))};
}

}  // namespace strad
