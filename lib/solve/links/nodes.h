// The spatial hierarchy of the solve: clusters of surfaces, surfaces and their patches, in the frame of one
// body.
//
// It is built lazily. At first there is one cluster per body. Where refinement asks for it, a cluster is
// split by one step of an octree with tight-fitting boxes (Christensen et al. 1997). So a surface has a node
// only once all clusters above it were split.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "scene/scene.h"
#include "solve/links/lobes.h"
#include "solve/mesh/mesh_builder.h"

namespace strad {

// A cluster of faces, or a patch: an element of the mesh seen from one side.
struct Node {
  uint32_t cluster = kNone;  // index of its Cluster; kNone: a patch
  uint32_t element = kNone;  // of a patch
  uint32_t face = kNone;     // of a patch
  uint32_t body = 0;
  uint32_t parent = kNone;       // kNone: a root
  uint32_t first_child = kNone;  // child_count in a row; kNone: a leaf
  uint32_t child_count = 0;
  uint32_t slot = 0;     // the first row for its functions of time: one for a patch, kLobes for a cluster
  float area = 0;        // m^2
  float radius = 0;      // m, of a sphere about the centre
  Vec3 centre;           // rest
  Vec3 normal;           // rest, of the receiving and emitting side of a patch
  Rgb reflectance;       // of a patch; the mean of a cluster
  float coverage = 1;    // of a patch: the share of its area that is no hole
  bool is_part = false;  // of a leaf that links reach as a whole, see divide()

  bool is_cluster() const { return cluster != kNone; }
  bool is_leaf() const { return first_child == kNone; }
};

// A point of a cluster's surfaces. Each of them represents an equal share of the area.
struct SurfaceSample {
  Vec3 position, normal;  // rest; of the side that takes part
};

struct Cluster {
  static constexpr int kSamples = 16;       // of equal area each
  uint32_t first_face = 0, face_count = 0;  // in NodeTree::cluster_faces()
  Box box;                                  // rest
  float lobe_share[kLobes] = {};            // of the area
  SurfaceSample samples[kSamples];
};

class NodeTree {
 public:
  // Keeps both. With `clusters`: one root cluster per body; without: one root patch per face.
  NodeTree(const Scene& scene, MeshBuilder* builder, bool clusters);

  const std::vector<Node>& nodes() const { return nodes_; }
  const Cluster& cluster(const Node& node) const { return clusters_[node.cluster]; }
  size_t cluster_count() const { return clusters_.size(); }
  // Faces of a cluster: cluster.face_count of them from cluster.first_face on.
  const std::vector<uint32_t>& cluster_faces() const { return cluster_faces_; }
  size_t slot_count() const { return slot_count_; }
  const MeshBuilder& builder() const { return builder_; }
  const Scene& scene() const { return scene_; }

  // Makes the children of a leaf.
  void split(uint32_t node);
  // The same of a leaf patch, whose children get no links of their own.
  void divide(uint32_t patch);

  // Leaves are leaf patches and the faces of leaf clusters. They are numbered from 0: the node of
  // a patch, or nodes().size() + the face.
  size_t leaf_count() const { return nodes_.size() + node_of_face_.size(); }
  // The leaf at a place (see parametric_of()) of a side of a polygon; kNone where that side has no face.
  uint32_t leaf_at(uint32_t polygon, uint32_t side, Vec2 uv) const { return leaf_at(polygon, side, &uv); }
  // Turns `*uv` into the parametric coordinates of the leaf.
  uint32_t leaf_at(uint32_t polygon, uint32_t side, Vec2* uv) const;
  // The leaf cluster or the root patch of a face.
  uint32_t node_of_face(uint32_t face) const { return node_of_face_[face]; }

  Vec3 face_normal(uint32_t face) const;  // rest, unit, of its side
  double face_area(uint32_t face) const;
  float face_coverage(uint32_t face) const;  // share of its polygon that is no hole

 private:
  uint32_t add_patch(uint32_t element, uint32_t parent);
  uint32_t add_cluster(uint32_t first_face, uint32_t face_count, uint32_t parent);
  void split_cluster(uint32_t node);
  void sample(Cluster* cluster, double area, uint64_t seed) const;

  const Scene& scene_;
  MeshBuilder& builder_;
  std::vector<Node> nodes_;
  std::vector<Cluster> clusters_;
  std::vector<uint32_t> cluster_faces_;
  std::vector<uint32_t> node_of_face_;
  std::vector<float> coverage_;  // [polygon]; empty: all are whole
  size_t slot_count_ = 0;
};

// Corners of a patch, rest.
struct PatchPoints {
  Vec3 corners[4];
  int corner_count;
};
PatchPoints patch_points(const NodeTree& tree, const Node& node);
PatchPoints face_points(const Scene& scene, const Face& face);

// Maps (u, v) of the unit square onto the patch, uniformly by area for parallelograms and triangles.
Vec3 point_on_patch(const PatchPoints& patch, double u, double v);

}  // namespace strad
