// The six directions along the axes of a body's frame, in which clusters keep light from different sides
// apart: lobe 2 * axis faces along the axis, lobe 2 * axis + 1 against it.
//
// Light of a surface with normal n is divided among lobes by the squares of n's components, which add up to
// 1, so no power is lost (as in the ambient cube, McTaggart 2004). Seen from a direction d, each lobe shows
// its area times the component of d along its axis. For a box along the axes this is exact.
#pragma once

#include <cmath>

#include "base/vec.h"

namespace strad {

constexpr int kLobes = 6;

// At most three lobes of the six and their weights.
struct LobeWeights {
  int lobe[3];
  float weight[3];
};

inline int lobe_along(int axis, double component) { return 2 * axis + (component < 0 ? 1 : 0); }

// Weights of a unit normal: they add up to 1.
inline LobeWeights lobes_of_normal(Vec3 normal) {
  LobeWeights w;
  for (int axis = 0; axis < 3; ++axis) {
    w.lobe[axis] = lobe_along(axis, normal[axis]);
    w.weight[axis] = static_cast<float>(normal[axis] * normal[axis]);
  }
  return w;
}

// How strongly each lobe of a cluster takes part in an exchange along `direction` (away from the cluster, in
// its frame, any length). The mean over the cluster's area is 1. `share`: each lobe's share of that area.
inline LobeWeights lobes_towards(Vec3 direction, const float* share) {
  LobeWeights w;
  float mean = 0, all = 0;
  for (int axis = 0; axis < 3; ++axis) {
    w.lobe[axis] = lobe_along(axis, direction[axis]);
    w.weight[axis] = static_cast<float>(std::abs(direction[axis]));
    mean += share[w.lobe[axis]] * w.weight[axis];
    all += w.weight[axis];
  }
  // A cluster that shows almost no area in a direction exchanges nothing there: its kernel is 0.
  const float least = 0.02f * all;
  for (float& weight : w.weight) weight = all > 0 ? weight / std::fmax(mean, least) : 1.0f;
  return w;
}

}  // namespace strad
