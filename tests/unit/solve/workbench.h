// All that the solver builds before it looks at links, for tests: mesh, hierarchy, visibility, swept bounds.
#pragma once

#include <memory>
#include <vector>

#include "../light/light_test_scene.h"
#include "solve/kernel.h"

namespace strad {

struct Workbench {
  Scene scene;
  TimeGrid grid;
  Tracer tracer;
  SweptBounds swept;
  MeshBuilder builder;
  std::unique_ptr<NodeTree> nodes;
  std::unique_ptr<KernelEvaluator> kernels;

  // Faces of the front sides of all polygons, in their order.
  explicit Workbench(Scene s, int order = 2, int cells = 16)
      : scene(std::move(s)),
        grid(make_time_grid(scene.start, scene.end, {}, order, cells * order)),
        tracer(scene),
        swept(scene, tracer, grid),
        builder(scene) {
    for (uint32_t p = 0; p < scene.polygons.size(); ++p) builder.face(p, 0);
    nodes = std::make_unique<NodeTree>(scene, &builder);
    kernels = std::make_unique<KernelEvaluator>(*nodes, tracer, grid, swept);
  }
  Interval always() const { return {0, grid.spans[0].log2_cells}; }

  // Splits a node `levels` deep; returns its leaves.
  std::vector<uint32_t> leaves_of(uint32_t node, int levels) {
    if (levels == 0) return {node};
    if (nodes->nodes()[node].first_child == kNone) nodes->split(node);
    std::vector<uint32_t> leaves;
    for (uint32_t c = 0; c < 4; ++c) {
      const std::vector<uint32_t> below = leaves_of(nodes->nodes()[node].first_child + c, levels - 1);
      leaves.insert(leaves.end(), below.begin(), below.end());
    }
    return leaves;
  }
};

}  // namespace strad
