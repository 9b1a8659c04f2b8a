// Emitter groups at an instant: the irradiance that each gives with nothing between, and shadow rays to it.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/emitter_groups.h"
#include "light/emitter.h"
#include "light/instant.h"
#include "light/posed_tracer.h"
#include "light/spotlight.h"
#include "light/tracer.h"

namespace strad {

// Points or vectors, coordinate by coordinate, for loops over all.
struct Vec3Columns {
  std::vector<double> x, y, z;
  void add(Vec3 v) { x.push_back(v.x), y.push_back(v.y), z.push_back(v.z); }
  Vec3 operator[](size_t i) const { return {x[i], y[i], z[i]}; }
};

// A group where it is at an instant, in world coordinates.
struct LitGroup {
  const EmitterGroup* group = nullptr;
  Pose world_from_rest;
  Rgb radiance;  // W / (sr m^2)
  std::vector<Emitter> facets;
  Vec3Columns vertices;
  // Per facet: its plane is normal . p = level.
  Vec3Columns centres, normals;
  std::vector<double> levels, areas;
  std::vector<double>
      near2;  // m^2: squared distance from its centre within which it is too large for a point
};

// The lights of an instant, prepared for shadow rays.
struct LightsAtInstant {
  Instant instant;
  std::vector<SpotCone> cones;  // per spotlight
  std::vector<LitGroup> groups;
};
// Keeps pointers to `groups`.
LightsAtInstant lights_at(const Scene& scene, const std::vector<EmitterGroup>& groups, double time);

// A group as seen from a point.
struct GroupSight {
  // m, per facet: how far the point is before its plane. One more, -1, is for edges with a single facet.
  std::vector<double> distance;
  std::vector<double> height;  // m, per vertex: above the horizon of the point, the plane of its surface
  bool below_horizon = false;  // is a vertex below it?
  std::vector<double> up_to;   // per facet: estimated irradiance from it and all before it
  // Of a group that is far away and all above the horizon: its view, which replaces all of the above.
  const GroupView* view = nullptr;
  Vec3 position, normal;        // of the point, rest
  std::vector<uint8_t> before;  // by ViewEdge::left or right: does that facet emit to the point?
};
// Overwrites `sight`, whose memory is used again.
void see_group(const LitGroup& group, const SurfacePoint& point, GroupSight* sight);

// Irradiance from the group with nothing between, each facet for itself, for unit radiance; in [0, pi] for a
// convex group. The edge between two facets adds the same to both with opposite signs, so the outlines of
// what is seen are enough.
double unoccluded_irradiance(const LitGroup& group, const SurfacePoint& point, const GroupSight& sight);

// Results of shadow rays to a group. Each ray is weighted by the irradiance from its part of the group,
// relative to the mean over all rays.
struct ShadowRays {
  float seen = 0, all = 0;  // sums of weights, of the free rays and of all
  int rays = 0, free = 0;
  Rgb dimmed;             // sum of weights, times the shares that glass keeps of the free rays
  int through_glass = 0;  // of the free rays
};
// The visible fraction of a group.
inline float free_fraction(const ShadowRays& shadow) { return shadow.all > 0 ? shadow.seen / shadow.all : 0; }
// The same by channel, less what glass keeps.
inline Rgb free_colour(const ShadowRays& shadow) {
  const float free = free_fraction(shadow);
  const Rgb white{free, free, free};
  return shadow.through_glass == 0 ? white : white - (1 / shadow.all) * shadow.dimmed;
}

// Points [first, first + count) of a scrambled sequence of points on a group, which follows from `scramble`.
struct ShadowPoints {
  uint32_t first = 0, count = 0;
  uint64_t scramble = 0;
};

// Adds the rays to `points` on the group. `irradiance` is its unoccluded_irradiance at the point.
void add_shadow_rays(const Tracer& tracer, const Instant& instant, const LitGroup& group,
                     const SurfacePoint& point, double irradiance, ShadowPoints points, GroupSight* sight,
                     ShadowRays* shadow);
// The same for many points of one instant.
void add_shadow_rays(const PosedTracer& tracer, const LitGroup& group, const SurfacePoint& point,
                     double irradiance, ShadowPoints points, GroupSight* sight, ShadowRays* shadow);

}  // namespace strad
