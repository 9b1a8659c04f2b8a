// Where light comes from that a mirror or glass sends to the eye.
#pragma once

#include "base/rng.h"
#include "frame/surfaces.h"
#include "scene/glass.h"

namespace strad {

// After so many mirrors and surfaces of glass, only diffuse light is seen.
constexpr int kMostSpecular = 8;

// A ray on from a surface, with the share of its radiance that the eye sees; black: there is none.
struct SpecularRay {
  Vec3 from, direction;  // world; unit length
  Rgb share;
};
struct SpecularRays {
  SpecularRay mirrored, passed;
};

// The rays that go on from where `sight.direction` met a surface. Solid glass bends them; panes and glass
// that is no dielectric do not. `lobe`: uniform in the unit square, which facet of a rough mirror is met.
// `offset`: m, by which rays are lifted off the surface.
// REQUIRES: a finish.
SpecularRays specular_rays(GlassKind kind, const Sight& sight, double offset, Point2 lobe);

}  // namespace strad
