// Which links the oracle makes between clusters: every exchange once, and far fewer than between surfaces.
#include <gtest/gtest.h>

#include <map>

#include "base/rng.h"
#include "refined.h"

namespace strad {
namespace {

// A room with n^3 boxes at rest in its air, a spotlight that sweeps over them, and a few boxes that pass
// beside them.
Scene boxes_in_a_room(int n) {
  Scene scene;
  scene.end = 8;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  add_boxes(&scene, {0.5, 1.5, 0.5}, {2, 2.8, 1.5}, n, 0.4);
  add_boxes(&scene, {0.4, 0.3, 0.6}, {1, 0.9, 1.2}, 2, 0.9, add_body(&scene, {2, 0, 0}));
  add_spot(&scene, {2, 1.5, 1.9}, {1, 1, 0}, 0.6, 0.8, {10, 10, 10});
  scene.spots[0].keys.push_back({8, {2, 1.5, 1.9}, {3, 2, 0}, {10, 10, 10}});
  return scene;
}

struct Exchange {
  uint32_t receiver, emitter;
  auto operator<=>(const Exchange&) const = default;
};

// All links by their ends.
std::map<Exchange, std::vector<Interval>> by_ends(const Refined& refined) {
  std::map<Exchange, std::vector<Interval>> links;
  for (const Link& link : refined.links()) links[{link.receiver, link.emitter}].push_back(link.interval);
  return links;
}

std::vector<uint32_t> with_ancestors(const NodeTree& tree, uint32_t node) {
  std::vector<uint32_t> all;
  for (; node != kNone; node = tree.nodes()[node].parent) all.push_back(node);
  return all;
}

// How many links carry light from leaf q to leaf p in a cell.
int links_over(const Refined& refined, const std::map<Exchange, std::vector<Interval>>& links, uint32_t p,
               uint32_t q, uint32_t cell) {
  int count = 0;
  for (const uint32_t a : with_ancestors(*refined.bench.nodes, p))
    for (const uint32_t b : with_ancestors(*refined.bench.nodes, q)) {
      const auto found = links.find({a, b});
      if (found == links.end()) continue;
      for (const Interval& i : found->second) count += cell >= i.cell && cell < i.cell + i.cell_count();
    }
  return count;
}

// A leaf's side as seen by rays: some points and normals, rest.
std::vector<SurfaceSample> points_of(const Workbench& bench, uint32_t leaf) {
  const Node& node = bench.node(leaf);
  if (node.is_cluster())
    return {bench.cluster(leaf).samples, bench.cluster(leaf).samples + Cluster::kSamples};
  std::vector<SurfaceSample> points;
  const PatchPoints patch = patch_points(*bench.nodes, node);
  for (int i = 0; i < 16; ++i)
    points.push_back({point_on_patch(patch, (i % 4 + 0.5) / 4, (i / 4 + 0.5) / 4), node.normal});
  return points;
}

// Mean irradiance at leaf p from leaf q of unit radiance at the middle of a cell.
double exchange(const Workbench& bench, uint32_t p, uint32_t q, uint32_t cell) {
  const std::vector<Pose> poses = bench.swept.poses({cell, 0}, 0.5);
  const Pose &pose_p = poses[bench.node(p).body], &pose_q = poses[bench.node(q).body];
  const double part = static_cast<double>(bench.node(q).area) / 16;
  double sum = 0;
  for (const SurfaceSample& a : points_of(bench, p))
    for (const SurfaceSample& b : points_of(bench, q)) {
      const Vec3 x = pose_p * a.position, y = pose_q * b.position, to = y - x;
      const Vec3 normal_x = rotate(pose_p, a.normal), normal_y = rotate(pose_q, b.normal);
      const double d2 = length2(to), cosines = dot(to, normal_x) * -dot(to, normal_y);
      if (!(dot(to, normal_x) > 1e-9) || !(cosines > 0)) continue;
      const double offset = bench.tracer.offset();
      if (bench.tracer.occluded(poses, x + offset * normal_x, y + offset * normal_y)) continue;
      sum += cosines * part / (d2 * (d2 + part / kPi));
    }
  return sum / 16;
}

// All surfaces are lit, so that no link waits for light.
struct AllLit : Refined {
  AllLit() : Refined(boxes_in_a_room(4), Roots::kClusters, {0.02}) {
    for (const double threshold : {0.01, 0.004}) {
      light_all(0.5f);
      refine(threshold);
    }
    by = by_ends(*this);
    for (uint32_t n = 0; n < bench.nodes->nodes().size(); ++n)
      if (bench.node(n).is_leaf()) leaves.push_back(n);
  }
  std::map<Exchange, std::vector<Interval>> by;
  std::vector<uint32_t> leaves;
};

// Pairs of leaves far apart and near by, at any time sample.
TEST(ClusterRefinement, EveryExchangeIsLinkedOnceAtATime) {
  const AllLit refined;
  const Workbench& bench = refined.bench;
  int twice = 0, linked = 0, of_clusters = 0;
  for (const bool near : {false, true}) {
    double lost = 0, all = 0;
    for (uint64_t i = 0; i < 10000; ++i) {
      const auto random = [&](uint64_t k, size_t below) {
        return static_cast<size_t>(unit_from(hash_of(i, k, near)) * static_cast<double>(below));
      };
      const size_t first = random(1, refined.leaves.size());
      const size_t second = near ? std::min(refined.leaves.size() - 1, first + random(2, 12))
                                 : random(2, refined.leaves.size());
      const uint32_t p = refined.leaves[first], q = refined.leaves[second];
      const auto cell = static_cast<uint32_t>(random(3, 16));
      const int count = links_over(refined, refined.by, p, q, cell);
      twice += count > 1;
      linked += count == 1;
      of_clusters += count == 1 && bench.node(p).is_cluster();
      if (count != 0 && i % 4 != 0) continue;
      const double flux = static_cast<double>(bench.node(p).area) * exchange(bench, p, q, cell);
      all += count != 0 ? 4 * flux : flux;
      if (count == 0) lost += flux;
    }
    EXPECT_LT(lost, 0.01 * all) << near;  // links were dropped only where nothing is seen
  }
  EXPECT_EQ(twice, 0);
  EXPECT_GT(linked, 3000);
  EXPECT_GT(of_clusters, 100);
}

// Of a leaf cluster and itself: once, through itself or an ancestor and itself.
TEST(ClusterRefinement, ClustersLightThemselvesOnce) {
  const AllLit refined;
  int own = 0;
  for (const uint32_t n : refined.leaves) {
    const int count = links_over(refined, refined.by, n, n, 5);
    EXPECT_LE(count, 1) << n;
    if (!refined.bench.node(n).is_cluster() || !(exchange(refined.bench, n, n, 5) > 1e-3)) continue;
    EXPECT_EQ(count, 1) << n;
    ++own;
  }
  EXPECT_GT(own, 1);
  for (const auto& [ends, intervals] : refined.by)
    EXPECT_TRUE(ends.receiver != ends.emitter || refined.bench.node(ends.receiver).is_cluster());
}

TEST(ClusterRefinement, ClustersNeedFewerLinks) {
  size_t last[2] = {0, 0};
  for (const int n : {2, 4}) {
    const Refined clusters(boxes_in_a_room(n), Roots::kClusters, {0.005});
    const Refined surfaces(boxes_in_a_room(n), Roots::kFaces, {0.005});
    EXPECT_LT(clusters.links().size(), surfaces.links().size()) << n;
    if (n == 2) {
      last[0] = clusters.links().size(), last[1] = surfaces.links().size();
      continue;
    }
    // Eight times the boxes: the links of surfaces grow nearly with the square of the polygons, those of
    // clusters far less.
    EXPECT_LT(clusters.links().size() * last[1], surfaces.links().size() * last[0]);
    EXPECT_LT(3 * clusters.links().size(), surfaces.links().size());
  }
}

TEST(ClusterRefinement, ChildrenAppearOnlyWhereTheyAreWanted) {
  const Refined coarse(boxes_in_a_room(4), Roots::kClusters, {1e3});
  EXPECT_EQ(coarse.bench.nodes->nodes().size(), 2u);
  const Refined finer(boxes_in_a_room(4), Roots::kClusters, {0.01});
  const Refined finest(boxes_in_a_room(4), Roots::kClusters, {0.002});
  EXPECT_GT(finer.bench.nodes->nodes().size(), 50u);
  EXPECT_GT(finest.bench.nodes->nodes().size(), finer.bench.nodes->nodes().size());
}

// What lies at rest is linked once for all time, clusters too, unless the movers may come between.
TEST(ClusterRefinement, NothingIsSplitInTimeWhileNothingMoves) {
  Scene scene = boxes_in_a_room(3);
  scene.bodies[1].keys = {};
  const Refined still(scene, Roots::kClusters, {0.005});
  for (const Link& link : still.links()) {
    EXPECT_FALSE(link.estimate.dynamic);
    EXPECT_EQ(link.interval, still.bench.always());
  }
  EXPECT_EQ(still.refinement->counts().refined_in_time, 0u);
  const Refined moving(boxes_in_a_room(3), Roots::kClusters, {0.0005});
  EXPECT_GT(moving.refinement->counts().refined_in_time, 0u);
}

// Uniform faces are never split, whatever the threshold.
TEST(ClusterRefinement, UniformFacesStayWhole) {
  Refined refined(boxes_in_a_room(3), Roots::kClusters, {}, 0.5);
  refined.refine(0.01, 0.02);
  refined.light_all(0.5f);
  refined.refine(0.001, 0.02);
  int uniform = 0, split = 0;
  for (const Node& node : refined.bench.nodes->nodes()) {
    if (node.is_cluster()) continue;
    split += !node.is_leaf();
    if (!is_uniform(refined.bench.builder.mesh().elements[node.element])) continue;
    ++uniform;
    EXPECT_TRUE(node.is_leaf());
    EXPECT_EQ(refined.bench.builder.mesh().elements[node.element].first_child, kNone);
  }
  EXPECT_GT(uniform, 20);
  EXPECT_GT(split, 0);
}

}  // namespace
}  // namespace strad
