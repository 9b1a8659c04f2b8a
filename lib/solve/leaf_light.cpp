#include "solve/leaf_light.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "solve/final_gather.h"

namespace strad {
namespace {

constexpr int kLeafRays = 128;  // a leaf's noise of some 5 % is averaged over the hundreds that a point sees

constexpr float kLeastOpen = 0.2f;  // a leaf more covered than this is all but unseen

uint64_t sum_of(const std::vector<uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

double total_of(const NodeTree& tree, const LeafFunctions& radiance) {
  double total = 0;
  for (size_t n = 0; n < radiance.size(); ++n) {
    double of_node = 0;
    for (const Rgb& l : radiance[n]) of_node += l.r + l.g + l.b;
    total += tree.nodes()[n].area * of_node;
  }
  return total;
}

// One gather by rays over the radiance of all leaves, in place: chunk after chunk, so that a chunk already
// sees the light of those before it and no second copy is held. Returns the rays traced.
uint64_t bounce(const Workspace& work, const PackedLeafFunctions& direct, LeafFunctions* radiance) {
  constexpr size_t kChunk = 512;  // fixed: results must not depend on the number of threads
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, *radiance, kLeafRays);
  std::vector<uint64_t> rays(radiance->size(), 0);
  LeafFunctions reflected(kChunk);
  for (size_t first = 0; first < radiance->size(); first += kChunk) {
    const size_t count = std::min(kChunk, radiance->size() - first);
    parallel_for(count, 8, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const size_t n = first + i;
        if ((*radiance)[n].empty()) continue;
        const Rgb brdf = static_cast<float>(1 / kPi) * work.tree.nodes()[n].reflectance;
        GatheredFunction f = gather.over_node(static_cast<uint32_t>(n), &rays[n]);
        reflected[i] = std::move(f.irradiance);
        // Means over the leaf become means over what of it is exposed at that date.
        for (size_t d = 0; d < reflected[i].size(); ++d)
          reflected[i][d] = (1 / std::max(f.open[d], kLeastOpen)) * brdf * (direct[n][d] + reflected[i][d]);
      }
    });
    for (size_t i = 0; i < count; ++i)
      if (!(*radiance)[first + i].empty()) (*radiance)[first + i].swap(reflected[i]);
  }
  return sum_of(rays);
}

}  // namespace

Views views_of(const Workspace& work, uint64_t* rays) {
  const std::vector<Node>& nodes = work.tree.nodes();
  const LeafFunctions lit(nodes.size(), std::vector<Rgb>(1));
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, lit, kLeafRays);
  Views views;
  for (std::vector<float>* v : {&views.row_sums, &views.column_sums}) v->assign(nodes.size(), 1.0f);
  std::vector<uint64_t> counts(nodes.size(), 0);
  parallel_for(nodes.size(), 16, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) {
      if (nodes[n].first_child != kNone) continue;
      const FinalGather::View view = gather.view_of(static_cast<uint32_t>(n), &counts[n]);
      views.row_sums[n] = view.lit / std::max(1 - view.dead, kLeastOpen);  // of the exposed part
      views.column_sums[n] = view.lit;
    }
  });
  *rays += sum_of(counts);
  return views;
}

PackedLeafFunctions direct_of_leaves(const Workspace& work, const DirectPhase& phase) {
  std::vector<uint32_t> all_cells(work.grid.cell_count());
  std::iota(all_cells.begin(), all_cells.end(), 0u);
  const std::vector<Node>& nodes = work.tree.nodes();
  PackedLeafFunctions direct(nodes.size());
  parallel_for(direct.size(), 8, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) {
      if (nodes[n].first_child != kNone) continue;
      direct[n] = PackedFunction(phase.mean_irradiance(nodes[n].element, all_cells));
    }
  });
  return direct;
}

TransportResult propagate_all(const TransportInput& input, LeafFunctions* radiance) {
  constexpr uint32_t kBlock = 24;  // dates: the working set of some thousand nodes stays in the cache
  const uint32_t dates = input.grid->node_count();
  const uint32_t blocks = (dates + kBlock - 1) / kBlock;
  const std::vector<Node>& nodes = input.tree->nodes();
  radiance->assign(nodes.size(), {});
  for (size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].first_child == kNone) (*radiance)[n].resize(dates);
  std::vector<TransportResult> results(blocks);
  parallel_for(blocks, 1, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      const uint32_t first = static_cast<uint32_t>(b) * kBlock;
      std::vector<uint32_t> block(std::min(kBlock, dates - first));
      std::iota(block.begin(), block.end(), first);
      std::vector<Rgb> of_block;
      results[b] = propagate(input, block, first, &of_block);
      for (size_t n = 0; n < nodes.size(); ++n)
        if (nodes[n].first_child == kNone)
          std::copy_n(of_block.begin() + static_cast<ptrdiff_t>(n * block.size()), block.size(),
                      (*radiance)[n].begin() + first);
    }
  });
  TransportResult worst;
  for (const TransportResult& r : results) {
    worst.iterations = std::max(worst.iterations, r.iterations);
    worst.residual = std::max(worst.residual, r.residual);
  }
  return worst;
}

double mean_radiance(const NodeTree& tree, const LeafFunctions& radiance) {
  double sum = 0, area = 0;
  for (size_t n = 0; n < radiance.size(); ++n) {
    double of_node = 0;
    for (const Rgb& l : radiance[n]) of_node += (l.r + l.g + l.b) / 3;
    if (!(of_node > 0)) continue;
    sum += tree.nodes()[n].area * of_node / static_cast<double>(radiance[n].size());
    area += tree.nodes()[n].area;
  }
  return area > 0 ? sum / area : 0;
}

uint64_t settle_by_rays(const Workspace& work, const PackedLeafFunctions& direct, LeafFunctions* radiance) {
  constexpr int kBounces = 2;
  uint64_t rays = 0;
  double totals[kBounces + 1] = {total_of(work.tree, *radiance)};
  for (int b = 1; b <= kBounces; ++b) {
    rays += bounce(work, direct, radiance);
    totals[b] = total_of(work.tree, *radiance);
  }
  const double first = totals[kBounces - 1] - totals[kBounces - 2];
  const double second = totals[kBounces] - totals[kBounces - 1];
  const double factor = first != 0 ? std::clamp(second / first, 0.0, 0.8) : 0;
  const double limit = totals[kBounces] + second * factor / (1 - factor);
  const auto scale = static_cast<float>(totals[kBounces] > 0 ? limit / totals[kBounces] : 1);
  for (std::vector<Rgb>& of_leaf : *radiance)
    for (Rgb& l : of_leaf) l = scale * l;
  return rays;
}

}  // namespace strad
