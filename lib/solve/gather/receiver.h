// Where the rays of a gather start: a point of a surface, or points spread over a patch.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "solve/gather/direction_guide.h"
#include "solve/links/nodes.h"

namespace strad {

// Rest coordinates of its body.
struct Receiver {
  Vec3 position, normal;
  uint32_t body = 0;
  uint64_t seed = 0;
  bool spread = false;  // each ray starts at another point of `patch`
  PatchPoints patch{};
  int rays = 0;
  uint32_t node = kNone;  // the leaf that it is, or lies on; kNone: a face of a cluster
};

// `rays`: of a large face; small faces get fewer, by their accuracy share.
// A vertex; the uniform face that it stands for; or its part of an undivided face, since the corners of small
// faces are often inside of what they touch.
Receiver receiver_of_vertex(const NodeTree& tree, uint32_t vertex, int rays);
Receiver receiver_of_patch(const NodeTree& tree, uint32_t node, int rays);
Receiver receiver_of_leaf(const NodeTree& tree, uint32_t leaf, int rays);  // see NodeTree::leaf_at

struct RestRay {
  Vec3 from, towards;  // rest; unit length
  Point2 xi;           // its direction, see DirectionCounts
  float weight = 1;    // inverse of its density, relative to the cosine
};

// The first `count` of a sequence of rays, distributed about the normal by the cosine times `density`. They
// start `offset` (m) above the surface.
std::vector<RestRay> rays_of(const Receiver& receiver, const DirectionDensity& density, int count,
                             double offset);

}  // namespace strad
