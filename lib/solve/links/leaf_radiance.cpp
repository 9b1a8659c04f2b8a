#include "solve/links/leaf_radiance.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace strad {
namespace {

// Radiance that leaves reflect of direct light, at the time samples of some cells: [slot][time sample].
std::vector<Rgb> direct_of_slots(const Workspace& work, const DirectOfLeaves& direct, uint32_t first_cell,
                                 uint32_t cells) {
  const NodeTree& tree = work.tree;
  const size_t count = cells * static_cast<size_t>(work.grid.order);
  std::vector<Rgb> radiance(tree.slot_count() * count);
  const auto nodes = static_cast<uint32_t>(tree.nodes().size());
  for (uint32_t n = 0; n < nodes; ++n) {
    const Node& node = tree.nodes()[n];
    if (!node.is_leaf()) continue;
    const auto add = [&](const std::vector<Rgb>& irradiance, Rgb brdf, size_t slot) {
      for (size_t d = 0; d < count; ++d) radiance[slot * count + d] += brdf * irradiance[d];
    };
    if (!node.is_cluster()) {
      add(direct.irradiance(n, first_cell, cells), surface_of(tree, n).brdf, node.slot);
      continue;
    }
    const Cluster& cluster = tree.cluster(node);
    for (uint32_t i = cluster.first_face; i < cluster.first_face + cluster.face_count; ++i) {
      const uint32_t face = tree.cluster_faces()[i];
      const LobeWeights w = lobes_of_normal(tree.face_normal(face));
      const float share = static_cast<float>(tree.face_area(face)) / node.area;
      const std::vector<Rgb> irradiance = direct.irradiance(nodes + face, first_cell, cells);
      const Rgb brdf = surface_of(tree, nodes + face).brdf;
      for (int l = 0; l < 3; ++l)
        add(irradiance, (share * w.weight[l] / std::max(cluster.lobe_share[w.lobe[l]], 1e-20f)) * brdf,
            node.slot + static_cast<size_t>(w.lobe[l]));
    }
  }
  return radiance;
}

// Stores the radiance of the leaves at the time samples of a block, from the irradiance that links have
// carried.
void store_block(const Workspace& work, const DirectOfLeaves& direct, const NodeLight& light,
                 uint32_t first_cell, uint32_t cells, FunctionBlock* radiance) {
  const NodeTree& tree = work.tree;
  const auto order = static_cast<uint32_t>(work.grid.order);
  const size_t count = cells * static_cast<size_t>(order), first = first_cell * static_cast<size_t>(order);
  for (const uint32_t leaf : radiance->rows()) {
    if (leaf < tree.nodes().size()) {
      const size_t slot = tree.nodes()[leaf].slot;
      for (size_t d = 0; d < count; ++d) radiance->set(leaf, first + d, light.radiance[slot * count + d]);
      continue;
    }
    const uint32_t face = leaf - static_cast<uint32_t>(tree.nodes().size());
    const Node& cluster = tree.nodes()[tree.node_of_face(face)];
    const LobeWeights w = lobes_of_normal(tree.face_normal(face));
    std::vector<Rgb> e = direct.irradiance(leaf, first_cell, cells);
    for (int i = 0; i < 3; ++i) {
      const Rgb* from = &light.irradiance[(cluster.slot + static_cast<size_t>(w.lobe[i])) * count];
      for (size_t d = 0; d < count; ++d) e[d] += w.weight[i] * from[d];
    }
    const Rgb brdf = surface_of(tree, leaf).brdf;
    for (size_t d = 0; d < count; ++d) radiance->set(leaf, first + d, brdf * e[d]);
  }
}

}  // namespace

LeafRadiance propagate_to_leaves(const Workspace& work, const DirectOfLeaves& direct,
                                 const TransportInput& input) {
  constexpr uint32_t kBlock =
      12;  // time samples of a block: so few that the values of some thousand nodes fit in the cache
  const auto order = static_cast<uint32_t>(work.grid.order);
  const uint32_t cells = work.grid.cell_count(), block_cells = std::max(1u, kBlock / order);
  LeafRadiance result{FunctionBlock(work.tree.leaf_count(), leaves_of(work.tree), work.grid.sample_count())};
  const uint32_t blocks = (cells + block_cells - 1) / block_cells;
  std::vector<int> block_iterations(blocks);
  std::vector<double> block_residuals(blocks);
  parallel_for(blocks, 1, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      const uint32_t first = static_cast<uint32_t>(b) * block_cells;
      const uint32_t count = std::min(block_cells, cells - first);
      std::vector<uint32_t> time_samples(count * order);
      std::iota(time_samples.begin(), time_samples.end(), first * order);
      const std::vector<Rgb> from_direct = direct_of_slots(work, direct, first, count);
      TransportInput of_block = input;
      of_block.direct = [&](size_t slot, size_t i) { return from_direct[slot * time_samples.size() + i]; };
      const NodeLight light = propagate(of_block, time_samples, 0);
      block_iterations[b] = light.iterations;
      block_residuals[b] = light.residual;
      store_block(work, direct, light, first, count, &result.radiance);
    }
  });
  result.iterations = *std::max_element(block_iterations.begin(), block_iterations.end());
  result.residual = *std::max_element(block_residuals.begin(), block_residuals.end());
  return result;
}

}  // namespace strad
