// Spotlights: their falloff and the irradiance that they give.
#pragma once

#include <cstdint>
#include <vector>

#include "light/instant.h"
#include "light/tracer.h"

namespace strad {

// The cosines of a spotlight's half-angles, which are the same at all times.
struct SpotCone {
  double cos_inner = 1, cos_outer = 1;
};
SpotCone cone_of(const Spot& spot);
std::vector<SpotCone> cones_of(const std::vector<Spot>& spots);

// Fraction of a spotlight's intensity in the direction at `cos_theta` from its axis: a smoothstep in the
// cosine, 1 inside the inner cone and 0 outside the outer one.
double spot_falloff(const SpotCone& cone, double cos_theta);

// W / m^2 at `point` from a spotlight of 1 W / sr with nothing between; 0 outside its cone and on the side of
// the surface that it does not face.
double spot_irradiance(const SpotCone& cone, const SpotState& spot, const SurfacePoint& point);

// What the shadow rays of spots_irradiance found.
struct SpotRays {
  uint64_t traced = 0;
  uint64_t reached = 0;  // hash of the set of spotlights that reach the point: equal sets give equal values
};

// W / m^2 at `point` from all spotlights, by one shadow ray to each whose cone holds the point. Adds to
// `rays`. REQUIRES: `cones` are those of the scene of `instant`.
Rgb spots_irradiance(const Tracer& tracer, const std::vector<SpotCone>& cones, const Instant& instant,
                     const SurfacePoint& point, SpotRays* rays);

}  // namespace strad
