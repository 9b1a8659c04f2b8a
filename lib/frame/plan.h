// A scene from above: outlines, paths of bodies, cones of spotlights, what the camera sees.
#pragma once

#include <cstdint>

#include "image/image.h"
#include "scene/scene.h"

namespace strad {

struct PlanOptions {
  uint32_t width = 640, height = 480;  // pixels
  Vec3 up{0, 1, 0};                    // towards the eye: the axis that is nearest to it is taken
};

// The plan at `time`, on white: edges of polygons grey; each body's edges and the path of its centre over all
// time in a colour of its own, with a dot at each second; spotlights orange, out to where they point;
// `camera`, which may be null, blue, with its path.
Image plan_of(const Scene& scene, const Camera* camera, double time, const PlanOptions& options);

}  // namespace strad
