#include "solve/links/link_phase.h"

#include <algorithm>

#include "solve/links/divided_leaves.h"
#include "solve/links/refinement.h"

namespace strad {
namespace {

constexpr uint32_t kProbeSamples = 32;  // time samples at which the oracle knows the light
constexpr size_t kBlock = 8;            // of them, propagated together
// In the dark, links need only be right enough to tell rays where light comes from; bounces correct the rest.
constexpr double kLocalLooseness = 16;

std::vector<uint32_t> spread_samples(uint32_t count, uint32_t wanted) {
  std::vector<uint32_t> time_samples;
  const uint32_t n = std::min(count, wanted);
  for (uint32_t i = 0; i < n; ++i) time_samples.push_back(static_cast<uint32_t>((i + 0.5) * count / n));
  return time_samples;
}

// Propagates light at the probe samples, and gives it to the oracle, which weighs links by it.
void update(const TransportInput& input, const std::vector<uint32_t>& probe_samples, Refinement* refinement) {
  for (size_t first = 0; first < probe_samples.size(); first += kBlock) {
    const auto begin = probe_samples.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<uint32_t> block(
        begin, begin + static_cast<std::ptrdiff_t>(std::min(kBlock, probe_samples.size() - first)));
    refinement->update_light(first, block.size(), propagate(input, block, static_cast<uint32_t>(first)));
  }
}

}  // namespace

TransportInput input_of(const Workspace& work, const std::vector<Instant>& instants,
                        const RefinedLinks& links, double residual) {
  TransportInput input;
  input.grid = &work.grid;
  input.tree = &work.tree;
  input.links = &links.table;
  input.instants = &instants;
  input.reflections = &links.reflections;
  input.form_factor_sums = &links.form_factor_sums;
  input.residual = residual;
  return input;
}

RefinedLinks refine_links(const Workspace& work, const std::vector<Instant>& instants,
                          const LinkOptions& options, const DirectPhase& direct,
                          const FormFactorSums& form_factor_sums, NodeTree* tree) {
  const KernelEvaluator kernels(*tree, work.tracer, work.grid, work.swept);
  const std::vector<uint32_t> probe_samples = spread_samples(work.grid.sample_count(), kProbeSamples);
  RefinedLinks links;
  TransportInput input = input_of(work, instants, links, options.residual);
  Refinement refinement(work.grid, kernels, direct, probe_samples, tree);
  input.direct = [&](size_t slot, size_t probe) { return refinement.direct(slot, probe); };
  for (const double factor : {16.0, 4.0, 1.0}) {
    refinement.refine({factor * options.threshold, options.smallest_radius});
    links.table = make_link_table(work.grid, static_cast<uint32_t>(tree->nodes().size()), refinement.links());
    links.reflections = reflections_of(*tree);
    links.form_factor_sums = form_factor_sums(&links.form_factor_rays);
    update(input, probe_samples, &refinement);
    refinement.weigh_by_local_light(factor > 1 ? options.mean / kLocalLooseness : options.mean, options.dark);
  }
  divide_leaves(refinement, options.threshold, tree);
  const std::vector<Node>& nodes = tree->nodes();
  links.table = make_link_table(work.grid, static_cast<uint32_t>(nodes.size()), refinement.links());
  for (size_t n = links.form_factor_sums.size(); n < nodes.size(); ++n)
    links.form_factor_sums.push_back(links.form_factor_sums[nodes[n].parent]);
  links.count = refinement.links().size();
  links.counts = refinement.counts();
  return links;
}

}  // namespace strad
