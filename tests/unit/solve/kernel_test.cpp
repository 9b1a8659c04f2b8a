// Kernels of links against form factors, and what they tell of time.
#include "solve/links/kernel.h"

#include <gtest/gtest.h>

#include "workbench.h"

namespace strad {
namespace {

// Unit squares at distance `h`, facing each other: floor and ceiling.
Scene squares(double h) {
  Scene scene;
  scene.end = 8;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_polygon(&scene, {{0, 0, h}, {0, 1, h}, {1, 1, h}, {1, 0, h}});
  return scene;
}

// Form factor between the two, both split `levels` deep.
double form_factor(Workbench* bench, int levels) {
  double sum = 0;
  for (const uint32_t p : bench->leaves_of(0, levels))
    for (const uint32_t q : bench->leaves_of(1, levels))
      sum += static_cast<double>(bench->nodes->nodes()[p].area / bench->nodes->nodes()[0].area) *
             static_cast<double>(bench->estimate(p, q, bench->always()).kernel[0]) / kPi;
  return sum;
}

// Howell, "A catalog of radiation heat transfer configuration factors", C-11 and C-14.
constexpr double kParallelUnitSquares = 0.19982, kSquaresWithACommonEdge = 0.20004;

TEST(Kernel, ParallelSquares) {
  Workbench bench(squares(1));
  EXPECT_NEAR(form_factor(&bench, 2), kParallelUnitSquares, 0.005 * kParallelUnitSquares);
  EXPECT_NEAR(form_factor(&bench, 0), kParallelUnitSquares, 0.1 * kParallelUnitSquares);
}

TEST(Kernel, SquaresWithACommonEdge) {
  Scene scene;
  scene.end = 8;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_polygon(&scene, {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  Workbench bench(scene);
  EXPECT_NEAR(form_factor(&bench, 3), kSquaresWithACommonEdge, 0.01 * kSquaresWithACommonEdge);
}

TEST(Kernel, TurnedAwayThereIsNothing) {
  Scene scene;
  scene.end = 8;
  add_polygon(&scene, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}});
  add_polygon(&scene, {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}});
  Workbench bench(scene);
  KernelCounts counts;
  const KernelEstimate e = bench.kernels->estimate(0, 1, bench.always(), &counts);
  EXPECT_EQ(e.kernel[0], 0);
  EXPECT_EQ(counts.rays, 0u);
}

TEST(Kernel, AWallBetweenCutsItOff) {
  Scene scene = squares(1);
  add_polygon(&scene, {{-1, -1, 0.5}, {2, -1, 0.5}, {2, 2, 0.5}, {-1, 2, 0.5}});
  Workbench bench(scene);
  const KernelEstimate e = bench.estimate(0, 1, bench.always());
  EXPECT_EQ(e.kernel[0], 0);
  EXPECT_FALSE(e.dynamic);
}

TEST(Kernel, StandsStillWhenNothingComesBetween) {
  Scene scene = squares(1);
  add_polygon(&scene, {{5, 0, 0.5}, {6, 0, 0.5}, {6, 1, 0.5}, {5, 1, 0.5}}, add_body(&scene, {3, 0, 0}));
  Workbench bench(scene);
  const KernelEstimate e = bench.estimate(0, 1, bench.always());
  EXPECT_FALSE(e.dynamic);
  EXPECT_GT(e.kernel[0], 0);
  EXPECT_EQ(e.time_error, 0);
}

// A plate crosses from x = -3..-1.5 to 1.5..3 between 0 and 8 s: it covers all at half time, nothing at
// first.
TEST(Kernel, ChangesWhileSomethingPasses) {
  Scene scene = squares(1);
  add_polygon(&scene, {{-3, -1, 0.5}, {-1, -1, 0.5}, {-1, 2, 0.5}, {-3, 2, 0.5}},
              add_body(&scene, {5, 0, 0}));
  Workbench bench(scene, 2, 64);
  const KernelEstimate whole = bench.estimate(0, 1, bench.always());
  EXPECT_TRUE(whole.dynamic);
  EXPECT_GT(whole.time_error, 0.05);
  const KernelEstimate blocked = bench.estimate(0, 1, {32, 0});  // from 4 s on: x in -0.5..1.5
  EXPECT_FALSE(blocked.dynamic);                                 // it may change but does not
  EXPECT_EQ(blocked.kernel[0], 0);
  EXPECT_EQ(blocked.kernel[1], 0);
  EXPECT_EQ(blocked.time_error, 0);
  const KernelEstimate free = bench.estimate(0, 1, {0, 2});
  EXPECT_FALSE(free.dynamic);
  EXPECT_NEAR(free.kernel[0] / kPi, kParallelUnitSquares, 0.1 * kParallelUnitSquares);
}

// The ceiling rises from 1 to 3 m: at each Gauss time sample the kernel is that of the distance.
TEST(Kernel, FollowsARisingReceiver) {
  Scene scene = squares(1);
  scene.objects[1].body = add_body(&scene, {0, 0, 2});
  Workbench moving(scene, 3);
  const KernelEstimate e = moving.estimate(1, 0, moving.always());
  EXPECT_TRUE(e.dynamic);
  for (int k = 0; k < 3; ++k) {
    Workbench still(squares(1 + 2 * gauss_nodes(3)[k]));
    const double expected = still.estimate(1, 0, still.always()).kernel[0];
    EXPECT_NEAR(e.kernel[k], expected, 0.03 * expected);
  }
}

TEST(Kernel, IsMoreCertainFartherAway) {
  Workbench close(squares(0.2)), far(squares(5));
  const KernelEstimate a = close.estimate(0, 1, close.always());
  const KernelEstimate b = far.estimate(0, 1, far.always());
  EXPECT_GT(a.receiver_error, 0.05 * a.kernel[0]);
  EXPECT_LT(b.receiver_error, 0.02 * b.kernel[0]);
}

// The form factors of a patch in a closed box add up to 1.
TEST(Kernel, RowsOfABoxAddUpToOne) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  Workbench bench(scene);
  std::vector<uint32_t> leaves;
  for (uint32_t p = 0; p < 6; ++p)
    for (const uint32_t leaf : bench.leaves_of(p, 3)) leaves.push_back(leaf);
  for (size_t i = 0; i < leaves.size(); i += 7) {
    double sum = 0;
    for (const uint32_t q : leaves)
      sum += static_cast<double>(bench.estimate(leaves[i], q, bench.always()).kernel[0]) / kPi;
    EXPECT_NEAR(sum, 1, 0.05) << i;
  }
}

}  // namespace
}  // namespace strad
