// Points of the two-dimensional (0, 2)-sequence of Sobol' (1967).
//
// Of 4^k points from a multiple of 4^k on, one lies in each of the 4^k cells of every dyadic division of the
// unit square.
#pragma once

#include <bit>
#include <cstddef>
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

inline uint32_t reversed_bits(uint32_t v) {
  v = (v >> 1 & 0x55555555u) | (v & 0x55555555u) << 1;
  v = (v >> 2 & 0x33333333u) | (v & 0x33333333u) << 2;
  v = (v >> 4 & 0x0f0f0f0fu) | (v & 0x0f0f0f0fu) << 4;
  v = (v >> 8 & 0x00ff00ffu) | (v & 0x00ff00ffu) << 8;
  return v >> 16 | v << 16;
}

// Flips each bit by a function of the bits above it (Owen 1995), by operations on the reversed bits that
// carry only upwards (Laine & Karras 2011).
inline uint32_t owen_scrambled(uint32_t v, uint32_t seed) {
  v = reversed_bits(v) + seed;
  v ^= v * 0x9e3779b8u;
  v = v * (seed >> 15 | 1) + 0x7f4a7c15u;
  v ^= v * 0xbf58476cu;
  v *= 0x94d049bbu;
  v ^= v * 0x133111eau;
  return reversed_bits(v);
}

// What changes from a point to the next, by the lowest bit of its index that is 0.
struct SobolSteps {
  uint32_t u[32] = {}, v[32] = {};
  constexpr SobolSteps() {
    uint32_t of_u = 0x80000000u, of_v = 0x80000000u, all_u = 0, all_v = 0;
    for (size_t bit = 0; bit < 32; ++bit, of_u >>= 1, of_v ^= of_v >> 1) {
      all_u ^= of_u, all_v ^= of_v;
      u[bit] = all_u, v[bit] = all_v;
    }
  }
};
inline constexpr SobolSteps kSteps;

// Points from index `first` on under Owen's scrambling, which also breaks up the lattices that flipped bits
// leave.
class OwenSequence {
 public:
  OwenSequence(uint32_t first, uint64_t scramble)
      : index_(first),
        seed_u_(static_cast<uint32_t>(scramble)),
        seed_v_(static_cast<uint32_t>(scramble >> 32)) {
    uint32_t of_u = 0x80000000u, of_v = 0x80000000u;
    for (; first; first >>= 1, of_u >>= 1, of_v ^= of_v >> 1) {
      if (first & 1) u_ ^= of_u, v_ ^= of_v;
    }
  }
  Point2 next() {
    const Point2 at{(owen_scrambled(u_, seed_u_) + 0.5) * 0x1p-32,
                    (owen_scrambled(v_, seed_v_) + 0.5) * 0x1p-32};
    // To the next index all bits up to the lowest 0 change.
    const auto lowest = static_cast<size_t>(std::countr_one(index_++));
    u_ ^= kSteps.u[lowest & 31], v_ ^= kSteps.v[lowest & 31];
    return at;
  }

 private:
  uint32_t index_, seed_u_, seed_v_, u_ = 0, v_ = 0;
};

}  // namespace strad
