// Direct light at a point and an instant: spots and emitting polygons, for the solver, frames and probes
// alike.
#pragma once

#include <array>
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

// A point of an emitting polygon that lights a point.
struct EmitterSample {
  Vec3 target;           // world, lifted off the emitter
  float irradiance = 0;  // W / m^2 of unit radiance, cosines included, if nothing is between
  uint32_t material = 0;
};

class DirectLight {
 public:
  DirectLight(const Scene& scene, const Tracer& tracer);  // keeps references

  // W / m^2: spots() and all samples that are visible. Equal `seed` gives equal points. Adds the rays traced
  // to `rays` where it is given.
  Rgb irradiance(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                 uint64_t* rays = nullptr) const;

  // Of spots alone: one shadow ray for each in whose cone the point is.
  Rgb spots(const Instant& instant, const SurfacePoint& point, uint64_t* rays) const;

  // Emitting polygons that move, those that do not, or both.
  enum class Which : uint8_t { kAll, kStill, kMoving };
  bool has_moving_emitters() const { return still_.size() < emitters_.size(); }

  // Of emitting polygons alone: all samples that are visible.
  Rgb emitters(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed, Which which,
               uint64_t* rays) const;

  // What to look at to know the light of emitting polygons. The ones that matter get about `samples`
  // stratified points each, in proportion to what they may contribute, by Lambert's formula; of the many that
  // matter little some are drawn and stand for all.
  std::vector<EmitterSample> emitter_samples(const Instant& instant, const SurfacePoint& point, int samples,
                                             uint64_t seed, Which which) const;

 private:
  // An emitting polygon at an instant, world.
  struct Emitter {
    std::array<Vec3, 4> corners;
    int count = 0;
    Vec3 normal, centre;
    double area = 0;
  };
  Emitter emitter_at(uint32_t polygon, const std::vector<Pose>& world_from_body) const;
  EmitterSample sample_at(const Emitter& emitter, const SurfacePoint& point, double u, double v) const;

  const Scene& scene_;
  const Tracer& tracer_;
  std::vector<uint32_t> emitters_;  // polygons, first those that do not move
  std::vector<Emitter> still_;      // where those are for good
  std::vector<double> cos_outer_;   // of spots
};

// Irradiance at `point` with `normal` from the convex planar `corners` (count of them, any winding) of unit
// radiance, unoccluded and clipped to the horizon, in [0, pi]: Lambert's formula (Baum et al. 1989, eq. 9).
double unit_irradiance(Vec3 point, Vec3 normal, const Vec3* corners, int count);

// Fraction of a spot's intensity in the direction at `cos_theta` from its axis.
double spot_falloff(const Spot& spot, double cos_theta);

}  // namespace strad
