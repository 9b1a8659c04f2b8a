// Emitting polygons where they are at an instant, points on them, and the irradiance that they give with
// nothing between.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "light/instant.h"

namespace strad {

// An emitting polygon at an instant, in world coordinates.
struct Emitter {
  std::array<Vec3, 4> corners;
  int count = 0;  // of corners
  Vec3 normal, centre;
  double area = 0;  // m^2
  bool parallelogram = false;
  uint32_t polygon = kNone;
};
Emitter emitter_at(const Scene& scene, uint32_t polygon, const std::vector<Pose>& world_from_body);

// Maps the unit square onto the emitter: bilinearly onto quads, by a fold that keeps areas onto triangles
// (Turk 1990).
Vec3 point_on(const Emitter& emitter, double u, double v);

// By how much point_on() stretches area at (u, v), relative to its mean: 1 on triangles and parallelograms.
double stretch_at(const Emitter& emitter, double u, double v);

// Irradiance at `point` from an emitter of unit radiance that is all gathered at `on_emitter`, with nothing
// between: cos cos area / distance^2. 0 if one does not face the other.
double point_irradiance(const Emitter& emitter, Vec3 on_emitter, const SurfacePoint& point);

// Does the point lie on the side to which the emitter emits?
bool is_before(const Emitter& emitter, Vec3 point);

// What the edge from a to b, relative to the point, adds to twice the irradiance of unit radiance from what
// it bounds: its angle times the cosine between `normal` and that of the plane through edge and point (Baum
// et al. 1989, eq. 9). Positive where it runs against the clock about `normal`.
double edge_irradiance(Vec3 a, Vec3 b, Vec3 normal);

// Irradiance at `point` with `normal` from the convex planar `corners` (count of them, any winding) of unit
// radiance, unoccluded and clipped to the horizon, in [0, pi]: Lambert's formula (Baum et al. 1989, eq. 9).
double unit_irradiance(Vec3 point, Vec3 normal, const Vec3* corners, int count);

}  // namespace strad
