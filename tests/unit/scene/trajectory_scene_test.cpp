// Lights and cameras over time, times of steps, and which bodies move.
#include <gtest/gtest.h>

#include "scene/trajectory.h"

namespace strad {
namespace {

BodyKey move_key(double time, Vec3 move) {
  return {.time = time, .move = move, .turn = 0, .has_quat = false, .quat = {}};
}

Body moving_body(std::vector<BodyKey> keys, uint32_t parent = 0, Ease ease = Ease::kLinear) {
  Body body;
  body.parent = parent;
  body.ease = ease;
  body.keys = std::move(keys);
  return body;
}

Scene empty_scene() {
  Scene scene;
  scene.end = 10;
  return scene;
}

TEST(SpotAt, rides_its_body) {
  Scene scene = empty_scene();
  Body arm = moving_body({});
  arm.axis = {0, 0, 1};
  arm.pivot = {1, 0, 0};
  arm.keys = {{.time = 0, .move = {0, 0, 5}, .turn = kPi / 2, .has_quat = false, .quat = {}}};
  scene.bodies.push_back(arm);
  Spot spot;
  spot.body = 1;
  spot.keys = {{0, {2, 0, 0}, {2, 0, -3}, {1, 2, 3}}, {10, {4, 0, 0}, {8, 0, 0}, {3, 2, 1}}};
  const auto poses = poses_at(scene, 10);
  // (4, 0, 0) is 3 ahead of the pivot (1, 0, 0): after a quarter turn 3 to the left, then 5 up. It looks
  // along y.
  const SpotState end = spot_at(scene, spot, poses, 10);
  EXPECT_LE(length(end.position - Vec3{1, 3, 5}), 1e-12);
  EXPECT_LE(length(end.direction - Vec3{0, 1, 0}), 1e-12);
  const SpotState half = spot_at(scene, spot, poses, 5);
  EXPECT_EQ(half.intensity, (Rgb{2, 2, 2}));
  // At rest halfway: at (3, 0, 0), aim (5, 0, -1.5).
  EXPECT_LE(length(half.direction - normalized({0, 2, -1.5})), 1e-12);
}

TEST(SpotAt, keeps_its_direction_where_the_aim_passes_through_it) {
  Spot spot;
  spot.keys = {{0, {0, 0, 0}, {0, 0, 1}, {1, 1, 1}}, {2, {0, 0, 0}, {0, 0, -1}, {1, 1, 1}}};
  const Scene scene = empty_scene();
  EXPECT_EQ(spot_at(scene, spot, poses_at(scene, 1), 1).direction, (Vec3{0, 0, 1}));
}

TEST(GlowAt, scales_materials_over_time_and_is_one_elsewhere) {
  Scene scene = empty_scene();
  scene.materials.resize(3);
  scene.glows = {{1, {{2, 1.0f}, {4, 3.0f}, {4, 0.5f}, {6, 0.5f}}}};
  const auto at = [&](double time) { return glow_at(scene, time); };
  EXPECT_EQ(at(0), (std::vector<float>{1, 1, 1}));
  EXPECT_EQ(at(3), (std::vector<float>{1, 2, 1}));
  EXPECT_EQ(at(4), (std::vector<float>{1, 0.5f, 1}));
  EXPECT_EQ(at(9), (std::vector<float>{1, 0.5f, 1}));
}

TEST(CameraAt, moves_between_keys_and_cuts_at_steps) {
  Camera camera;
  camera.keys = {{0, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.5},
                 {4, {4, 0, 0}, {1, 2, 0}, {0, 1, 0}, 0.9},
                 {4, {9, 9, 9}, {0, 0, 0}, {0, 0, 1}, 0.3}};
  const CameraState quarter = camera_at(camera, 1);
  EXPECT_EQ(quarter.from, (Vec3{1, 0, 0}));
  EXPECT_EQ(quarter.to, (Vec3{1, 0.5, 0}));
  EXPECT_DOUBLE_EQ(quarter.fov, 0.6);
  EXPECT_EQ(camera_at(camera, 4).from, (Vec3{9, 9, 9}));
}

TEST(StepTimes, finds_the_steps_of_all_but_cameras) {
  Scene scene = empty_scene();
  scene.materials.resize(1);
  scene.bodies.push_back(moving_body({move_key(3, {}), move_key(3, {1, 0, 0})}));
  scene.spots.push_back({});
  scene.spots[0].keys = {{7, {}, {1, 0, 0}, {}}, {7, {}, {1, 0, 0}, {1, 1, 1}}};
  scene.glows = {{0, {{1.5, 1}, {1.5, 0}, {3, 0}, {3, 1}}}};
  Camera camera;
  camera.keys = {{5, {}, {1, 0, 0}}, {5, {}, {2, 0, 0}}};
  scene.cameras.push_back(camera);
  EXPECT_EQ(step_times(scene), (std::vector<double>{1.5, 3, 7}));
}

TEST(StepTimes, leaves_out_the_ends_and_two_equal_keys) {
  Scene scene = empty_scene();
  scene.bodies.push_back(moving_body({move_key(0, {}), move_key(0, {1, 0, 0}), move_key(6, {2, 0, 0}),
                                      move_key(6, {2, 0, 0}), move_key(10, {}), move_key(10, {1, 0, 0})}));
  EXPECT_TRUE(step_times(scene).empty());
}

TEST(MovingBodies, are_those_with_unequal_keys_and_their_riders) {
  Scene scene = empty_scene();
  scene.bodies.push_back(moving_body({move_key(0, {}), move_key(10, {1, 0, 0})}));
  scene.bodies.push_back(moving_body({move_key(0, {2, 0, 0}), move_key(9, {2, 0, 0})}));
  scene.bodies.push_back(moving_body({move_key(0, {2, 0, 0})}, 1));
  scene.bodies.push_back(moving_body({}, 2));
  EXPECT_EQ(moving_bodies(scene), (std::vector<bool>{false, true, false, true, false}));
}

TEST(MovingBodies, count_only_what_happens_within_the_interval) {
  Scene scene = empty_scene();
  const std::vector<BodyKey> late = {move_key(0, {}), move_key(10, {}), move_key(20, {1, 0, 0})};
  scene.bodies.push_back(moving_body(late));
  scene.bodies.push_back(moving_body({move_key(-5, {}), move_key(0, {1, 0, 0}), move_key(9, {1, 0, 0})}));
  scene.bodies.push_back(moving_body({move_key(9, {}), move_key(11, {1, 0, 0})}));
  // A step at the very end is seen at the end.
  scene.bodies.push_back(moving_body({move_key(10, {}), move_key(10, {1, 0, 0})}));
  // The curve leaves the equal keys of `late` before 10 on its way to 20.
  scene.bodies.push_back(moving_body(late, 0, Ease::kSmooth));
  EXPECT_EQ(moving_bodies(scene), (std::vector<bool>{false, false, false, true, true, true}));
}

}  // namespace
}  // namespace strad
