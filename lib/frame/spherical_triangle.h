// Triangles as seen from a point, on the unit sphere about it.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.h"

namespace strad {

// Solid angle of the triangle with corners in the directions a, b, c (unit vectors), in [0, 2 pi] (Van
// Oosterom & Strackee 1983).
inline double solid_angle(Vec3 a, Vec3 b, Vec3 c) {
  return 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

// Maps (u, v) of the unit square onto the directions of the triangle, in proportion to solid angle (Arvo
// 1995). `solid`: its solid angle, > 0.
inline Vec3 direction_in(Vec3 a, Vec3 b, Vec3 c, double solid, double u, double v) {
  const double cos_at_a = std::clamp(dot(normalized(cross(a, b)), normalized(cross(a, c))), -1.0, 1.0);
  const double sin_at_a = std::sqrt(1 - cos_at_a * cos_at_a), angle = std::acos(cos_at_a);
  // The corner c moves along its edge to a until the triangle has the share u of its solid angle.
  const double s = std::sin(u * solid - angle), t = std::cos(u * solid - angle);
  const double p = t - cos_at_a, q = s + sin_at_a * dot(a, b), below = (q * s + p * t) * sin_at_a;
  const double cos_moved = below != 0 ? std::clamp(((q * t - p * s) * cos_at_a - q) / below, -1.0, 1.0) : 1;
  const Vec3 moved = cos_moved * a + std::sqrt(1 - cos_moved * cos_moved) * normalized(c - dot(c, a) * a);
  // Then a point on the arc from b to there.
  const double height = 1 - v * (1 - dot(moved, b));
  const Vec3 across = moved - dot(moved, b) * b;
  if (!(length2(across) > 0)) return b;
  return height * b + std::sqrt(std::max(0.0, 1 - height * height)) * normalized(across);
}

}  // namespace strad
