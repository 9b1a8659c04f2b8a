// Propagation along links of clusters: what they give and take is what their surfaces do.
#include <gtest/gtest.h>

#include "base/rng.h"
#include "solve/links/transport.h"
#include "transport_bench.h"

namespace strad {
namespace {

// Body 0: a square that looks up at what hangs above it on body 1: boxes and a tilted plate, reflecting
// `rho`.
Scene square_below_things(Rgb rho = {0.5f, 0.5f, 0.5f}) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0, {0.5f, 0.5f, 0.5f});
  const uint32_t body = add_body(&scene, {});
  add_boxes(&scene, {3, 0, 4}, {4, 1, 5}, 2, 0.6, body, rho);
  add_parts(&scene, {3, 0, 3}, {1, 0, 0.7}, {0, -1, 0.4}, 3, body, rho);
  return scene;
}

struct Things : Workbench {
  Things() : Workbench(square_below_things(), 1, 1, Roots::kClusters) {
    square = children_of(0)[0];
    split_clusters();
    leaves = leaves_below(*nodes, things);
  }
  uint32_t square = 0;
  static constexpr uint32_t things = 1;  // the root of body 1
  std::vector<uint32_t> leaves;
};

double area_mean(const Things& bench, const std::function<double(uint32_t)>& value) {
  double sum = 0, area = 0;
  for (const uint32_t leaf : bench.leaves) {
    sum += static_cast<double>(bench.node(leaf).area) * value(leaf);
    area += static_cast<double>(bench.node(leaf).area);
  }
  return sum / area;
}

// What a link gives to a cluster is shared among its surfaces without loss, more to those that face the
// light.
TEST(ClusterTransport, PushConservesTheMean) {
  const Things bench;
  Transport transport(bench, {link_of(Things::things, bench.square, bench.always(), {2.0f})});
  const size_t lit = bench.node(bench.square).slot;
  const NodeLight light = transport.solve([&](size_t slot) { return slot == lit ? Rgb{1, 3, 0} : Rgb{}; });
  EXPECT_NEAR(area_mean(bench, [&](uint32_t leaf) { return transport.irradiance(light, leaf).r; }), 2, 2e-5);
  EXPECT_NEAR(area_mean(bench, [&](uint32_t leaf) { return transport.irradiance(light, leaf).g; }), 6, 6e-5);
  const Vec3 towards = bench.node(bench.square).centre - bench.node(Things::things).centre;
  for (const uint32_t leaf : bench.leaves) {
    const Vec3 n = bench.node(leaf).normal;
    const bool along_axis = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) > 0.999;
    const float e = transport.irradiance(light, leaf).r;
    if (along_axis && dot(n, towards) < 0) {
      EXPECT_EQ(e, 0) << leaf;
    }
    if (dot(n, towards) > 0) {
      EXPECT_GT(e, 0) << leaf;
    }
  }
}

// A cluster shows the mean radiance of its surfaces by the area that each shows; over all directions the mean
// by area. With one colour of radiance all over, any direction shows just that.
TEST(ClusterTransport, PullConservesTheMean) {
  const Things bench;
  Transport transport(bench, {link_of(bench.square, Things::things, bench.always(), {1.5f})});
  const auto value = [&](uint32_t leaf) { return 0.5 + unit_from(hash_of(leaf)); };
  std::vector<float> of_slot(bench.nodes->slot_count(), 0.0f);
  for (const uint32_t leaf : bench.leaves) of_slot[bench.node(leaf).slot] = static_cast<float>(value(leaf));
  const NodeLight light = transport.solve([&](size_t slot) { return Rgb{of_slot[slot], 0.25f, 0}; });
  EXPECT_NEAR(transport.mean_radiance(light, Things::things).r, area_mean(bench, value), 1e-5);
  EXPECT_NEAR(transport.mean_radiance(light, Things::things).g, 0.25, 1e-5);
  // Each lobe's part of a surface shows by its component of the direction.
  const Vec3 towards = bench.node(bench.square).centre - bench.node(Things::things).centre;
  double seen = 0, shown = 0;
  for (const uint32_t leaf : bench.leaves)
    for (int axis = 0; axis < 3; ++axis) {
      const double n = bench.node(leaf).normal[axis];
      if (n * towards[axis] <= 0) continue;
      const double part = static_cast<double>(bench.node(leaf).area) * n * n * std::abs(towards[axis]);
      seen += part * value(leaf), shown += part;
    }
  EXPECT_NEAR(transport.irradiance(light, bench.square).r, 1.5 * seen / shown, 1e-4);
  EXPECT_NEAR(transport.irradiance(light, bench.square).g, 1.5 * 0.25, 1e-5);
}

// A leaf cluster reflects what its patches would, had it been split: the same light leaves in all.
TEST(ClusterTransport, ALeafClusterReflectsAsItsSurfacesDo) {
  Workbench whole(square_below_things({0.8f, 0.2f, 0}), 1, 1, Roots::kClusters);
  Workbench split(square_below_things({0.8f, 0.2f, 0}), 1, 1, Roots::kClusters);
  split.split_clusters();
  const auto reflected = [](Workbench* bench) {
    const uint32_t square = bench->children_of(0)[0];
    Transport transport(*bench, {link_of(1, square, bench->always(), {2.0f})});
    const size_t lit = bench->node(square).slot;
    return transport.mean_radiance(transport.solve([&](size_t slot) {
      return slot == lit ? Rgb{1, 1, 1} : Rgb{};
    }),
                                   1);
  };
  const Rgb a = reflected(&whole), b = reflected(&split);
  EXPECT_NEAR(a.r, 0.8 / kPi * 2, 1e-5);
  EXPECT_NEAR(a.r, b.r, 1e-5);
  EXPECT_NEAR(a.g, b.g, 1e-5);
  EXPECT_EQ(a.b, 0);
}

// A cluster that turns: its lit side is that which faces the light at each time sample, in its own frame.
TEST(ClusterTransport, ATurningClusterIsLitFromWhereTheLightIs) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{10, -0.5, -0.5}, {10, -0.5, 0.5}, {10, 0.5, 0.5}, {10, 0.5, -0.5}});
  add_box(&scene, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, false, add_body(&scene, {}, kPi, {0, 0, 1}));
  Workbench bench(scene, 1, 16, Roots::kClusters);
  const uint32_t square = bench.children_of(0)[0];
  Transport transport(bench, {link_of(1, square, bench.always(), {1, 1})});
  const size_t lit = bench.node(square).slot;
  const NodeLight light = transport.solve([&](size_t slot) { return slot == lit ? Rgb{1, 1, 1} : Rgb{}; });
  for (uint32_t time_sample = 0; time_sample < bench.grid.sample_count(); ++time_sample) {
    // In the box's frame the square goes from +x by -y (the box turns the other way) to -x; each side of six
    // gets its cosine's share.
    const double angle = kPi * sample_time(bench.grid, time_sample),
                 all = std::abs(std::cos(angle)) + std::sin(angle);
    const double east = 6 * std::max(0.0, std::cos(angle)) / all,
                 west = 6 * std::max(0.0, -std::cos(angle)) / all;
    EXPECT_NEAR(transport.irradiance(light, 1, time_sample, 0).r, east, 1e-3) << time_sample;
    EXPECT_NEAR(transport.irradiance(light, 1, time_sample, 1).r, west, 1e-3) << time_sample;
    EXPECT_NEAR(transport.irradiance(light, 1, time_sample, 3).r, 6 * std::sin(angle) / all, 1e-3)
        << time_sample;
    EXPECT_EQ(transport.irradiance(light, 1, time_sample, 2).r, 0) << time_sample;
  }
}

// Estimates and gathers look at as many points of a cluster as of any other.
TEST(ClusterTransport, ALinkCostsTheSameForAnyNumberOfFaces) {
  uint64_t few = 0;
  for (const int n : {1, 2, 6}) {
    Scene scene;
    scene.end = 1;
    add_boxes(&scene, {0, 0, 0}, {1, 1, 1}, n, 0.7);
    add_boxes(&scene, {3, 0, 0}, {4, 1, 1}, n, 0.7, add_body(&scene, {}));
    const Workbench bench(scene, 1, 1, Roots::kClusters);
    KernelCounts counts;
    const KernelEstimate e = bench.kernels->estimate(0, 1, bench.always(), &counts);
    EXPECT_GT(e.kernel[0], 0);
    if (n == 1) few = counts.evaluations;
    EXPECT_EQ(counts.evaluations, few);
    EXPECT_LE(counts.rays, 4u * Cluster::kSamples);
    EXPECT_EQ(make_link_table(bench.grid, 2, {{0, 1, bench.always(), e}}).still.size(), 1u);
  }
}

// However wrong the kernels between two clusters that show each other next to nothing, bounces die away.
TEST(ClusterTransport, BouncesDieAwayHoweverCoarseTheLinks) {
  Scene scene;
  scene.end = 1;
  add_boxes(&scene, {0, 0, 0}, {1, 1, 0.01}, 1, 0.8);
  add_boxes(&scene, {3, 0, 0}, {4, 1, 0.01}, 1, 0.8, add_body(&scene, {}));
  const Workbench bench(scene, 1, 1, Roots::kClusters);
  Transport transport(bench, {link_of(0, 1, bench.always(), {3.0f}), link_of(1, 0, bench.always(), {3.0f})});
  const std::vector<float> one(bench.nodes->nodes().size(), 1.0f);
  transport.input.form_factor_sums = &one;
  const NodeLight light = transport.solve([](size_t) { return Rgb{1, 1, 1}; });
  EXPECT_LT(light.residual, 1e-6);
  for (const Rgb& l : light.radiance) EXPECT_LE(l.r, 1 / (1 - 0.8) + 1e-3);
}

// A closed room with small boxes in its air, all of which emit 1 and reflect a half: rho Le / (1 - rho) = 1
// is reflected everywhere.
TEST(ClusterTransport, FurnaceWithSmallBoxes) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  add_boxes(&scene, {1, 1, 0.6}, {2, 2, 1.4}, 3, 0.5, add_body(&scene, {}));
  Workbench bench(scene, 1, 1, Roots::kClusters);
  std::vector<Link> links;
  for (const uint32_t p : {0u, 1u})
    for (const uint32_t q : {0u, 1u}) make_links(&bench, p, q, 0.15f, 0.5f, &links);
  Transport transport(bench, links);
  size_t of_clusters = 0;
  for (const Link& link : links)
    of_clusters += bench.node(link.receiver).is_cluster() || bench.node(link.emitter).is_cluster();
  EXPECT_GT(of_clusters, 50u);  // else the test is of patches
  // The sums of kernels, which the furnace makes 1, before any balance.
  const std::vector<float> one(bench.nodes->nodes().size(), 1.0f);
  transport.input.form_factor_sums = &one;
  const std::vector<float> scales = balance(transport.input, transport.time_samples());
  double sum = 0, area = 0;
  for (uint32_t n = 0; n < bench.nodes->nodes().size(); ++n) {
    if (!bench.node(n).is_leaf()) continue;
    const Node& node = bench.node(n);
    for (uint32_t l = 0; l < (node.is_cluster() ? kLobes : 1u); ++l)
      sum += static_cast<double>(node.area * (node.is_cluster() ? bench.cluster(n).lobe_share[l] : 1.0f) /
                                 scales[node.slot + l]);
    area += static_cast<double>(bench.node(n).area);
  }
  EXPECT_NEAR(sum / area, 1, 0.05);
  const NodeLight light = transport.solve([](size_t) { return Rgb{0.5f, 0.5f, 0.5f}; });
  double squares = 0;
  for (uint32_t n = 0; n < bench.nodes->nodes().size(); ++n) {
    if (!bench.node(n).is_leaf()) continue;
    const bool cluster = bench.node(n).is_cluster();
    const double l =
        static_cast<double>(cluster ? transport.mean_radiance(light, n).r : transport.radiance(light, n).r);
    squares += static_cast<double>(bench.node(n).area) * (l - 1) * (l - 1);
  }
  EXPECT_LT(std::sqrt(squares / area), 0.03);
}

}  // namespace
}  // namespace strad
