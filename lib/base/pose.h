// Rigid motions: unit quaternions and poses.
#pragma once

#include "base/vec.h"

namespace strad {

struct Quat {
  double w = 1, x = 0, y = 0, z = 0;
  bool operator==(const Quat&) const = default;
};

inline Quat operator*(Quat a, Quat b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quat conjugate(Quat q) { return {q.w, -q.x, -q.y, -q.z}; }

// REQUIRES: `axis` has length 1. `angle` in radians, counter-clockwise seen against the axis.
inline Quat rotation_about(Vec3 axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}
inline Vec3 rotate(Quat q, Vec3 v) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2 * cross(u, v);
  return v + q.w * t + cross(u, t);
}

// Maps p to rotate(rotation, p) + translation. Named out-of-in: world_from_body.
struct Pose {
  Quat rotation;
  Vec3 translation;
  bool operator==(const Pose&) const = default;
};

inline Vec3 operator*(const Pose& a, Vec3 point) { return rotate(a.rotation, point) + a.translation; }
inline Pose operator*(const Pose& a, const Pose& b) { return {a.rotation * b.rotation, a * b.translation}; }
inline Pose inverse(const Pose& a) {
  const Quat r = conjugate(a.rotation);
  return {r, -rotate(r, a.translation)};
}
inline Vec3 rotate(const Pose& a, Vec3 direction) { return rotate(a.rotation, direction); }
inline Vec3 rotate_back(const Pose& a, Vec3 direction) { return rotate(conjugate(a.rotation), direction); }

}  // namespace strad
