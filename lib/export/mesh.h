// The solution's surfaces as triangles with light at their corners: what the exports for other programs
// share.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "export/leaves.h"
#include "scene/scene.h"
#include "scene/trajectory.h"
#include "solution/solution.h"

namespace strad {

// A point of one side of one material, and where its light comes from.
struct ExportCorner {
  Vec3 position;  // rest, m
  // Of the slab's mesh; the corner's irradiance is the weighted sum of theirs, 0 of none.
  std::array<uint32_t, 4> vertices{kNone, kNone, kNone, kNone};
  std::array<float, 4> weights{};
  uint32_t material = 0;
  bool textured = false;
  bool emits = false;
  Vec2 uv;  // where textured
};

// The visible sides of all polygons that move as one.
struct ExportBody {
  uint32_t body = 0;
  std::vector<ExportCorner> corners;               // ordered by material, then those without texture first
  std::vector<std::array<uint32_t, 3>> triangles;  // of corners, counter-clockwise seen from the lit side
};

// Bodies in their order, without those that have no polygons. Leaves that smaller leaves touch are cut about
// their centre so that no edge has a corner in its middle; so are quads that two triangles would show
// wrongly, those that share no corners into quarters first. Both sides of a polygon are given when its back
// is lit too, the back lifted by export_lift.
std::vector<ExportBody> export_mesh(const Scene& scene, const Slab& slab, ExportLight light);

// m: 2e-6 of the scene's diagonal. Between the two sides of a polygon, and between a lamp and the polygon it
// stands for: more than rounding, less than shows.
double export_lift(const Scene& scene);

// What a corner receives, W / m^2.
Rgb corner_irradiance(const ExportCorner& corner, const std::vector<Rgb>& vertex_irradiance);

}  // namespace strad
