#include "solve/gather/bounces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "solve/gather/final_gather.h"

namespace strad {
namespace {

constexpr int kMostRounds = 6;
constexpr int kLearningRounds = 2;    // after which rays go the same ways in every round
constexpr double kContraction = 0.2;  // the least that a round is expected to leave of an error
constexpr float kLeastShare = 0.67f;  // of radiance by rays that a correction along links may leave
constexpr float kTrusted = 0.4f;      // of the view of a leaf unblocked: from here on its own rays are enough

uint64_t sum_of(const std::vector<uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

// A patch that something stands on, and how much of it is seen at every time sample.
struct BlockedLeaf {
  uint32_t node;
  std::vector<float> unblocked;
};

// The weight of what the rays of a patch have found, by the share of the view that is unblocked: where little
// of the patch is exposed, few of its rays say anything.
float trust_in(float unblocked) {
  return std::clamp((unblocked - kLeastUnblocked) / (kTrusted - kLeastUnblocked), 0.0f, 1.0f);
}

// Gives patches with little exposed the radiance of the exposed patches around them.
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

// The noise of gathered light when direct light is added to it.
float noise_of_sum(const GatheredFunction& gathered, const std::vector<Rgb>& direct) {
  double gathered_sum = 0, direct_sum = 0;
  for (size_t d = 0; d < direct.size(); ++d) {
    gathered_sum += mean_channel(gathered.irradiance[d]);
    direct_sum += mean_channel(direct[d]);
  }
  const double all = gathered_sum + direct_sum;
  return all > 0 ? gathered.noise * static_cast<float>(gathered_sum / all) : 0;
}

// What the leaves reflect of direct light and of `radiance`, by one gather along rays.
FunctionBlock reflected_by_rays(const Workspace& work, const DirectOfLeaves& direct,
                                const FunctionBlock& radiance, double tolerance, Bounces* bounces) {
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, radiance, bounces->slopes,
                           bounces->guide, {work.leaf_rays, tolerance});
  const std::vector<uint32_t>& leaves = radiance.rows();
  FunctionBlock reflected(work.tree.leaf_count(), leaves, radiance.sample_count());
  std::vector<uint64_t> traced(leaves.size(), 0);
  std::vector<std::vector<float>> unblocked(leaves.size());
  std::vector<float> noise(leaves.size(), 0);
  const bool learns = bounces->rounds < kLearningRounds;
  std::vector<DirectionCounts> counts(learns ? work.tree.nodes().size() : 0);
  parallel_for(leaves.size(), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t leaf = leaves[i];
      const Rgb brdf = surface_of(work.tree, leaf).brdf;
      GatheredFunction f = gather.over_leaf(leaf, &traced[i], leaf < counts.size() ? &counts[leaf] : nullptr);
      const std::vector<Rgb> from_direct = direct.irradiance(leaf, 0, work.grid.cell_count());
      noise[i] = noise_of_sum(f, from_direct);
      for (size_t d = 0; d < f.irradiance.size(); ++d) {
        // Means over the leaf become means over what of it is exposed at that time sample.
        const float exposed = std::max(f.unblocked[d], kLeastUnblocked);
        reflected.set(leaf, d, (1 / exposed) * (brdf * (from_direct[d] + f.irradiance[d])));
      }
      if (leaf < work.tree.nodes().size() &&
          *std::min_element(f.unblocked.begin(), f.unblocked.end()) < kTrusted)
        unblocked[i] = std::move(f.unblocked);
    }
  });
  std::vector<BlockedLeaf> blocked;
  for (size_t i = 0; i < leaves.size(); ++i)
    if (!unblocked[i].empty()) blocked.push_back({leaves[i], std::move(unblocked[i])});
  fill_blocked_leaves(work.tree, blocked, &reflected);
  bounces->rays += sum_of(traced);
  if (learns) bounces->guide = DirectionGuide(work.tree, std::move(counts));
  bounces->slopes = LeafSlopes(work.tree, reflected, noise);
  return reflected;
}

// Adds to a bounce `next` of `radiance` what becomes of their difference along the links.
void add_residual(const Workspace& work, const FunctionBlock& radiance, const TransportInput& input,
                  FunctionBlock* next) {
  const LeafSource residual = [&](uint32_t leaf, uint32_t first_cell, uint32_t cells) {
    const auto order = static_cast<size_t>(work.grid.order);
    std::vector<Rgb> r(cells * order);
    for (size_t d = 0; d < r.size(); ++d)
      r[d] = next->get(leaf, first_cell * order + d) - radiance.get(leaf, first_cell * order + d);
    return r;
  };
  add_reflected(work, residual, input, kLeastShare, next);
}

// Rms over area of the change of the mean radiance of groups of leaves, each relative to its own.
double change_of_groups(const NodeTree& tree, const FunctionBlock& before, const FunctionBlock& after,
                        double least) {
  constexpr double kShare = 1.0 / 64;  // of all area, what a group grows up to
  const std::vector<Node>& nodes = tree.nodes();
  const std::vector<double> was = means_over_time(before), now = means_over_time(after);
  double all = 0;
  for (const Node& node : nodes)
    if (node.parent == kNone) all += node.area;
  std::vector<double> area(nodes.size(), 0), old_sum(nodes.size(), 0), new_sum(nodes.size(), 0);
  for (size_t i = 0; i < now.size(); ++i) {
    const uint32_t leaf = after.rows()[i];
    uint32_t n = leaf < nodes.size() ? leaf : tree.node_of_face(leaf - static_cast<uint32_t>(nodes.size()));
    while (nodes[n].parent != kNone && nodes[nodes[n].parent].area < kShare * all) n = nodes[n].parent;
    const double a = surface_of(tree, leaf).area;
    area[n] += a, old_sum[n] += a * was[i], new_sum[n] += a * now[i];
  }
  double sum = 0;
  for (size_t n = 0; n < nodes.size(); ++n) {
    if (!(area[n] > 0)) continue;
    const double change = (new_sum[n] - old_sum[n]) / std::max({new_sum[n], old_sum[n], least * area[n]});
    sum += area[n] * change * change;
  }
  return all > 0 ? std::sqrt(sum / all) : 0;
}

// Rms over area of the change of leaves, each relative to its own radiance, or to `least` if that is more.
double relative_change(const NodeTree& tree, const FunctionBlock& after, const std::vector<double>& before,
                       double least) {
  const std::vector<double> now = means_over_time(after);
  double sum = 0, area = 0;
  for (size_t i = 0; i < now.size(); ++i) {
    const double a = surface_of(tree, after.rows()[i]).area;
    const double change = (now[i] - before[i]) / std::max({now[i], before[i], least});
    sum += a * change * change;
    area += a;
  }
  return area > 0 ? std::sqrt(sum / area) : 0;
}

}  // namespace

Bounces correct_by_bounces(const Workspace& work, const DirectOfLeaves& direct, const TransportInput& input,
                           double error, FunctionBlock* radiance) {
  Bounces bounces;
  const double least = 1e-4 * mean_radiance(work.tree, *radiance);
  bool along_links = true;
  for (double last = 1; bounces.rounds < kMostRounds; last = bounces.change) {
    FunctionBlock next = reflected_by_rays(work, direct, *radiance, error / 2, &bounces);
    ++bounces.rounds;
    if (along_links) {
      const std::vector<double> before = means_over_time(next);
      add_residual(work, *radiance, input, &next);
      bounces.change = relative_change(work.tree, next, before, least);
    } else {
      bounces.change = change_of_groups(work.tree, *radiance, next, least);
    }
    *radiance = std::move(next);
    if (!along_links) {
      if (bounces.change < error / 2) break;
    } else if (bounces.change * std::min(1.0, std::max(bounces.change / last, kContraction)) < error / 8) {
      break;  // the next correction would be smaller by about as much as this one is than the last
    } else if (bounces.rounds > 1 && bounces.change > last / 2) {
      along_links = false;  // the links are too coarse to be of any more help
    }
  }
  return bounces;
}

}  // namespace strad
