// The spatial hierarchy of the solve: every surface that takes part, and its patches, in the frame of one
// body.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "scene/scene.h"
#include "solve/mesh_builder.h"

namespace strad {

// A patch: an element of the mesh seen from one side. Children exist only where refinement has asked for
// them.
struct Node {
  uint32_t element = kNone;
  uint32_t face = 0;
  uint32_t body = 0;
  uint32_t parent = kNone;
  uint32_t first_child = kNone;  // four in a row; kNone: a leaf
  float area = 0;                // m^2
  float radius = 0;              // m, of a sphere about the centre
  Vec3 centre;                   // rest
  Vec3 normal;                   // rest, of the receiving and emitting side
  Rgb reflectance;
};

class NodeTree {
 public:
  NodeTree(const Scene& scene, MeshBuilder* builder);  // keeps both; makes a root node of every face

  const std::vector<Node>& nodes() const { return nodes_; }
  const MeshBuilder& builder() const { return builder_; }
  const Scene& scene() const { return scene_; }
  uint32_t root_of_face(uint32_t face) const { return root_of_face_[face]; }

  // Makes the children of a leaf.
  void split(uint32_t node);

  // The leaf that holds a rest point of a side of a polygon; kNone where that side has no face.
  uint32_t leaf_at(uint32_t polygon, uint32_t side, Vec3 rest_point) const;

 private:
  uint32_t add(uint32_t element, uint32_t parent);

  const Scene& scene_;
  MeshBuilder& builder_;
  std::vector<Node> nodes_;
  std::vector<uint32_t> root_of_face_;
};

// Nine points of a quad (corners, middles of edges, centre) or six of a triangle, rest, in the order of
// Element::vertices and then of MeshBuilder::middles.
struct PatchPoints {
  Vec3 corners[4];
  int corner_count;
};
PatchPoints patch_points(const NodeTree& tree, const Node& node);

// Maps (u, v) of the unit square onto the patch, uniformly by area for parallelograms and triangles.
Vec3 point_on_patch(const PatchPoints& patch, double u, double v);

}  // namespace strad
