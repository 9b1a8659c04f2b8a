// Where bodies can be: boxes of known motions, and what they can come between.
#include "solve/prepare/swept.h"

#include <gtest/gtest.h>

#include "../light/light_test_scene.h"

namespace strad {
namespace {

struct Motion {
  Scene scene;
  TimeGrid grid;
  Tracer tracer;
  SweptBounds swept;
  explicit Motion(Scene s, int cells = 8)
      : scene(std::move(s)),
        grid(make_time_grid(scene.start, scene.end, {}, 1, cells)),
        tracer(scene),
        swept(scene, tracer, grid) {}
  Interval always() const { return {0, grid.spans[0].log2_cells}; }
};

// A cube of 1 m at the origin that goes 8 m along x in 8 s, a cell a second, over a floor at rest.
Scene sliding_cube() {
  Scene scene;
  scene.end = 8;
  add_polygon(&scene, {{-20, -20, -5}, {20, -20, -5}, {20, 20, -5}, {-20, 20, -5}});
  const uint32_t body = add_body(&scene, {8, 0, 0});
  add_box(&scene, {0, 0, 0}, {1, 1, 1}, false, body);
  return scene;
}

TEST(Swept, OnlyBodiesWithMotionMove) {
  Scene scene = sliding_cube();
  add_body(&scene, {0, 0, 0});
  const Motion motion(std::move(scene));
  EXPECT_FALSE(motion.swept.moves(0));
  EXPECT_TRUE(motion.swept.moves(1));
  EXPECT_FALSE(motion.swept.moves(2));
}

// In cell c the cube covers x from c to c + 2. The margin is a quarter of the way between two of five
// instants of a cell, 1/16 m.
TEST(Swept, BoxOfASlide) {
  const Motion motion(sliding_cube());
  ASSERT_EQ(motion.grid.cell_count(), 8u);
  for (uint32_t c = 0; c < 8; ++c) {
    const Box box = motion.swept.box(1, {c, 0});
    EXPECT_NEAR(box.lower.x, c - 1.0 / 16, 1e-6);
    EXPECT_NEAR(box.upper.x, c + 2 + 1.0 / 16, 1e-6);
    EXPECT_NEAR(box.lower.z, -1.0 / 16, 1e-6);
    EXPECT_NEAR(box.upper.z, 1 + 1.0 / 16, 1e-6);
  }
  const Box all = motion.swept.box(1, motion.always());
  EXPECT_NEAR(all.lower.x, -1.0 / 16, 1e-6);
  EXPECT_NEAR(all.upper.x, 9 + 1.0 / 16, 1e-6);
}

// A rod that turns once in 8 cells bulges between the instants that are looked at; every position of its tip,
// 10 m from the pivot, lies in the box of its cell.
TEST(Swept, BoxesHoldATurn) {
  Scene scene;
  scene.end = 1;
  const uint32_t body = add_body(&scene, {0, 0, 0}, 2 * kPi, {0, 0, 1});
  add_box(&scene, {9, -0.1, -0.1}, {10, 0.1, 0.1}, false, body);
  const Motion motion(std::move(scene));
  for (uint32_t c = 0; c < motion.grid.cell_count(); ++c) {
    const Box box = motion.swept.box(1, {c, 0});
    for (int k = 0; k <= 100; ++k) {
      const Vec3 tip = motion.swept.poses({c, 0}, k / 100.0)[1] * Vec3{10, 0.1, 0.1};
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(tip[axis], box.lower[axis]);
        EXPECT_LE(tip[axis], box.upper[axis]);
      }
    }
  }
}

// Between two spheres of 0.1 m at z = -3 and z = 4, above x = 4.5: the cube passes there in cells 3 and 4 (it
// covers 3 to 5 and 4 to 6), its box with the margin of 1/16 m and the radius also touches x = 4.5 in no
// other (cell 2 ends at 4 + 1/16 + 0.1, cell 5 begins at 5 - 1/16 - 0.1).
TEST(Swept, BlocksOnlyWhileItPasses) {
  const Motion motion(sliding_cube());
  for (uint32_t c = 0; c < 8; ++c)
    EXPECT_EQ(motion.swept.may_block({4.5, 0.5, -3}, 0.1, {4.5, 0.5, 4}, 0.1, {c, 0}), c == 3 || c == 4)
        << "cell " << c;
  EXPECT_TRUE(motion.swept.may_block({4.5, 0.5, -3}, 0.1, {4.5, 0.5, 4}, 0.1, motion.always()));
  // Never beside its way, but for spheres that reach it.
  EXPECT_FALSE(motion.swept.may_block({4.5, 3, -3}, 0.1, {4.5, 3, 4}, 0.1, motion.always()));
  EXPECT_TRUE(motion.swept.may_block({4.5, 3, -3}, 2.5, {4.5, 3, 4}, 2.5, motion.always()));
}

TEST(Swept, RaysMeetItWhereItGoes) {
  const Motion motion(sliding_cube());
  const Vec3 from{6.5, 0.5, 5}, down{0, 0, -1};
  EXPECT_TRUE(motion.swept.may_meet(from, down, 10));
  EXPECT_FALSE(motion.swept.may_meet(from, down, 3));  // the box's top is at 1 + 1/16
  EXPECT_FALSE(motion.swept.may_meet({6.5, 0.5, 5}, {0, 0, 1}, 10));
  for (uint32_t c = 0; c < 8; ++c)
    EXPECT_EQ(motion.swept.may_meet_in(c, from, down, 10), c == 5 || c == 6) << "cell " << c;
}

// At a step, the values inside the interval hold at its ends: the cube is at 0 before 4 s and at 8 after.
TEST(Swept, PosesKeepToTheirSideOfAStep) {
  Scene scene = sliding_cube();
  BodyKey before, after;
  before.time = after.time = 4;
  after.move = {8, 0, 0};
  scene.bodies[1].keys = {before, after};
  const TimeGrid grid = make_time_grid(0, 8, {4}, 1, 2);
  const Tracer tracer(scene);
  const SweptBounds swept(scene, tracer, grid);
  ASSERT_EQ(grid.spans.size(), 2u);
  const Interval first{0, grid.spans[0].log2_cells},
      second{grid.spans[1].first_cell, grid.spans[1].log2_cells};
  EXPECT_NEAR((swept.poses(first, 1)[1] * Vec3{}).x, 0, 1e-9);
  EXPECT_NEAR((swept.poses(second, 0)[1] * Vec3{}).x, 8, 1e-9);
}

}  // namespace
}  // namespace strad
