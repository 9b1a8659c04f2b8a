// Direct light at one point over many time samples.
//
// Between a point at rest and an emitter at rest, visibility changes only while a moving body may pass
// between them. A shadow ray is traced once, and again only at the time samples of cells in which this may
// happen.
#pragma once

#include <cstdint>
#include <vector>

#include "light/direct.h"
#include "solve/prepare/swept.h"
#include "time/time_grid.h"

namespace strad {

// A point of a polygon, in rest coordinates.
struct RestPoint {
  Vec3 position;
  Vec3 normal;  // unit, of the side that receives
  uint32_t polygon = kNone;
};

class DirectOverTime {
 public:
  // Keeps references. `instants`: one per time sample. `samples`: per emitter, see
  // DirectLight::emitter_samples.
  DirectOverTime(const Scene& scene, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept,
                 const std::vector<Instant>& instants, int samples);

  // Irradiance at the given time samples, W / m^2. Equal `seed` gives equal shadow points.
  std::vector<Rgb> irradiance(const RestPoint& point, const std::vector<uint32_t>& time_samples,
                              uint64_t seed, uint64_t* rays) const;

 private:
  void add_still_emitters(const SurfacePoint& point, const std::vector<uint32_t>& time_samples, uint64_t seed,
                          std::vector<Rgb>* values, uint64_t* rays) const;

  const Scene& scene_;
  const Tracer& tracer_;
  const TimeGrid& grid_;
  const SweptBounds& swept_;
  const std::vector<Instant>& instants_;
  DirectLight light_;
  int samples_;
  // Poses of the first instant, with each glow at its largest: emitters at rest are sampled once, by it.
  Instant brightest_;
  std::vector<bool> still_mask_, moving_mask_;
};

}  // namespace strad
