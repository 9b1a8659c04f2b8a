// How much each corner of an outline counts at a point of it.
#pragma once

#include <vector>

#include "base/vec.h"

namespace strad {

// Weights with the sum 1: their mean of the corners is the point, and along an edge only its two ends count
// (mean value coordinates, Hormann & Floater 2006). What neighbours interpolate with them agrees on their
// edge. REQUIRES: the outline is flat and convex, `normal` is its unit normal, and the point is in it.
std::vector<double> corner_weights(const std::vector<Vec3>& outline, Vec3 normal, Vec3 point);

}  // namespace strad
