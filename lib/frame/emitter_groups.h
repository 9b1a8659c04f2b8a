// Emitting polygons in groups, one for each object and material, and shadow rays to them.
//
// The renderer finds the unoccluded irradiance and the visible fraction of each group separately.
#pragma once

#include <cstdint>
#include <vector>

#include "light/emitter.h"
#include "light/instant.h"
#include "light/spotlight.h"
#include "light/tracer.h"

namespace strad {

// The emitting polygons of one object and material, lit and shadowed as one area light.
struct EmitterGroup {
  uint32_t material = 0;
  std::vector<uint32_t> polygons;
};
std::vector<EmitterGroup> emitter_groups(const Scene& scene);

// The lights of an instant, prepared for shadow rays.
struct LitInstant {
  Instant instant;
  std::vector<SpotCone> cones;                 // per spotlight
  std::vector<std::vector<Emitter>> emitters;  // per group
  std::vector<Rgb> radiance;                   // per group, W / (sr m^2)
};
LitInstant lit_instant(const Scene& scene, const std::vector<EmitterGroup>& groups, double time);

// Irradiance that a group would give at a point with nothing between, for unit radiance.
struct UnoccludedIrradiance {
  double total = 0;           // in [0, pi]
  std::vector<double> up_to;  // running sum over the emitters
};
// Overwrites `irradiance`, whose memory is used again.
void find_unoccluded(const std::vector<Emitter>& emitters, const SurfacePoint& point,
                     UnoccludedIrradiance* irradiance);

// Results of shadow rays to a group. Each ray is weighted by the irradiance from its part of the group,
// relative to the mean over all rays.
struct ShadowRays {
  float seen = 0, all = 0;  // sums of weights, of the free rays and of all
  int rays = 0, free = 0;
};
// The visible fraction of a group.
inline float free_fraction(const ShadowRays& shadow) { return shadow.all > 0 ? shadow.seen / shadow.all : 0; }

// Adds the rays to points [first, first + count) of the group's sequence of points.
void add_shadow_rays(const Tracer& tracer, const LitInstant& lit, const std::vector<Emitter>& emitters,
                     const SurfacePoint& point, const UnoccludedIrradiance& unoccluded, uint32_t first,
                     uint32_t count, ShadowRays* shadow);

}  // namespace strad
