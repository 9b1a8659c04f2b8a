// Where bodies, spotlights and glows are at an instant, and points of surfaces there.
#pragma once

#include <cstdint>
#include <vector>

#include "base/none.h"
#include "scene/scene.h"
#include "scene/trajectory.h"

namespace strad {

// All that depends on time alone.
struct Instant {
  double time = 0;
  std::vector<Pose> world_from_body;
  std::vector<SpotState> spots;
  std::vector<float> glow;  // per material
};
Instant instant_at(const Scene& scene, double time);

struct SurfacePoint {
  Vec3 position;             // world, on the surface
  Vec3 normal;               // world, unit, of the side that receives
  uint32_t polygon = kNone;  // the polygon it lies on, which never lights itself
};

}  // namespace strad
