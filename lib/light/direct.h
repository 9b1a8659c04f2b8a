// Direct light at a point and an instant: spots and emitting polygons, for the solver, frames and probes
// alike.
#pragma once

#include <cstdint>
#include <vector>

#include "light/tracer.h"
#include "scene/scene.h"
#include "scene/trajectory.h"

namespace strad {

// All that depends on the date alone.
struct Instant {
  double time = 0;
  std::vector<Pose> world_from_body;
  std::vector<SpotState> spots;
  std::vector<float> glow;  // per material
};
Instant instant_at(const Scene& scene, double time);

struct SurfacePoint {
  Vec3 position;             // world, on the surface
  Vec3 normal;               // world, unit, of the side that receives
  uint32_t polygon = kNone;  // the polygon it lies on, which never lights itself
};

class DirectLight {
 public:
  DirectLight(const Scene& scene, const Tracer& tracer);  // keeps references

  // W / m^2. One shadow ray a spot in whose cone the point is; each emitting polygon by Lambert's formula
  // times its visible fraction over about `samples` stratified points. Equal `seed` gives equal points.
  // Adds the rays traced to `rays` where it is given.
  Rgb irradiance(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                 uint64_t* rays = nullptr) const;

 private:
  const Scene& scene_;
  const Tracer& tracer_;
  std::vector<uint32_t> emitters_;  // polygons
};

// Irradiance at `point` with `normal` from the convex planar `corners` (count of them, any winding) of unit
// radiance, unoccluded and clipped to the horizon, in [0, pi]: Lambert's formula (Baum et al. 1989, eq. 9).
double unit_irradiance(Vec3 point, Vec3 normal, const Vec3* corners, int count);

// Fraction of a spot's intensity in the direction at `cos_theta` from its axis.
double spot_falloff(const Spot& spot, double cos_theta);

}  // namespace strad
