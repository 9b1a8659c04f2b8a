// Noise over space: random, but smooth, and the same for everyone.
#pragma once

#include "base/vec.h"

namespace strad {

// From 0 to 1 with a mean of 0.5 and details of size 1 (gradient noise, Perlin 1985). It is alike POV-Ray's
// in kind, not in its values.
double noise_at(Vec3 p);

// A vector of noises around 0, summed over octaves: each `lambda` times finer and `omega` times weaker than
// the one before.
Vec3 turbulence_at(Vec3 p, double lambda, double omega, int octaves);

}  // namespace strad
