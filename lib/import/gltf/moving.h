// Nodes of a glTF file that move, as bodies.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "import/gltf/model.h"

namespace strad {

// p maps to p.x x + p.y y + p.z z + origin.
struct GltfTransform {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{};

  Vec3 direction(Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
  Vec3 point(Vec3 p) const { return direction(p) + origin; }
  bool mirrors() const { return dot(cross(x, y), z) < 0; }
};
GltfTransform operator*(const GltfTransform& a, const GltfTransform& b);

// The channels of a node; null where there is none.
struct GltfMotion {
  const GltfChannel *translation = nullptr, *rotation = nullptr, *scale = nullptr;
};

// The node's transformation at 0 s in its parent's frame.
GltfTransform rest_transform(const GltfNode& node, const GltfMotion& motion);

// Whether a rotation in this frame is one in the world: all directions are scaled alike.
bool is_similarity(const GltfTransform& transform);

// The body of a node that moves, without parent and name: where its motion puts points that are at rest in
// the world. `parent`: world from the parent node, at rest. `bounds`: of what moves with it; no point there
// is further than `tolerance` from where the format says, at any time. REQUIRES: a translation or a rotation;
// if a rotation, the parent's transformation is a similarity.
Body moving_body(const GltfMotion& motion, const GltfNode& node, const GltfTransform& parent,
                 const Box& bounds, double tolerance);

}  // namespace strad
