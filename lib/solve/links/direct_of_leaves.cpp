#include "solve/links/direct_of_leaves.h"

#include <numeric>

#include "base/parallel.h"

namespace strad {

FunctionBlock direct_of_divided_leaves(const Workspace& work, const DirectPhase& phase) {
  const NodeTree& tree = work.tree;
  std::vector<uint32_t> all_cells(work.grid.cell_count());
  std::iota(all_cells.begin(), all_cells.end(), 0u);
  std::vector<uint32_t> leaves;
  for (const uint32_t leaf : leaves_of(tree))
    if (!is_uniform(tree.builder().mesh().elements[surface_of(tree, leaf).element])) leaves.push_back(leaf);
  FunctionBlock divided(tree.leaf_count(), leaves, work.grid.sample_count());
  parallel_for(leaves.size(), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::vector<Rgb> mean = phase.mean_irradiance(surface_of(tree, leaves[i]).element, all_cells);
      for (size_t d = 0; d < mean.size(); ++d) divided.set(leaves[i], d, mean[d]);
    }
  });
  return divided;
}

std::vector<Rgb> DirectOfLeaves::irradiance(uint32_t leaf, uint32_t first, uint32_t count) const {
  const auto order = static_cast<size_t>(work_.grid.order);
  std::vector<Rgb> values(count * order);
  if (!divided_.has(leaf)) {
    const Element& element = work_.tree.builder().mesh().elements[surface_of(work_.tree, leaf).element];
    add_values(work_.grid, surpluses_, element.vertices[0], first, count, values.data());
    return values;
  }
  for (size_t i = 0; i < values.size(); ++i) values[i] = divided_.get(leaf, first * order + i);
  return values;
}

std::vector<Rgb> DirectOfLeaves::reflected(uint32_t leaf, uint32_t first, uint32_t count) const {
  std::vector<Rgb> values = irradiance(leaf, first, count);
  const Rgb brdf = surface_of(work_.tree, leaf).brdf;
  for (Rgb& value : values) value = brdf * value;
  return values;
}

}  // namespace strad
