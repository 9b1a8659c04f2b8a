// Direct light at a point and an instant, from spotlights and emitting polygons, as the solver samples it.
#pragma once

#include <cstdint>
#include <vector>

#include "light/emitter.h"
#include "light/instant.h"
#include "light/spotlight.h"
#include "light/tracer.h"
#include "scene/scene.h"

namespace strad {

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

  // Of spotlights alone, by one shadow ray for each in whose cone the point is.
  Rgb spots(const Instant& instant, const SurfacePoint& point, uint64_t* rays) const;

  // Emitting polygons that move, those that do not, or both.
  enum class Which : uint8_t { kAll, kStill, kMoving };
  bool has_moving_emitters() const { return still_.size() < emitters_.size(); }

  // Of emitting polygons alone: all samples that are visible.
  Rgb emitters(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed, Which which,
               uint64_t* rays) const;

  // Points of emitting polygons for shadow rays. Each bright emitter gets up to `samples` stratified points,
  // in proportion to its likely share of the irradiance. Together they have the unoccluded irradiance of
  // Lambert's formula for the polygon. Of many faint emitters some are drawn at random to represent all of
  // them (Shirley, Wang & Zimmerman 1996).
  std::vector<EmitterSample> emitter_samples(const Instant& instant, const SurfacePoint& point, int samples,
                                             uint64_t seed, Which which) const;

 private:
  // Emitters that may light a point, with the irradiance of each, roughly and with nothing between.
  struct Candidate {
    Emitter emitter;
    uint32_t material;
    double likely;  // W / m^2
  };
  struct Candidates {
    std::vector<Candidate> list;
    double total = 0;  // W / m^2: the sum of `likely`
    double least = 0;  // W / m^2: emitters below it are faint
    double faint = 0;  // W / m^2: the sum of `likely` over the faint ones
  };
  Candidates candidates_for(const Instant& instant, const SurfacePoint& point, Which which) const;
  double likely_irradiance(const Emitter& emitter, const Instant& instant, const SurfacePoint& point) const;
  EmitterSample sample_at(const Candidate& from, const SurfacePoint& point, double u, double v) const;
  void add_stratified(const Candidate& candidate, const SurfacePoint& point, int side, uint64_t seed,
                      std::vector<EmitterSample>* chosen) const;
  void add_drawn(const Candidates& candidates, const SurfacePoint& point, int samples, uint64_t seed,
                 std::vector<EmitterSample>* chosen) const;

  const Scene& scene_;
  const Tracer& tracer_;
  std::vector<uint32_t> emitters_;  // polygons, first those that do not move
  std::vector<Emitter> still_;      // those that do not move, prepared once
  std::vector<SpotCone> cones_;
};

}  // namespace strad
