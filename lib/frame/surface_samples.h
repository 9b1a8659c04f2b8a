// Points spread evenly over the surfaces of a scene, the same at every call.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace strad {

struct RestSample {
  uint32_t polygon = 0;
  uint32_t side = 0;  // 0 front, 1 back
  Vec3 rest_point;
};

// Each in [0, 1). Drawn at random, they make every point uniform over the area, and means over the points
// unbiased (Cranley & Patterson 1976).
struct SampleShift {
  double area = 0.5, u = 0.5, v = 0.5;
};

// `count` points in order of polygons, the count of each side in proportion to its area, of the sides with
// wanted[2 * polygon + side]. Those in holes of textures are left out. Empty when their area is zero.
std::vector<RestSample> surface_samples(const Scene& scene, const std::vector<bool>& wanted, uint32_t count,
                                        const SampleShift& shift = {});

}  // namespace strad
