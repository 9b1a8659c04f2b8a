#include "solve/links/link_light.h"

#include <malloc.h>

#include <algorithm>

#include "solve/links/refinement.h"

namespace strad {
namespace {

constexpr uint32_t kWatchedDates = 32;
constexpr size_t kBlock = 8;  // of watched dates, propagated together

std::vector<uint32_t> strided_dates(uint32_t count, uint32_t wanted) {
  std::vector<uint32_t> dates;
  const uint32_t n = std::min(count, wanted);
  for (uint32_t i = 0; i < n; ++i) dates.push_back(static_cast<uint32_t>((i + 0.5) * count / n));
  return dates;
}

// Light of the nodes at the watched dates goes back to the oracle, which weighs links by it.
void update(const TransportInput& input, const std::vector<uint32_t>& watched, Refinement* refinement) {
  for (size_t first = 0; first < watched.size(); first += kBlock) {
    const auto begin = watched.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<uint32_t> block(
        begin, begin + static_cast<std::ptrdiff_t>(std::min(kBlock, watched.size() - first)));
    refinement->update_radiance(first, block.size(),
                                propagate(input, block, static_cast<uint32_t>(first)).radiance);
  }
}

}  // namespace

LinkLight light_along_links(const Workspace& work, const std::vector<Instant>& instants,
                            const LinkLightOptions& options, NodeTree* tree, DirectPhase* direct, Field* kept,
                            SolveStats* stats) {
  const KernelEvaluator kernels(*tree, work.tracer, work.grid, work.swept);
  const std::vector<uint32_t> watched = strided_dates(work.grid.node_count(), kWatchedDates);
  LinkTable table;
  std::vector<ClusterReflection> reflections;
  std::vector<float> openness;
  TransportInput input;
  input.grid = &work.grid;
  input.tree = tree;
  input.links = &table;
  input.instants = &instants;
  input.reflections = &reflections;
  input.openness = &openness;
  input.residual = options.residual;
  {
    Refinement refinement(work.grid, kernels, *direct, watched, tree);
    input.direct = [&](size_t slot, size_t date) { return refinement.direct(slot, date); };
    for (const double looseness : {16.0, 4.0, 1.0}) {
      refinement.refine({looseness * options.threshold, options.smallest_radius});
      table = make_link_table(work.grid, static_cast<uint32_t>(tree->nodes().size()), refinement.links());
      reflections = reflections_of(*tree);
      openness = openness_of(work, &stats->indirect.rays);
      if (looseness > 1) update(input, watched, &refinement);
    }
    const RefinementCounts& counts = refinement.counts();
    stats->indirect.rays += counts.rays;
    stats->indirect.links = refinement.links().size();
    stats->indirect.links_refined_in_time = counts.refined_in_time;
    stats->indirect.links_refined_in_space = counts.refined_in_space;
    stats->indirect.kernel_evaluations = counts.evaluations;
    stats->link_bytes = refinement.links().size() * sizeof(Link);
    stats->clusters = tree->cluster_count();
  }
  DirectOfLights of_lights(work, *direct, *kept);
  *kept = direct->surpluses();
  malloc_trim(0);  // many small functions were freed: give their pages back before the lights take theirs
  return {propagate_all(work, of_lights, input, &stats->iterations, &stats->residual), std::move(of_lights)};
}

}  // namespace strad
