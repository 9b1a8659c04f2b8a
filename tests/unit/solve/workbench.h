// All that the solver builds before it looks at links, for tests: mesh, hierarchy, visibility, swept bounds.
#pragma once

#include <memory>
#include <vector>

#include "../light/light_test_scene.h"
#include "light/instant.h"
#include "solve/links/kernel.h"

namespace strad {

enum class Roots { kFaces, kClusters };  // of the hierarchy: one per face, or one per body

struct Workbench {
  Scene scene;
  TimeGrid grid;
  std::vector<Instant> instants;
  Tracer tracer;
  SweptBounds swept;
  MeshBuilder builder;
  std::unique_ptr<NodeTree> nodes;
  std::unique_ptr<KernelEvaluator> kernels;

  // Faces of the front sides of all polygons, in their order, but for those that become uniform: they come
  // first.
  explicit Workbench(Scene s, int order = 2, int cells = 16, Roots roots = Roots::kFaces,
                     double uniform_below = 0)
      : scene(std::move(s)),
        grid(make_time_grid(scene.start, scene.end, {}, order, cells * order)),
        tracer(scene),
        swept(scene, tracer, grid),
        builder(scene) {
    for (uint32_t n = 0; n < grid.sample_count(); ++n)
      instants.push_back(instant_at(scene, sample_time(grid, n)));
    std::vector<bool> fronts(2 * scene.polygons.size());
    for (size_t side = 0; side < fronts.size(); side += 2) fronts[side] = true;
    builder.add_faces(fronts, uniform_below);
    plant(roots);
  }
  // The hierarchy from its roots, over the mesh as it is.
  void plant(Roots roots) {
    nodes = std::make_unique<NodeTree>(scene, &builder, roots == Roots::kClusters);
    kernels = std::make_unique<KernelEvaluator>(*nodes, tracer, grid, swept);
  }
  Interval always() const { return {0, grid.spans[0].log2_cells}; }
  const Node& node(uint32_t n) const { return nodes->nodes()[n]; }
  const Cluster& cluster(uint32_t n) const { return nodes->cluster(node(n)); }

  KernelEstimate estimate(uint32_t receiver, uint32_t emitter, Interval interval) const {
    KernelCounts counts;
    return kernels->estimate(receiver, emitter, interval, &counts);
  }

  // Splits a patch `levels` deep; returns its leaves.
  std::vector<uint32_t> leaves_of(uint32_t n, int levels) {
    if (levels == 0) return {n};
    std::vector<uint32_t> leaves;
    for (const uint32_t child : children_of(n))
      for (const uint32_t leaf : leaves_of(child, levels - 1)) leaves.push_back(leaf);
    return leaves;
  }
  std::vector<uint32_t> children_of(uint32_t n) {
    if (node(n).is_leaf()) nodes->split(n);
    std::vector<uint32_t> children;
    for (uint32_t c = 0; c < node(n).child_count; ++c) children.push_back(node(n).first_child + c);
    return children;
  }
  // Splits all clusters down to patches.
  void split_clusters() {
    for (uint32_t n = 0; n < nodes->nodes().size(); ++n)
      if (node(n).is_cluster() && node(n).is_leaf()) nodes->split(n);
  }
};

// Leaves of the hierarchy below a node, as far as it is split.
inline std::vector<uint32_t> leaves_below(const NodeTree& tree, uint32_t node) {
  if (tree.nodes()[node].is_leaf()) return {node};
  std::vector<uint32_t> leaves;
  for (uint32_t c = 0; c < tree.nodes()[node].child_count; ++c)
    for (const uint32_t leaf : leaves_below(tree, tree.nodes()[node].first_child + c)) leaves.push_back(leaf);
  return leaves;
}

// n x n x n boxes that fill `share` of each edge of the cells of a grid over the box from `lower` to `upper`.
inline void add_boxes(Scene* scene, Vec3 lower, Vec3 upper, int n, double share, uint32_t body = 0,
                      Rgb reflectance = {0.5f, 0.5f, 0.5f}) {
  const Vec3 cell = (upper - lower) / n;
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 at = lower + Vec3{cell.x * (i % n), cell.y * (i / n % n), cell.z * (i / n / n)};
    const Vec3 l = at + (0.5 * (1 - share)) * cell;
    add_box(scene, l, l + share * cell, false, body, reflectance);
  }
}

// A parallelogram of n x n parts, from `corner` along `u` and `v`; its front is where u, v, n are
// right-handed.
inline uint32_t add_parts(Scene* scene, Vec3 corner, Vec3 u, Vec3 v, int n, uint32_t body = 0,
                          Rgb reflectance = {0.5f, 0.5f, 0.5f}) {
  const auto first = static_cast<uint32_t>(scene->polygons.size());
  const Vec3 du = u / n, dv = v / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3 at = corner + i * du + j * dv;
      add_polygon(scene, {at, at + du, at + du + dv, at + dv}, body, reflectance);
    }
  return first;
}

}  // namespace strad
