// Irradiance as 16-bit integers.
//
// Codes near zero are multiples of a quantum. Larger ones are small floating-point numbers with 8 bits of
// mantissa. A larger code always means a larger value. The error is at most half a quantum or 1/512 of the
// value.
#pragma once

#include <cstdint>

#include "solution/solution.h"

namespace strad {

constexpr int kMantissaBits = 8;
constexpr int kLowestExponent = -160, kHighestExponent = 130;  // of the quantum 2^exponent

// The quantum for a slab: the largest power of two up to 2e-4 of the mean irradiance over its vertices and
// time, direct and indirect light together, and up to 2e-3 of what 98 % of the vertices exceed in the mean
// over time. Of the latter, less than 1/10,000 of the mean counts as that.
int quantum_exponent(const Slab& slab);

// REQUIRES: `quantum` is a power of two.
int16_t light_code(float value, double quantum);
float light_of(int16_t code, double quantum);

}  // namespace strad
