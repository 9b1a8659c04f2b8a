#include "solve/links/leaf_radiance.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace strad {
namespace {

// What the source sends out, as a mean over holes and all, at the time samples of some cells, by slot:
// [slot][time sample].
std::vector<Rgb> source_of_slots(const Workspace& work, const LeafSource& source, uint32_t first_cell,
                                 uint32_t cells) {
  const NodeTree& tree = work.tree;
  const size_t count = cells * static_cast<size_t>(work.grid.order);
  std::vector<Rgb> radiance(tree.slot_count() * count);
  const auto nodes = static_cast<uint32_t>(tree.nodes().size());
  for (uint32_t n = 0; n < nodes; ++n) {
    const Node& node = tree.nodes()[n];
    if (!node.is_leaf()) continue;
    const auto add = [&](const std::vector<Rgb>& from, float weight, size_t slot) {
      for (size_t d = 0; d < count; ++d) radiance[slot * count + d] += weight * from[d];
    };
    if (!node.is_cluster()) {
      add(source(n, first_cell, cells), node.coverage, node.slot);
      continue;
    }
    const Cluster& cluster = tree.cluster(node);
    for (uint32_t i = cluster.first_face; i < cluster.first_face + cluster.face_count; ++i) {
      const uint32_t face = tree.cluster_faces()[i];
      const LobeWeights w = lobes_of_normal(tree.face_normal(face));
      const float share = static_cast<float>(tree.face_area(face)) * tree.face_coverage(face) / node.area;
      const std::vector<Rgb> from = source(nodes + face, first_cell, cells);
      for (int l = 0; l < 3; ++l)
        add(from, share * w.weight[l] / std::max(cluster.lobe_share[w.lobe[l]], 1e-20f),
            node.slot + static_cast<size_t>(w.lobe[l]));
    }
  }
  return radiance;
}

// Adds what the leaves reflect of the light that links brought at the time samples of a block.
void add_block(const Workspace& work, const NodeLight& light, uint32_t first_cell, uint32_t cells,
               float at_least, FunctionBlock* radiance) {
  const NodeTree& tree = work.tree;
  const auto order = static_cast<uint32_t>(work.grid.order);
  const size_t count = cells * static_cast<size_t>(order), first = first_cell * static_cast<size_t>(order);
  std::vector<Rgb> irradiance(count);
  for (const uint32_t leaf : radiance->rows()) {
    if (leaf < tree.nodes().size()) {
      const Rgb* from = &light.irradiance[tree.nodes()[leaf].slot * count];
      irradiance.assign(from, from + count);
    } else {
      const uint32_t face = leaf - static_cast<uint32_t>(tree.nodes().size());
      const Node& cluster = tree.nodes()[tree.node_of_face(face)];
      const LobeWeights w = lobes_of_normal(tree.face_normal(face));
      std::fill(irradiance.begin(), irradiance.end(), Rgb{});
      for (int i = 0; i < 3; ++i) {
        const Rgb* from = &light.irradiance[(cluster.slot + static_cast<size_t>(w.lobe[i])) * count];
        for (size_t d = 0; d < count; ++d) irradiance[d] += w.weight[i] * from[d];
      }
    }
    const Rgb brdf = surface_of(tree, leaf).brdf;
    for (size_t d = 0; d < count; ++d) {
      const Rgb before = radiance->get(leaf, first + d), reflected = brdf * irradiance[d];
      Rgb after = before + reflected;
      if (at_least < 1)
        for (int c = 0; c < 3; ++c)
          after[c] = std::clamp(after[c], at_least * before[c], before[c] / at_least);
      radiance->set(leaf, first + d, after);
    }
  }
}

}  // namespace

void set_to_source(const Workspace& work, const LeafSource& source, FunctionBlock* radiance) {
  const std::vector<uint32_t>& leaves = radiance->rows();
  parallel_for(leaves.size(), 64, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::vector<Rgb> values = source(leaves[i], 0, work.grid.cell_count());
      for (size_t d = 0; d < values.size(); ++d) radiance->set(leaves[i], d, values[d]);
    }
  });
}

Propagation add_reflected(const Workspace& work, const LeafSource& source, const TransportInput& input,
                          float at_least, FunctionBlock* radiance) {
  constexpr uint32_t kBlock =
      12;  // time samples of a block: so few that the values of some thousand nodes fit in the cache
  const auto order = static_cast<uint32_t>(work.grid.order);
  const uint32_t cells = work.grid.cell_count(), block_cells = std::max(1u, kBlock / order);
  const uint32_t blocks = (cells + block_cells - 1) / block_cells;
  std::vector<Propagation> of_blocks(blocks);
  parallel_for(blocks, 1, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      const uint32_t first = static_cast<uint32_t>(b) * block_cells;
      const uint32_t count = std::min(block_cells, cells - first);
      std::vector<uint32_t> time_samples(count * order);
      std::iota(time_samples.begin(), time_samples.end(), first * order);
      const std::vector<Rgb> of_slots = source_of_slots(work, source, first, count);
      TransportInput of_block = input;
      of_block.direct = [&](size_t slot, size_t i) { return of_slots[slot * time_samples.size() + i]; };
      const NodeLight light = propagate(of_block, time_samples, 0);
      of_blocks[b] = {light.iterations, light.residual};
      add_block(work, light, first, count, at_least, radiance);
    }
  });
  Propagation all;
  for (const Propagation& block : of_blocks)
    all = {std::max(all.iterations, block.iterations), std::max(all.residual, block.residual)};
  return all;
}

}  // namespace strad
