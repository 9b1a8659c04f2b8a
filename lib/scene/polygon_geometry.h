// Polygons of a scene at rest: normals, areas, positions on them.
#pragma once

#include "base/vec.h"
#include "scene/scene.h"

namespace strad {

// Of the front side, unit length; counter-clockwise corners seen from there.
Vec3 polygon_normal(const Scene& scene, const Polygon& polygon);
double polygon_area(const Scene& scene, const Polygon& polygon);  // m^2
// Of a triangle or a convex planar quad, m^2.
double area_of(const Vec3* corners, int count);

// Parametric position of a rest point on its polygon: bilinear (u, v) of a quad with corners 0, 1, 2, 3 at
// (0,0), (1,0), (1,1), (0,1); of a triangle p = c0 + u (c1 - c0) + v (c2 - c0). Clamped into the polygon.
Vec2 parametric_of(const Scene& scene, const Polygon& polygon, Vec3 rest_point);
Vec3 point_of(const Scene& scene, const Polygon& polygon, Vec2 uv);

}  // namespace strad
