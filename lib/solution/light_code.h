// Irradiance as 16-bit integers: evenly spaced near zero, then 8 bits of mantissa, as in a small
// floating-point format whose code, read as an integer, ascends with the value. Exact to half a quantum or
// 1/512 of the value.
#pragma once

#include <cstdint>

#include "solution/solution.h"

namespace strad {

constexpr int kMantissaBits = 8;
constexpr int kLowestExponent = -160, kHighestExponent = 130;  // of the quantum 2^exponent

// The quantum for a slab: at most 2e-4 of the mean irradiance over its vertices and time, all light together.
int quantum_exponent(const Slab& slab);

// REQUIRES: `quantum` is a power of two.
int16_t light_code(float value, double quantum);
float light_of(int16_t code, double quantum);

}  // namespace strad
