#include "solve/gather/bounces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "solve/gather/final_gather.h"

namespace strad {
namespace {

constexpr float kTrusted = 0.4f;  // of the view of a leaf unblocked: from here on its own rays are enough

uint64_t sum_of(const std::vector<uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

// A patch that something stands on, and how much of it is seen at every time sample.
struct BlockedLeaf {
  uint32_t node;
  std::vector<float> unblocked;
};

// How far to believe in what a patch has, by how much of it is open: too few rays tell of a sliver.
float trust_in(float unblocked) {
  return std::clamp((unblocked - kLeastUnblocked) / (kTrusted - kLeastUnblocked), 0.0f, 1.0f);
}

// Gives slivers the radiance of what is open around them: the foot of a box sees little else.
void fill_blocked_leaves(const NodeTree& tree, const std::vector<BlockedLeaf>& blocked,
                         FunctionBlock* radiance) {
  const std::vector<Node>& nodes = tree.nodes();
  std::vector<const BlockedLeaf*> of_node(nodes.size(), nullptr);
  for (const BlockedLeaf& c : blocked) of_node[c.node] = &c;
  std::vector<std::vector<Rgb>> filled(blocked.size());
  parallel_for(blocked.size(), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const BlockedLeaf& own = blocked[i];
      std::vector<uint32_t> around, to_visit{nodes[own.node].parent};
      if (to_visit[0] == kNone || nodes[to_visit[0]].is_cluster()) continue;
      while (!to_visit.empty()) {
        const Node& node = nodes[to_visit.back()];
        const uint32_t index = to_visit.back();
        to_visit.pop_back();
        if (node.is_leaf() && index != own.node && radiance->has(index)) around.push_back(index);
        for (uint32_t c = 0; !node.is_leaf() && c < node.child_count; ++c)
          to_visit.push_back(node.first_child + c);
      }
      filled[i].resize(own.unblocked.size());
      for (size_t d = 0; d < own.unblocked.size(); ++d) {
        Rgb sum;
        float weights = 0;
        for (const uint32_t n : around) {
          const float weight = nodes[n].area * (of_node[n] ? trust_in(of_node[n]->unblocked[d]) : 1);
          sum += weight * radiance->get(n, d);
          weights += weight;
        }
        const float trust = weights > 0 ? trust_in(own.unblocked[d]) : 1;
        filled[i][d] = trust * radiance->get(own.node, d);
        if (trust < 1) filled[i][d] += ((1 - trust) / weights) * sum;
      }
    }
  });
  for (size_t i = 0; i < blocked.size(); ++i)
    for (size_t d = 0; d < filled[i].size(); ++d) radiance->set(blocked[i].node, d, filled[i][d]);
}

// One gather by rays over the radiance of all lights, in place: chunk after chunk, so that a chunk already
// sees the light of those before it and no second copy is held.
struct Bounce {
  uint64_t rays = 0;
  double direct = 0;  // of what is reflected now, in the units of total_of(): what was so for the first time
};
Bounce bounce(const Workspace& work, const DirectOfLeaves& direct, FunctionBlock* radiance) {
  constexpr size_t kChunk = 512;  // fixed: results must not depend on the number of threads
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, *radiance, kLeafRays);
  const std::vector<uint32_t>& leaves = radiance->rows();
  std::vector<uint64_t> rays(leaves.size(), 0);
  std::vector<double> reflected_direct(leaves.size(), 0.0);
  std::vector<std::vector<Rgb>> reflected(kChunk);
  std::vector<std::vector<float>> unblocked(kChunk);
  std::vector<BlockedLeaf> blocked;
  for (size_t first = 0; first < leaves.size(); first += kChunk) {
    const size_t count = std::min(kChunk, leaves.size() - first);
    parallel_for(count, 8, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const uint32_t leaf = leaves[first + i];
        const LeafSurface surface = surface_of(work.tree, leaf);
        GatheredFunction f = gather.over_leaf(leaf, &rays[first + i]);
        const std::vector<Rgb> from_direct = direct.irradiance(leaf, 0, work.grid.cell_count());
        reflected[i] = std::move(f.irradiance);
        unblocked[i] = std::move(f.unblocked);
        // Means over the leaf become means over what of it is exposed at that time sample.
        for (size_t d = 0; d < reflected[i].size(); ++d) {
          const Rgb brdf = (1 / std::max(unblocked[i][d], kLeastUnblocked)) * surface.brdf;
          const Rgb once = brdf * from_direct[d];
          reflected_direct[first + i] += surface.area * static_cast<double>(once.r + once.g + once.b);
          reflected[i][d] = once + brdf * reflected[i][d];
        }
      }
    });
    for (size_t i = 0; i < count; ++i) {
      const uint32_t leaf = leaves[first + i];
      for (size_t d = 0; d < reflected[i].size(); ++d) radiance->set(leaf, d, reflected[i][d]);
      if (leaf < work.tree.nodes().size() &&
          *std::min_element(unblocked[i].begin(), unblocked[i].end()) < kTrusted)
        blocked.push_back({leaf, std::move(unblocked[i])});
    }
  }
  fill_blocked_leaves(work.tree, blocked, radiance);
  return {sum_of(rays), std::accumulate(reflected_direct.begin(), reflected_direct.end(), 0.0)};
}

}  // namespace

uint64_t correct_by_bounces(const Workspace& work, const DirectOfLeaves& direct, FunctionBlock* radiance) {
  const Bounce first = bounce(work, direct, radiance);
  const double before = total_of(work.tree, *radiance);
  const Bounce second = bounce(work, direct, radiance);
  const double after = total_of(work.tree, *radiance);
  if (!(after > 0)) return first.rays + second.rays;
  // L = D + T L: the share of light that was reflected before is what a bounce multiplies errors by. Done in
  // place it does better, for leaves see ever more that was corrected: e' = f (e - e0) along the way.
  const double f = std::clamp(1 - second.direct / after, 1e-3, 0.95);
  const double factor = 1 - (1 - f) * std::expm1(f) / f;
  const auto scale = static_cast<float>(1 + (after - before) / after * factor / (1 - factor));
  for (const uint32_t leaf : radiance->rows())
    for (size_t d = 0; d < radiance->sample_count(); ++d)
      radiance->set(leaf, d, scale * radiance->get(leaf, d));
  return first.rays + second.rays;
}

}  // namespace strad
