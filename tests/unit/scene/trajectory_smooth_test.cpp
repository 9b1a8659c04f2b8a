// Smooth easing: passes through every key, has no kinks, and does not cross steps.
#include <gtest/gtest.h>

#include "scene/trajectory.h"

namespace strad {
namespace {

BodyKey key_at(double time, Vec3 move, double turn) {
  return {.time = time, .move = move, .turn = turn, .has_quat = false, .quat = {}};
}

Scene scene_of(std::vector<BodyKey> keys) {
  Scene scene;
  scene.end = 10;
  Body body;
  body.axis = {0, 0, 1};
  body.ease = Ease::kSmooth;
  body.keys = std::move(keys);
  scene.bodies.push_back(body);
  return scene;
}

Scene uneven_scene() {
  return scene_of({key_at(1, {0, 0, 0}, 0), key_at(2, {1, 3, 0}, 2), key_at(5, {4, 3, -1}, 1),
                   key_at(5.5, {4, 0, 2}, 9), key_at(9, {0, 0, 2}, 8)});
}

Scene tumbling_scene() {
  Scene scene = uneven_scene();
  const Vec3 axes[] = {{1, 0, 0}, normalized({1, 1, 0}), normalized({0, 2, 1})};
  for (size_t i = 1; i < 4; ++i) {
    scene.bodies[1].keys[i].has_quat = true;
    scene.bodies[1].keys[i].quat = rotation_about(axes[i - 1], 1.0 + static_cast<double>(i));
  }
  return scene;
}

Vec3 place_of(const Scene& scene, double time) { return poses_at(scene, time)[1] * Vec3{1, 2, 3}; }

// One-sided velocities by differences; their own error is about the step times the acceleration.
constexpr double kStep = 1e-6;
Vec3 velocity_before(const Scene& scene, double time) {
  return (place_of(scene, time) - place_of(scene, time - kStep)) / kStep;
}
Vec3 velocity_after(const Scene& scene, double time) {
  return (place_of(scene, time + kStep) - place_of(scene, time)) / kStep;
}

void expect_no_kinks(const Scene& scene) {
  for (const BodyKey& key : scene.bodies[1].keys)
    EXPECT_LE(length(velocity_after(scene, key.time) - velocity_before(scene, key.time)), 1e-3) << key.time;
}

TEST(Smooth, passes_through_every_key) {
  const Scene scene = uneven_scene();
  for (const BodyKey& key : scene.bodies[1].keys) {
    const Vec3 expected = key.move + rotate(rotation_about({0, 0, 1}, key.turn), {1, 2, 3});
    EXPECT_LE(length(place_of(scene, key.time) - expected), 1e-12);
    EXPECT_LE(length(place_of(scene, key.time - 1e-9) - expected), 1e-6);
  }
}

TEST(Smooth, has_no_kink_at_turns) { expect_no_kinks(uneven_scene()); }
TEST(Smooth, has_no_kink_at_quaternions) { expect_no_kinks(tumbling_scene()); }

// The linear curve has kinks that the same test sees.
TEST(Smooth, linear_has_kinks) {
  Scene scene = uneven_scene();
  scene.bodies[1].ease = Ease::kLinear;
  EXPECT_GT(length(velocity_after(scene, 5) - velocity_before(scene, 5)), 1);
}

TEST(Smooth, starts_and_ends_at_rest) {
  const Scene scene = tumbling_scene();
  EXPECT_LE(length(velocity_after(scene, 1)), 1e-3);
  EXPECT_LE(length(velocity_before(scene, 9)), 1e-3);
}

// Two keys: no velocity at either, so the cubic 3 u^2 - 2 u^3.
TEST(Smooth, between_two_keys_is_the_smooth_step) {
  const Scene scene = scene_of({key_at(0, {}, 0), key_at(8, {8, 0, 0}, 0)});
  EXPECT_NEAR(poses_at(scene, 2)[1].translation.x, 8 * (3.0 / 16 - 2.0 / 64), 1e-12);
}

// At an inner key of a straight motion at constant speed Catmull-Rom keeps that speed.
TEST(Smooth, keeps_constant_speed_between_inner_keys) {
  const Scene scene = scene_of(
      {key_at(0, {0, 0, 0}, 0), key_at(1, {1, 0, 0}, 1), key_at(4, {4, 0, 0}, 4), key_at(6, {6, 0, 0}, 6)});
  for (const double time : {1.0, 1.7, 2.5, 3.9}) {
    const Pose pose = poses_at(scene, time)[1];
    EXPECT_NEAR(pose.translation.x, time, 1e-12);
    EXPECT_LE(length(rotate(pose, {1, 0, 0}) - Vec3{std::cos(time), std::sin(time), 0}), 1e-12);
  }
}

// More than a whole turn between smooth keys is kept, as it is between linear ones.
TEST(Smooth, counts_whole_rounds) {
  const Scene scene = scene_of({key_at(0, {}, 0), key_at(8, {}, 8 * kPi)});
  // Smooth step of 4 rounds at a quarter of the time: 4 * 0.15625 = 0.625 rounds.
  const double angle = 0.625 * 2 * kPi;
  EXPECT_LE(length(rotate(poses_at(scene, 2)[1], {1, 0, 0}) - Vec3{std::cos(angle), std::sin(angle), 0}),
            1e-12);
}

TEST(Smooth, does_not_look_across_a_step) {
  const std::vector<BodyKey> before = {key_at(0, {}, 0), key_at(2, {1, 0, 0}, 1), key_at(5, {2, 0, 0}, 0)};
  std::vector<BodyKey> stepped = before;
  stepped.push_back(key_at(5, {-50, 9, 9}, -7));
  stepped.push_back(key_at(9, {-60, 9, 9}, -9));
  const Scene with = scene_of(stepped), without = scene_of(before);
  for (const double time : {0.5, 3.0, 4.9}) EXPECT_EQ(poses_at(with, time)[1], poses_at(without, time)[1]);
  const Scene after = scene_of({stepped[3], stepped[4]});
  for (const double time : {5.0, 6.0, 8.0}) EXPECT_EQ(poses_at(with, time)[1], poses_at(after, time)[1]);
}

TEST(Smooth, rests_between_equal_keys) {
  const Scene scene = scene_of({key_at(0, {1, 2, 3}, 1), key_at(4, {1, 2, 3}, 1), key_at(9, {1, 2, 3}, 1)});
  EXPECT_EQ(poses_at(scene, 3)[1], poses_at(scene, 0)[1]);
  EXPECT_FALSE(moving_bodies(scene)[1]);
}

}  // namespace
}  // namespace strad
