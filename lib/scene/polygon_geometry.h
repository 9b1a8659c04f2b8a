// Polygons of a scene at rest: normals, areas, positions on them.
#pragma once

#include "base/vec.h"
#include "scene/scene.h"

namespace strad {

// Of the front side, unit length; counter-clockwise corners seen from there.
Vec3 polygon_normal(const Scene& scene, const Polygon& polygon);
double polygon_area(const Scene& scene, const Polygon& polygon);  // m^2
// Six times the volume between a polygon and `origin`, m^3, negative where its front looks there: the sum
// over a closed surface is six times what it encloses, wherever `origin` is, but near is most exact.
double six_volumes(const Scene& scene, const Polygon& polygon, Vec3 origin);
// Of a triangle or a convex planar quad, m^2.
double area_of(const Vec3* corners, int count);

// Parametric position of a rest point on its polygon: bilinear (u, v) of a quad with corners 0, 1, 2, 3 at
// (0,0), (1,0), (1,1), (0,1); of a triangle p = c0 + u (c1 - c0) + v (c2 - c0). Clamped into the polygon.
Vec2 parametric_of(const Scene& scene, const Polygon& polygon, Vec3 rest_point);
Vec3 point_of(const Scene& scene, const Polygon& polygon, Vec2 uv);

// Weights of the corners at a parametric position: what is linear or bilinear on the polygon is their sum of
// the values at the corners. The last is 0 for a triangle.
struct CornerWeights {
  double of[4];
};
inline CornerWeights corner_weights(const Polygon& polygon, Vec2 at) {
  const double u = at.x, v = at.y;
  if (polygon.corner_count() == 3) return {{1 - u - v, u, v, 0}};
  return {{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}};
}

}  // namespace strad
