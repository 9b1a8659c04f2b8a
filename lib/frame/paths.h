// Unbiased light at a point by path tracing: what a solution is measured against.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rng.h"
#include "frame/surfaces.h"
#include "light/spotlight.h"
#include "light/tracer.h"

namespace strad {

// The random numbers of one path: value i depends on the key and i alone.
class PathRandom {
 public:
  explicit PathRandom(uint64_t key) : key_(key) {}
  double next() { return unit_from(mix64(key_ + ++count_)); }  // uniform in [0, 1)

 private:
  uint64_t key_;
  uint64_t count_ = 0;
};

// Paths over diffuse surfaces with light sampled at each of their points (Kajiya 1986). Emitters are found
// both by points drawn on them and by the paths' own directions, weighted by the balance heuristic (Veach &
// Guibas 1995): either alone is noisy, far from them or close by. Thread-safe.
class Paths {
 public:
  Paths(const Scene& scene, const Tracer& tracer, const Surfaces& surfaces);  // keeps references

  // W / m^2: an unbiased estimate of what all spots bring straight, by one of them.
  Rgb spots(const Instant& instant, const SurfacePoint& point, PathRandom* random) const;

  // W / m^2: an unbiased estimate of all other light that `point` receives, of emitters or reflected.
  // `first`, uniform in the unit square, is the direction in which the path leaves.
  Rgb but_spots(const Instant& instant, const SurfacePoint& point, Point2 first, PathRandom* random) const;

 private:
  // A point of an emitter seen from a point that it lights.
  struct Candidate {
    Vec3 target;     // world, lifted off the emitter
    Rgb irradiance;  // W / m^2, unoccluded, of the share of power for which it stands
  };
  Candidate draw_emitter(const Instant& instant, const SurfacePoint& point, PathRandom* random) const;
  Rgb emitters(const Instant& instant, const SurfacePoint& point, PathRandom* random) const;
  Rgb met_emitter(const SurfacePoint& from, Vec3 direction, const Sight& sight) const;
  Rgb unoccluded(const Instant& instant, const SurfacePoint& point, size_t spot) const;

  const Scene& scene_;
  const Tracer& tracer_;
  const Surfaces& surfaces_;
  std::vector<SpotCone> cones_;
  // Triangles of emitting polygons, rest, and the running sum of their area times emission.
  struct EmittingTriangle {
    Vec3 corners[3];
    Vec3 normal;
    double density = 0;  // of the points drawn, 1 / m^2
    uint32_t polygon = kNone;
  };
  std::vector<EmittingTriangle> emitters_;
  std::vector<double> up_to_;
};

}  // namespace strad
