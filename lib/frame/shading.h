// What single rays of a frame see.
//
// The parts of a sample's light that the renderer filters separately are stored separately.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "frame/camera.h"
#include "frame/frame_light.h"
#include "frame/lit_groups.h"
#include "frame/surfaces.h"
#include "light/posed_spots.h"

namespace strad {

// Radiance, and what of it is indirect, emitted, and seen in a mirror or through glass. The rest is direct.
struct Light {
  Rgb all, indirect, emission, specular{};
};
inline Light operator+(const Light& a, const Light& b) {
  return {a.all + b.all, a.indirect + b.indirect, a.emission + b.emission, a.specular + b.specular};
}
inline Light operator*(float s, const Light& a) {
  return {s * a.all, s * a.indirect, s * a.emission, s * a.specular};
}

// An instant of a frame, prepared for rays. Keeps references into itself: it does not move.
struct FrameInstant {
  FrameInstant(const Scene& scene, const Tracer& base, const std::vector<EmitterGroup>& groups, double time)
      : lights(lights_at(scene, groups, time)),
        tracer(base, scene, lights.instant.world_from_body),
        spots(tracer, lights.cones, lights.instant) {}
  FrameInstant(const FrameInstant&) = delete;
  FrameInstant& operator=(const FrameInstant&) = delete;

  const LightsAtInstant lights;
  const PosedTracer tracer;
  const PosedSpots spots;
};

// All that the samples of one frame share.
struct FrameView {
  const Scene& scene;
  const Surfaces& surfaces;
  const FrameLight& light;
  std::vector<CameraRays> cameras;    // one per instant
  std::deque<FrameInstant> instants;  // of the exposure, evenly spread; one where the shutter is not open
  size_t group_count = 0;             // 0 also where direct light comes from the mesh
  bool trace_direct = true;
  const FrameLight* indirect = nullptr;  // alone, where `light` has direct light too and somebody asks
  uint32_t lamp_samples = 32;  // shadow rays of a corner to each emitter group in whose penumbra it lies
};

// Light of an emitter group at a sample, before its visibility is multiplied in.
struct GroupShare {
  Rgb radiance;           // what it would add to the sample's radiance, unoccluded
  double irradiance = 0;  // unoccluded_irradiance of the group
  ShadowRays shadow;      // the shadow rays so far
};

struct Sample {
  SurfacePoint point;  // polygon kNone: nothing was hit
  bool front = true;
  uint32_t leaf = kNone;  // of the mesh, where elements show
  uint64_t spots = 0;     // which of them reach the point, and what a mirror or glass shows there
  Light base;             // of all but emitter groups
  bool varies = false;    // within a pixel: the surface is textured, a mirror or glass
};

// What is seen through (x, y), pixels, at an instant.
Sight look(const FrameView& view, size_t instant, double x, double y);

// The light of what is seen. `shares`: group_count of them, filled here with shadow rays to `points`.
Sample shade(const FrameView& view, size_t instant, const Sight& sight, ShadowPoints points,
             GroupShare* shares);

// look(), then shade(): a sample through (x, y).
Sample take_sample(const FrameView& view, size_t instant, double x, double y, ShadowPoints points,
                   GroupShare* shares);

// Adds shadow rays to share `group` of a sample.
void add_shadow_rays(const FrameView& view, size_t instant, const Sample& sample, size_t group,
                     ShadowPoints points, GroupShare* share);

// Radiance of a sample, emitter groups included.
Light light_of(const FrameView& view, const Sample& sample, const GroupShare* shares);

// Do both lie on one smooth surface, on the same side?
bool on_one_surface(const FrameView& view, const Sample& a, const Sample& b);

// Do both lie on one smooth surface, in one leaf if leaves are shown, and in the light of the same
// spotlights?
bool alike(const FrameView& view, const Sample& a, const Sample& b);

// Is each emitter group seen by all of the shadow rays to it, or by none?
bool evenly_lit(const FrameView& view, const GroupShare* shares);

}  // namespace strad
