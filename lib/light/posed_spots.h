// Light of spotlights at an instant, for many points of one frame.
#pragma once

#include <vector>

#include "light/posed_tracer.h"
#include "light/spotlight.h"

namespace strad {

class PosedSpots {
 public:
  // Keeps references. REQUIRES: `cones` are those of the scene of `instant`.
  PosedSpots(const PosedTracer& tracer, const std::vector<SpotCone>& cones, const Instant& instant);

  // The same as spots_irradiance(). Spotlights whose cone or side of the surface rules them out cost no root
  // and no ray, and dark ones nothing.
  Rgb irradiance(const SurfacePoint& point, SpotRays* rays) const;

 private:
  const PosedTracer& tracer_;
  const std::vector<SpotCone>& cones_;
  const Instant& instant_;
  std::vector<uint32_t> lit_;  // spotlights that are not dark
};

}  // namespace strad
