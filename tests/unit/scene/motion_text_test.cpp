// Statements of the motion language arrive in the scene.
#include "scene/motion_text.h"

#include <gtest/gtest.h>

#include "motion_test_scene.h"

namespace strad {
namespace {

Scene compiled(const std::string& text) {
  Scene scene = motion_test_scene();
  apply_motion(text, "test.motion", scene);
  return scene;
}

TEST(Motion, an_empty_text_changes_nothing) {
  const Scene scene = compiled("\n  # only a comment\n\n");
  EXPECT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.end, 0);
}

TEST(Motion, time_and_rate) {
  const Scene scene = compiled("time -1 24\nrate 12.5\n");
  EXPECT_EQ(scene.start, -1);
  EXPECT_EQ(scene.end, 24);
  EXPECT_EQ(scene.rate, 12.5);
}

TEST(Motion, a_rate_may_be_a_quotient) { EXPECT_EQ(compiled("rate 24000/1001\n").rate, 24000.0 / 1001); }

TEST(Motion, angles_may_be_in_radians) {
  const Scene scene = compiled(
      "body b\n  key 0 turn 0.7rad\nspot s\n  cone 0.1rad 90\n  key 0 at 0 0 0 aim 1 0 0 intensity 1 1 1\n");
  EXPECT_EQ(scene.bodies[1].keys[0].turn, 0.7);
  EXPECT_EQ(scene.spots[0].inner, 0.1);
  EXPECT_EQ(scene.spots[0].outer, 90 * kDegree);
}

TEST(Motion, a_body_with_all_settings) {
  const Scene scene = compiled(
      "body rail\n  parts floor\n"
      "body crane  # carried by the rail\n"
      "  parts crane_* hook\n"
      "  on rail\n"
      "  pivot 0 0 3\n"
      "  axis 0 0 -2\n"
      "  ease smooth\n"
      "  key 0   move 1 2 3  turn 90\n"
      "  key 10  quat 0 2 0 0  move .5 -1e1 +2\n");
  ASSERT_EQ(scene.bodies.size(), 3u);
  const Body& crane = scene.bodies[2];
  EXPECT_EQ(crane.name, "crane");
  EXPECT_EQ(crane.parent, 1u);
  EXPECT_EQ(crane.pivot, (Vec3{0, 0, 3}));
  EXPECT_EQ(crane.axis, (Vec3{0, 0, -1}));
  EXPECT_EQ(crane.ease, Ease::kSmooth);
  EXPECT_EQ(crane.parts, (std::vector<std::string>{"crane_*", "hook"}));
  ASSERT_EQ(crane.keys.size(), 2u);
  EXPECT_EQ(crane.keys[0].move, (Vec3{1, 2, 3}));
  EXPECT_DOUBLE_EQ(crane.keys[0].turn, 90 * kDegree);
  EXPECT_FALSE(crane.keys[0].has_quat);
  EXPECT_EQ(crane.keys[1].time, 10);
  EXPECT_EQ(crane.keys[1].move, (Vec3{0.5, -10, 2}));
  EXPECT_TRUE(crane.keys[1].has_quat);
  EXPECT_EQ(crane.keys[1].quat, (Quat{0, 1, 0, 0}));
  const std::vector<uint32_t> bodies = {scene.objects[0].body, scene.objects[1].body, scene.objects[2].body,
                                        scene.objects[3].body};
  EXPECT_EQ(bodies, (std::vector<uint32_t>{1, 2, 2, 2}));
}

TEST(Motion, a_body_needs_nothing_but_its_name) {
  const Scene scene = compiled("body arm\n");
  const Body& arm = scene.bodies.at(1);
  EXPECT_EQ(arm.parent, 0u);
  EXPECT_EQ(arm.pivot, Vec3{});
  EXPECT_EQ(arm.axis, (Vec3{0, 1, 0}));
  EXPECT_EQ(arm.ease, Ease::kLinear);
  EXPECT_TRUE(arm.keys.empty());
}

TEST(Motion, a_spot_rides_a_body) {
  const Scene scene = compiled(
      "body arm\n"
      "spot key1\n  on arm\n  cone 20 30\n"
      "  key 0 at 0 2.8 0 aim 1 0 0 intensity 30 30 28\n");
  ASSERT_EQ(scene.spots.size(), 1u);
  const Spot& spot = scene.spots[0];
  EXPECT_EQ(spot.name, "key1");
  EXPECT_EQ(spot.body, 1u);
  EXPECT_DOUBLE_EQ(spot.inner, 20 * kDegree);
  EXPECT_DOUBLE_EQ(spot.outer, 30 * kDegree);
  EXPECT_EQ(spot.keys.at(0).at, (Vec3{0, 2.8, 0}));
  EXPECT_EQ(spot.keys.at(0).aim, (Vec3{1, 0, 0}));
  EXPECT_EQ(spot.keys.at(0).intensity, (Rgb{30, 30, 28}));
}

TEST(Motion, a_glow_with_a_step_and_a_name_in_quotes) {
  const Scene scene = compiled("glow \"lamp glass\"\n  key 0 value 1\n  key 5 value 1\n  key 5 value 0.2\n");
  ASSERT_EQ(scene.glows.size(), 1u);
  EXPECT_EQ(scene.glows[0].material, 1u);
  ASSERT_EQ(scene.glows[0].keys.size(), 3u);
  EXPECT_EQ(scene.glows[0].keys[2].time, 5);
  EXPECT_EQ(scene.glows[0].keys[2].value, 0.2f);
}

TEST(Motion, a_camera) {
  const Scene scene = compiled(
      "camera main\n  key 0 from 0 1.6 5 to 0 1 0 up 0 0 1 fov 60\n"
      "camera side\n  key 0 from 1 0 0 to 0 0 0\n");
  ASSERT_EQ(scene.cameras.size(), 2u);
  const CameraKey& key = scene.cameras[0].keys.at(0);
  EXPECT_EQ(key.from, (Vec3{0, 1.6, 5}));
  EXPECT_EQ(key.to, (Vec3{0, 1, 0}));
  EXPECT_EQ(key.up, (Vec3{0, 0, 1}));
  EXPECT_DOUBLE_EQ(key.fov, 60 * kDegree);
  const CameraKey& side = scene.cameras[1].keys.at(0);
  EXPECT_EQ(side.up, (Vec3{0, 1, 0}));
  EXPECT_DOUBLE_EQ(side.fov, 40 * kDegree);
}

TEST(Motion, what_a_key_leaves_out_stays_as_in_the_key_before) {
  const Scene scene = compiled(
      "body arm\n  key 0 turn 30\n  key 1 move 1 2 3\n  key 2 turn 60\n"
      "spot s\n  cone 0 10\n  key 0 at 0 0 0 aim 0 0 1 intensity 1 2 3\n  key 4 intensity 4 5 6\n");
  const Body& arm = scene.bodies[1];
  EXPECT_EQ(arm.keys[0].move, Vec3{});
  EXPECT_EQ(arm.keys[1].turn, arm.keys[0].turn);
  EXPECT_EQ(arm.keys[2].move, (Vec3{1, 2, 3}));
  EXPECT_DOUBLE_EQ(arm.keys[2].turn, 60 * kDegree);
  EXPECT_EQ(scene.spots[0].keys[1].aim, (Vec3{0, 0, 1}));
  EXPECT_EQ(scene.spots[0].keys[1].intensity, (Rgb{4, 5, 6}));
}

TEST(Motion, a_parent_may_be_named_before_it_is_described) {
  const Scene scene = compiled(
      "body hand\n  on arm\n  parts hook\n"
      "body arm\n  on world\n"
      "spot s\n  on hand\n  cone 0 10\n  key 0 at 0 0 0 aim 0 0 1 intensity 1 1 1\n");
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[1].name, "arm");
  EXPECT_EQ(scene.bodies[1].parent, 0u);
  EXPECT_EQ(scene.bodies[2].name, "hand");
  EXPECT_EQ(scene.bodies[2].parent, 1u);
  EXPECT_EQ(scene.objects[3].body, 2u);
  EXPECT_EQ(scene.spots[0].body, 2u);
}

TEST(Motion, lines_may_end_with_carriage_returns_and_hold_tabs) {
  const Scene scene = compiled("time 0 2\r\nbody arm\r\n\tpivot\t1 2 3\r\n");
  EXPECT_EQ(scene.end, 2);
  EXPECT_EQ(scene.bodies[1].pivot, (Vec3{1, 2, 3}));
}

}  // namespace
}  // namespace strad
