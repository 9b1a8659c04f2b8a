// The solution's surfaces as triangles with light at their corners, for all exports to other programs.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "export/leaves.h"
#include "scene/scene.h"
#include "scene/trajectory.h"
#include "solution/solution.h"

namespace strad {

// A corner of triangles: a point of a surface, and the vertices of the solution's mesh that give its light.
struct ExportCorner {
  Vec3 position;  // rest, m
  // In the slab's mesh. The irradiance at the corner is the weighted sum of theirs, or 0 where there is none.
  std::array<uint32_t, 4> vertices{kNone, kNone, kNone, kNone};
  std::array<float, 4> weights{};
  uint32_t material = 0;
  bool textured = false;
  bool emits = false;
  Vec2 uv;  // where textured
  // Of the surface, on the side shown: interpolated on smooth surfaces. Only in scenes that have any, else 0.
  Vec3 normal;  // rest, unit
};

// The sides of all polygons of one rigid body that can be seen.
struct ExportBody {
  uint32_t body = 0;
  std::vector<ExportCorner> corners;  // ordered by material; of one material, first those without texture
  std::vector<std::array<uint32_t, 3>>
      triangles;  // indices of corners, counter-clockwise seen from the side shown
};

// The bodies that have polygons, in order. A leaf with smaller leaves at its edges becomes a fan of triangles
// about its centre, so that no edge has a corner in its middle (a T-junction). A quad that two triangles
// would show wrongly becomes such a fan too, or four fans where it shares no corners with other leaves. If
// light also reaches the back of a polygon, both sides are given, and the back is moved off the front by
// export_lift.
std::vector<ExportBody> export_mesh(const Scene& scene, const Slab& slab, ExportLight light);

// The distance in metres between the two sides of a polygon, and between a lamp and the polygon it stands
// for: 2e-6 of the scene's diagonal. This is more than rounding errors, and too little to be seen.
double export_lift(const Scene& scene);

// Irradiance at a corner, W / m^2.
Rgb corner_irradiance(const ExportCorner& corner, const std::vector<Rgb>& vertex_irradiance);

}  // namespace strad
