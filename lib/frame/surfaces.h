// What a ray meets: the point, the side, and how it reflects and emits.
#pragma once

#include <vector>

#include "light/direct.h"
#include "light/posed_tracer.h"
#include "light/tracer.h"
#include "scene/scene.h"

namespace strad {

struct Sight {
  SurfacePoint point;  // polygon kNone: the ray left the scene
  // Where a facet of a smooth surface takes its direct light from: with the surface's normal, and lifted onto
  // it, so that facets beside it cast no shadows. On other polygons the same as `point`.
  SurfacePoint smooth;
  bool front = true;
  Vec2 at;  // parametric, on the polygon
  Rgb reflectance;
  Rgb emission;      // radiance towards the ray's origin, glow included
  Vec3 direction{};  // of the ray, unit length; zero where there was none
  bool textured = false;
  const Finish* finish = nullptr;  // of a mirror or glass
};

class Surfaces {
 public:
  Surfaces(const Scene& scene, const Tracer& tracer);  // keeps references

  // REQUIRES: `direction` has length 1.
  Sight look(const Instant& instant, Vec3 from, Vec3 direction) const;
  // The same for many rays of one instant, whose poses `tracer` has.
  Sight look(const PosedTracer& tracer, const Instant& instant, Vec3 from, Vec3 direction) const;

  // What the ray sees by diffuse light: see Tracer::closest_through.
  Sight look_through(const Instant& instant, Vec3 from, Vec3 direction, Rgb* passed) const;

  // The point of a polygon at a rest position on it, seen by a ray of that direction, if by any.
  Sight at(const Instant& instant, uint32_t polygon, bool front, Vec3 rest_point, Vec3 direction = {}) const;

 private:
  Sight seen(const Instant& instant, const SurfaceHit& hit, Vec3 direction) const;

  // (p - origin) . to_u and . to_v are the parametric position of p; for quads that are no parallelograms
  // parametric_of does it.
  struct Plane {
    Vec3 origin, to_u, to_v, normal;
    bool affine = false;
  };
  static Plane plane_of(const Scene& scene, const Polygon& polygon);
  SurfacePoint smooth_point(const Polygon& polygon, const Sight& sight, const Pose& pose,
                            Vec3 rest_point) const;

  const Scene& scene_;
  const Tracer& tracer_;
  std::vector<Plane> planes_;            // per polygon, rest
  std::vector<const Finish*> finishes_;  // per material; null: plain
};

}  // namespace strad
