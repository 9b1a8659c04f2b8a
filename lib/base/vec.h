// Points, vectors and normals in three dimensions, in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace strad {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;  // radians

struct Vec3 {
  double x = 0, y = 0, z = 0;
  double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  bool operator==(const Vec3&) const = default;
};

struct Vec2 {
  double x = 0, y = 0;
  bool operator==(const Vec2&) const = default;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec3 operator*(Vec3 a, double s) { return s * a; }
inline Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
inline Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length2(Vec3 a) { return dot(a, a); }
inline double length(Vec3 a) { return std::sqrt(length2(a)); }

// Unit vector along `a`; zero for the zero vector.
inline Vec3 normalized(Vec3 a) {
  const double l = length(a);
  return l > 0 ? a / l : Vec3{};
}
inline Vec3 lerp(Vec3 a, Vec3 b, double s) { return (1 - s) * a + s * b; }
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
// The z component of the cross product: positive if `b` is counter-clockwise of `a`.
inline double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// Axis-aligned box; empty when any lower > upper.
struct Box {
  Vec3 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Vec3 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
             -std::numeric_limits<double>::infinity()};

  bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  void add(Vec3 p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  void add(const Box& b) {
    if (b.empty()) return;
    add(b.lower);
    add(b.upper);
  }
  Vec3 centre() const { return 0.5 * (lower + upper); }
  double diagonal() const { return empty() ? 0 : length(upper - lower); }
  // Does the segment from `from` to from + reach * direction meet the box? (Kay & Kajiya 1986)
  bool meets(Vec3 from, Vec3 direction, double reach) const {
    double near = 0, far = reach;
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = 1 / direction[axis];
      double a = (lower[axis] - from[axis]) * inverse, b = (upper[axis] - from[axis]) * inverse;
      if (a > b) std::swap(a, b);
      if (a > near) near = a;
      if (b < far) far = b;
    }
    return near <= far * (1 + 1e-6);  // room for rounding: a ray tracer in floats may still report a hit
  }
};

// Two unit vectors that complete the unit vector `n` to a right-handed frame
// (Duff et al. 2017, "Building an orthonormal basis, revisited").
struct Frame {
  Vec3 tangent, bitangent, normal;
};
inline Frame frame_about(Vec3 n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace strad
