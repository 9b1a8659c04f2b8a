#include "scene/polygon_geometry.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

Vec3 corner(const Scene& scene, const Polygon& polygon, int i) { return scene.vertices[polygon.corners[i]]; }

// Twice the polygon's area times its normal.
Vec3 doubled_area_vector(const Scene& scene, const Polygon& polygon) {
  const Vec3 a = corner(scene, polygon, 0), b = corner(scene, polygon, 1), c = corner(scene, polygon, 2);
  if (polygon.corner_count() == 3) return cross(b - a, c - a);
  return cross(c - a, corner(scene, polygon, 3) - b);
}

// A quotient, or 0 if it is not finite, so that degenerate polygons still give positions inside themselves.
double quotient(double numerator, double denominator) {
  const double q = numerator / denominator;
  return std::isfinite(q) ? q : 0;
}

Vec2 clamped_to_triangle(Vec2 uv) {
  uv = {std::max(0.0, uv.x), std::max(0.0, uv.y)};
  const double sum = uv.x + uv.y;
  return sum > 1 ? Vec2{uv.x / sum, uv.y / sum} : uv;
}

// The plane of two axes in which a polygon appears largest: the two that follow its largest normal component.
struct Projection {
  int first, second;
  Vec2 operator()(Vec3 v) const { return {v[first], v[second]}; }
};
Projection projection_along(Vec3 normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (x >= y && x >= z) return {1, 2};
  return y >= z ? Projection{2, 0} : Projection{0, 1};
}

Vec2 triangle_parametric(const Scene& scene, const Polygon& polygon, Vec3 rest_point) {
  const Vec3 c0 = corner(scene, polygon, 0);
  const Projection flat = projection_along(doubled_area_vector(scene, polygon));
  const Vec2 e = flat(corner(scene, polygon, 1) - c0), f = flat(corner(scene, polygon, 2) - c0);
  const Vec2 h = flat(rest_point - c0);
  const double area = cross2(e, f);
  return clamped_to_triangle({quotient(cross2(h, f), area), quotient(cross2(e, h), area)});
}

// The inverse of h = u e + v f + u v g: v is the root of a quadratic at which the map keeps the quad's
// orientation.
Vec2 inverse_bilinear(Vec2 e, Vec2 f, Vec2 g, Vec2 h, double orientation) {
  const double k2 = cross2(g, f), k1 = cross2(e, f) + cross2(h, g), k0 = cross2(h, e);
  const double root = std::copysign(std::sqrt(std::max(0.0, k1 * k1 - 4 * k2 * k0)), orientation);
  const bool same_sign = k1 * orientation >= 0;  // the form of the root without cancellation (Goldberg 1991)
  const double v = same_sign ? quotient(-2 * k0, k1 + root) : quotient(root - k1, 2 * k2);
  const Vec2 along{e.x + v * g.x, e.y + v * g.y}, rest{h.x - v * f.x, h.y - v * f.y};
  const double u =
      std::abs(along.x) >= std::abs(along.y) ? quotient(rest.x, along.x) : quotient(rest.y, along.y);
  return {std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)};
}

Vec2 quad_parametric(const Scene& scene, const Polygon& polygon, Vec3 rest_point) {
  const Vec3 c0 = corner(scene, polygon, 0), c1 = corner(scene, polygon, 1);
  const Vec3 c2 = corner(scene, polygon, 2), c3 = corner(scene, polygon, 3);
  const Projection flat = projection_along(doubled_area_vector(scene, polygon));
  const double orientation = cross2(flat(c2 - c0), flat(c3 - c1));
  return inverse_bilinear(flat(c1 - c0), flat(c3 - c0), flat((c0 - c1) + (c2 - c3)), flat(rest_point - c0),
                          orientation);
}

}  // namespace

Vec3 polygon_normal(const Scene& scene, const Polygon& polygon) {
  return normalized(doubled_area_vector(scene, polygon));
}

double polygon_area(const Scene& scene, const Polygon& polygon) {
  return length(doubled_area_vector(scene, polygon)) / 2;
}

Vec2 parametric_of(const Scene& scene, const Polygon& polygon, Vec3 rest_point) {
  return polygon.corner_count() == 3 ? triangle_parametric(scene, polygon, rest_point)
                                     : quad_parametric(scene, polygon, rest_point);
}

Vec3 point_of(const Scene& scene, const Polygon& polygon, Vec2 uv) {
  const Vec3 c0 = corner(scene, polygon, 0), c1 = corner(scene, polygon, 1), c2 = corner(scene, polygon, 2);
  if (polygon.corner_count() == 3) return c0 + uv.x * (c1 - c0) + uv.y * (c2 - c0);
  return lerp(lerp(c0, c1, uv.x), lerp(corner(scene, polygon, 3), c2, uv.x), uv.y);
}

double six_volumes(const Scene& scene, const Polygon& polygon, Vec3 origin) {
  const auto at = [&](int c) { return scene.vertices[polygon.corners[c]] - origin; };
  double sum = 0;
  for (int c = 2; c < polygon.corner_count(); ++c) sum += dot(at(0), cross(at(c - 1), at(c)));
  return sum;
}

double area_of(const Vec3* corners, int count) {
  double area = length(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
  if (count == 4) area += length(cross(corners[2] - corners[0], corners[3] - corners[0])) / 2;
  return area;
}

}  // namespace strad
