// Directions of a hemisphere in proportion to their cosine.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "base/vec.h"

namespace strad {

// A direction about `normal`, by Malley's method (Malley 1988). `at`: uniform in the unit square.
inline Vec3 cosine_direction(Vec3 normal, Point2 at) {
  const double radius = std::sqrt(at.u), angle = 2 * kPi * at.v;
  const Frame frame = frame_about(normal);
  return normalized(radius * std::cos(angle) * frame.tangent + radius * std::sin(angle) * frame.bitangent +
                    std::sqrt(std::max(0.0, 1 - at.u)) * normal);
}

}  // namespace strad
