// Kernels of clusters against those of the surfaces that they are made of.
#include <gtest/gtest.h>

#include "base/rng.h"
#include "workbench.h"

namespace strad {
namespace {

// A square that looks up, and above it one that looks back, from another body: whole, or in n x n parts.
Scene squares(int n, Vec3 u, Vec3 v) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_parts(&scene, Vec3{3, 2, 5} - 0.5 * (u + v), u, v, n, add_body(&scene, {}));
  return scene;
}

// To the lower square's patch and from it.
struct Kernels {
  double to, from;
};
Kernels kernels_of(const Scene& scene) {
  Workbench bench(scene, 1, 1, Roots::kClusters);
  const uint32_t patch = bench.children_of(0)[0];
  const uint32_t upper = bench.cluster(1).face_count == 1 ? bench.children_of(1)[0] : 1;
  return {static_cast<double>(bench.estimate(patch, upper, bench.always()).kernel[0]),
          static_cast<double>(bench.estimate(upper, patch, bench.always()).kernel[0])};
}

TEST(ClusterKernel, ASquareInPartsIsASquare) {
  const Vec3 turns[][2] = {
      {{0, 1, 0}, {1, 0, 0}}, {{0, 1, 0}, {0.8, 0, 0.6}}, {{-0.3, 0.9, 0.2}, {0.9, 0.3, 0}}};
  for (const auto& turn : turns) {
    const Kernels whole = kernels_of(squares(1, turn[0], turn[1]));
    for (const int n : {3, 8}) {
      const Kernels parts = kernels_of(squares(n, turn[0], turn[1]));
      EXPECT_NEAR(parts.to, whole.to, 0.05 * whole.to) << n;
      EXPECT_NEAR(parts.from, whole.from, 0.05 * whole.from) << n;
    }
  }
}

// A cube in a square's light: the mean over its six sides, of which half lie in its own shadow.
TEST(ClusterKernel, ABoxReceivesWhatItsSidesDo) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_box(&scene, {2, 2, 5}, {3, 3, 6}, false, add_body(&scene, {}));
  Workbench whole(scene, 1, 1, Roots::kClusters), sides(scene, 1, 1, Roots::kFaces);
  const uint32_t square = whole.children_of(0)[0];
  double to_box = 0, from_box = 0;
  for (uint32_t side = 1; side <= 6; ++side) {
    to_box += static_cast<double>(sides.estimate(side, 0, sides.always()).kernel[0]) / 6;
    from_box += static_cast<double>(sides.estimate(0, side, sides.always()).kernel[0]);
  }
  const KernelEstimate to = whole.estimate(1, square, whole.always());
  // 16 samples share six sides unevenly.
  EXPECT_NEAR(to.kernel[0], to_box, 0.2 * to_box);
  EXPECT_NEAR(whole.estimate(square, 1, whole.always()).kernel[0], from_box, 0.2 * from_box);
  // Six lobes tell how its sides differ: that is no error.
  EXPECT_LT(to.receiver_error, 0.25f * to.kernel[0]);
}

// The parts of a room's walls fill all that a point sees, taken in clusters where these are far enough.
double sum_of_kernels(Workbench* bench, uint32_t p, uint32_t q, int* clusters) {
  const Node &a = bench->node(p), &b = bench->node(q);
  const bool far = length(a.centre - b.centre) > 1.5 * static_cast<double>(a.radius + b.radius);
  if (b.is_cluster() && (!far || bench->kernels->overlap(p, q, bench->always()))) {
    double sum = 0;
    for (const uint32_t child : bench->children_of(q)) sum += sum_of_kernels(bench, p, child, clusters);
    return sum;
  }
  *clusters += b.is_cluster();
  return p == q ? 0 : static_cast<double>(bench->estimate(p, q, bench->always()).kernel[0]);
}

TEST(ClusterKernel, RowsOfARoomAddUpToPi) {
  Scene scene;
  scene.end = 1;
  const int n = 8;
  add_parts(&scene, {0, 0, 0}, {4, 0, 0}, {0, 3, 0}, n);
  add_parts(&scene, {0, 0, 2}, {0, 3, 0}, {4, 0, 0}, n);
  add_parts(&scene, {0, 0, 0}, {0, 0, 2}, {4, 0, 0}, n);
  add_parts(&scene, {0, 3, 0}, {4, 0, 0}, {0, 0, 2}, n);
  add_parts(&scene, {0, 0, 0}, {0, 3, 0}, {0, 0, 2}, n);
  add_parts(&scene, {4, 0, 0}, {0, 0, 2}, {0, 3, 0}, n);
  Workbench bench(scene, 1, 1, Roots::kClusters);
  bench.split_clusters();
  int clusters = 0;
  double mean = 0;
  const int count = 24;
  for (uint64_t i = 0; i < count; ++i) {
    const auto face = static_cast<uint32_t>(unit_from(hash_of(i)) * 6 * n * n);
    const double sum = sum_of_kernels(&bench, bench.nodes->node_of_face(face), 0, &clusters) / kPi;
    EXPECT_NEAR(sum, 1, 0.15) << face;
    mean += sum / count;
  }
  EXPECT_NEAR(mean, 1, 0.03);
  EXPECT_GT(clusters, 200);
}

// Two cubes on bodies of their own; the second comes from 10 m away, through the first and away again: it is
// at x = 10 - 20 s.
Workbench passing_cubes() {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {1, 1, 1}, false, add_body(&scene, {}));
  add_box(&scene, {10, 0, 0}, {11, 1, 1}, false, add_body(&scene, {-20, 0, 0}));
  return Workbench(scene, 2, 16, Roots::kClusters);
}

TEST(ClusterKernel, BoxesOverlapWhileTheyMeet) {
  const Workbench bench = passing_cubes();
  const KernelEvaluator& kernels = *bench.kernels;
  EXPECT_TRUE(kernels.overlap(0, 1, bench.always()));  // for a twentieth of it
  EXPECT_TRUE(kernels.overlap(1, 0, bench.always()));
  EXPECT_TRUE(kernels.overlap(0, 1, {8, 0}));
  EXPECT_FALSE(kernels.overlap(0, 1, {0, 2}));
  EXPECT_FALSE(kernels.overlap(0, 1, {12, 2}));
}

TEST(ClusterKernel, AClusterOverlapsItself) {
  Workbench bench = passing_cubes();
  EXPECT_TRUE(bench.kernels->overlap(0, 0, bench.always()));
  const std::vector<uint32_t> sides = bench.children_of(0);
  EXPECT_TRUE(bench.kernels->overlap(1, sides[0], {8, 0}));  // one end is a cluster
  EXPECT_FALSE(bench.kernels->overlap(sides[0], sides[0], bench.always()));
  EXPECT_FALSE(bench.kernels->overlap(sides[0], sides[1], bench.always()));  // patches know what they see
}

// Turned boxes: the corners of one lie in the other's frame, not in the world's.
TEST(ClusterKernel, BoxesOverlapInTheirOwnFrames) {
  Scene scene;
  scene.end = 1;
  // A long rod, at first along x, stands along y at the end, and then passes over the cube at (0.5, 4.5,
  // 0.5).
  add_box(&scene, {0, 0, 0}, {5, 1, 1}, false, add_body(&scene, {}, kPi / 2, {0, 0, 1}));
  add_box(&scene, {-0.8, 4, 0}, {-0.2, 4.6, 1}, false);
  const Workbench bench(scene, 2, 16, Roots::kClusters);
  const uint32_t cube = bench.node(0).body == 0 ? 0 : 1, rod = 1 - cube;
  EXPECT_FALSE(bench.kernels->overlap(rod, cube, {0, 0}));
  EXPECT_TRUE(bench.kernels->overlap(rod, cube, {15, 0}));
  EXPECT_TRUE(bench.kernels->overlap(cube, rod, {15, 0}));
}

// Two groups of boxes on one body that flies and turns through empty space.
TEST(ClusterKernel, WhatTravelsTogetherIsNotDynamic) {
  Scene scene;
  scene.end = 1;
  const uint32_t body = add_body(&scene, {5, 2, 1}, 2, {0, 0, 1});
  add_boxes(&scene, {0, 0, 0}, {1, 1, 1}, 2, 0.6, body);
  add_boxes(&scene, {3, 0, 0}, {4, 1, 1}, 2, 0.6, body);
  Workbench bench(scene, 2, 16, Roots::kClusters);
  const std::vector<uint32_t> groups = bench.children_of(0);
  const uint32_t first = groups.front(), last = groups.back();
  ASSERT_TRUE(bench.node(first).is_cluster() && bench.node(last).is_cluster());
  ASSERT_FALSE(bench.kernels->overlap(first, last, bench.always()));
  const KernelEstimate e = bench.estimate(first, last, bench.always());
  EXPECT_GT(e.kernel[0], 0);
  EXPECT_FALSE(e.dynamic);
}

TEST(ClusterKernel, WhatPassesBetweenIsDynamic) {
  Scene scene;
  scene.end = 1;
  add_boxes(&scene, {0, 0, 0}, {1, 1, 1}, 2, 0.6);
  add_boxes(&scene, {3, 0, 0}, {4, 1, 1}, 2, 0.6, add_body(&scene, {}));
  add_polygon(&scene, {{2, -3, -1}, {2, -1, -1}, {2, -1, 2}, {2, -3, 2}}, add_body(&scene, {0, 5, 0}));
  const Workbench bench(scene, 3, 64, Roots::kClusters);
  EXPECT_TRUE(bench.estimate(0, 1, bench.always()).dynamic);
  EXPECT_GT(bench.estimate(0, 1, bench.always()).time_error, 0);
  EXPECT_FALSE(bench.estimate(0, 1, {0, 2}).dynamic);
  EXPECT_GT(bench.estimate(0, 1, {0, 2}).kernel[0], 0);
  const KernelEstimate blocked = bench.estimate(0, 1, {32, 0});  // the plate is at y = -0.5 .. 1.5
  EXPECT_LT(blocked.kernel[0], 0.1f * bench.estimate(0, 1, {0, 2}).kernel[0]);
}

TEST(ClusterKernel, AWallBetweenCutsItOff) {
  Scene scene;
  scene.end = 1;
  add_boxes(&scene, {0, 0, 0}, {1, 1, 1}, 2, 0.6);
  add_boxes(&scene, {3, 0, 0}, {4, 1, 1}, 2, 0.6, add_body(&scene, {}));
  add_polygon(&scene, {{2, -9, -9}, {2, 9, -9}, {2, 9, 9}, {2, -9, 9}}, add_body(&scene, {}));
  const Workbench bench(scene, 1, 1, Roots::kClusters);
  const KernelEstimate e = bench.estimate(0, 1, bench.always());
  EXPECT_EQ(e.kernel[0], 0);
  EXPECT_EQ(e.receiver_error, 0);
}

}  // namespace
}  // namespace strad
