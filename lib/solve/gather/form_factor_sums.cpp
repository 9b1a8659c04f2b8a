#include "solve/gather/form_factor_sums.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/rng.h"
#include "solve/gather/final_gather.h"

namespace strad {
namespace {

// What the rays of a leaf meet, as shares of all: surfaces that take part, and unlit ones. Where a node is
// partly covered (a box stands on it) the covered part sees only the unlit inside of what covers it.
struct View {
  float lit = 0, unlit = 0;
};

View view_of(const GatherSpace& space, const Receiver& receiver) {
  const std::vector<Pose>& poses = space.swept.cell_begin_poses(space.grid.cell_count() / 2);
  const Pose& pose = poses[receiver.body];
  int unlit = 0;
  float lit = 0;
  for (const RestRay& ray : rays_of(receiver, {}, receiver.rays, space.tracer.offset())) {
    Rgb passed{1, 1, 1};
    const uint32_t leaf = space.leaf_of(
        space.tracer.closest_through(poses, pose * ray.from, rotate(pose, ray.towards), &passed));
    unlit += leaf == kUnlit;
    if (leaf != kUnlit && leaf != kOpenView) lit += mean_channel(passed);
  }
  const auto all = static_cast<float>(receiver.rays);
  return {lit / all, static_cast<float>(unlit) / all};
}

View view_of(const GatherSpace& space, uint32_t n, int rays) {
  const Node& node = space.tree.nodes()[n];
  if (!node.is_cluster()) {
    Receiver receiver = receiver_of_patch(space.tree, n, rays);
    receiver.rays = rays;
    return view_of(space, receiver);
  }
  View mean;
  for (int s = 0; s < Cluster::kSamples; ++s) {
    const SurfaceSample& sample = space.tree.cluster(node).samples[s];
    Receiver receiver;
    receiver.position = sample.position;
    receiver.normal = sample.normal;
    receiver.body = node.body;
    receiver.seed = hash_of(n, 4, static_cast<uint64_t>(s));
    receiver.rays = std::max(1, rays / Cluster::kSamples);
    const View view = view_of(space, receiver);
    mean.lit += view.lit / Cluster::kSamples;
    mean.unlit += view.unlit / Cluster::kSamples;
  }
  return mean;
}

}  // namespace

std::vector<float> form_factor_sums_by_rays(const Workspace& work, uint64_t* rays) {
  const std::vector<Node>& nodes = work.tree.nodes();
  const GatherSpace space(work.tree, work.tracer, work.grid, work.swept);
  std::vector<float> form_factor_sums(nodes.size(), 1.0f);
  parallel_for(nodes.size(), 16, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) {
      if (!nodes[n].is_leaf()) continue;
      const View view = view_of(space, static_cast<uint32_t>(n), work.leaf_rays);
      form_factor_sums[n] = view.lit / std::max(1 - view.unlit, kLeastUnblocked);
    }
  });
  for (const Node& node : nodes)
    if (node.is_leaf()) *rays += static_cast<uint64_t>(work.leaf_rays);
  return form_factor_sums;
}

}  // namespace strad
