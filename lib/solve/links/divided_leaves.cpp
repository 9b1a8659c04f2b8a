#include "solve/links/divided_leaves.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace strad {
namespace {

constexpr int kMostLevels = 2;

struct Leaf {
  uint32_t node;
  double error;  // W / (sr m^2): rms difference of its quarters, by its weight and area
};

// Where light is smooth, quarters of a quarter differ half as much. What the leaf's own quarters show of
// direct light may be more than what its neighbours make expect.
Leaf leaf_with_error(const Refinement& refinement, const NodeTree& tree, uint32_t n) {
  const Node& node = tree.nodes()[n];
  const Refinement::Shading own = refinement.shading_of(n);
  float spread = own.spread;
  if (node.parent != kNone && !tree.nodes()[node.parent].is_cluster())
    spread = std::max(spread, refinement.shading_of(node.parent).spread / 2);
  return {n, double{own.weight} * spread * std::sqrt(node.area / refinement.total_area())};
}

}  // namespace

void divide_leaves(const Refinement& refinement, double threshold, NodeTree* tree) {
  std::vector<Leaf> leaves;
  for (uint32_t n = 0; n < tree->nodes().size(); ++n) {
    const Node& node = tree->nodes()[n];
    if (node.is_leaf() && !node.is_cluster() && node.face >= tree->builder().undivided_faces())
      leaves.push_back(leaf_with_error(refinement, *tree, n));
  }
  for (int level = 0; level < kMostLevels; ++level) {
    std::vector<Leaf> parts;
    for (const Leaf& leaf : leaves) {
      if (leaf.error <= threshold) continue;
      tree->divide(leaf.node);
      const Node& node = tree->nodes()[leaf.node];
      for (uint32_t c = 0; c < node.child_count; ++c)
        parts.push_back(
            {node.first_child + c, leaf.error / 4});  // half the spread, half the root of the area
    }
    leaves = std::move(parts);
  }
}

}  // namespace strad
