// Poses, lights and cameras at an instant, in double precision.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace strad {

// At a step (two keys at one time) the value after the step holds at that very time.

// world_from_body of every body, in order of bodies, at `time`.
std::vector<Pose> poses_at(const Scene& scene, double time);

struct SpotState {
  Vec3 position;   // world
  Vec3 direction;  // world, unit length
  Rgb intensity;   // W / sr
};
SpotState spot_at(const Scene& scene, const Spot& spot, const std::vector<Pose>& world_from_body,
                  double time);

// Scale of every material's emission at `time`, 1 where it has no glow.
std::vector<float> glow_at(const Scene& scene, double time);

struct CameraState {
  Vec3 from, to, up;
  double fov;  // vertical, radians
};
CameraState camera_at(const Camera& camera, double time);

// The times strictly inside (start, end) at which anything steps, ascending, each once.
std::vector<double> step_times(const Scene& scene);

// True for bodies that move, or whose parents do, at any time in [start, end].
std::vector<bool> moving_bodies(const Scene& scene);

}  // namespace strad
