// Poses of bodies between keys.
#include <gtest/gtest.h>

#include "scene/trajectory.h"

namespace strad {
namespace {

constexpr double kTiny = 1e-12;

BodyKey turn_key(double time, double degrees, Vec3 move = {}) {
  return {.time = time, .move = move, .turn = degrees * kPi / 180, .has_quat = false, .quat = {}};
}
BodyKey quat_key(double time, Quat quat) {
  return {.time = time, .move = {}, .turn = 0, .has_quat = true, .quat = quat};
}

Body body_about(Vec3 axis, std::vector<BodyKey> keys, Ease ease = Ease::kLinear) {
  Body body;
  body.name = "body";
  body.axis = axis;
  body.ease = ease;
  body.keys = std::move(keys);
  return body;
}

// World, then the bodies given.
Scene scene_of(std::vector<Body> bodies) {
  Scene scene;
  scene.end = 10;
  for (Body& body : bodies) scene.bodies.push_back(std::move(body));
  return scene;
}

Pose pose_of(const Body& body, double time) { return poses_at(scene_of({body}), time)[1]; }

void expect_near(Vec3 a, Vec3 b, double tolerance = kTiny) {
  EXPECT_LE(length(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

// The same rotation; q and -q are one.
void expect_same_rotation(Quat a, Quat b, double tolerance = kTiny) {
  const Quat d = conjugate(a) * b;
  EXPECT_LE(length({d.x, d.y, d.z}), tolerance);
}

TEST(Pose, the_world_and_bodies_without_keys_rest) {
  const auto poses = poses_at(scene_of({body_about({0, 1, 0}, {})}), 3);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0], Pose{});
  EXPECT_EQ(poses[1], Pose{});
}

TEST(Pose, turns_about_its_pivot_and_then_moves) {
  Body body = body_about({0, 0, 1}, {turn_key(0, 0), turn_key(10, 180, {0, 0, 8})});
  body.pivot = {1, 0, 0};
  // At half time: 90 degrees about the pivot's vertical, 4 up: (3, 0, 0) is 2 ahead of the pivot, so 2 to its
  // left.
  expect_near(pose_of(body, 5) * Vec3{3, 0, 0}, {1, 2, 4});
}

TEST(Pose, the_pivot_only_moves) {
  Body body = body_about(normalized({1, 2, 3}), {turn_key(0, 0), turn_key(10, 300, {5, 6, 7})});
  body.pivot = {-1, 4, 2};
  expect_near(pose_of(body, 4) * body.pivot, body.pivot + 0.4 * Vec3{5, 6, 7});
}

TEST(Pose, a_body_that_only_moves_is_translated_exactly) {
  Body body = body_about({0, 1, 0}, {turn_key(0, 0, {0.1, 0.2, 0.3})});
  body.pivot = {1e6, 3.3, -7.7};
  EXPECT_EQ(pose_of(body, 0).translation, (Vec3{0.1, 0.2, 0.3}));
}

TEST(Pose, the_parent_carries_the_child) {
  Body base = body_about({0, 0, 1}, {turn_key(0, 90, {0, 0, 1})});
  Body arm = body_about({0, 0, 1}, {turn_key(0, 90, {2, 0, 0})});
  arm.parent = 1;
  const auto poses = poses_at(scene_of({base, arm}), 0);
  // The arm takes (1, 0, 0) to (2, 1, 0); the base turns that to (-1, 2, 0) and lifts it.
  expect_near(poses[2] * Vec3{1, 0, 0}, {-1, 2, 1});
}

TEST(Pose, is_held_before_the_first_and_after_the_last_key) {
  const Body body = body_about({0, 1, 0}, {turn_key(2, 10, {1, 0, 0}), turn_key(4, 20, {2, 0, 0})});
  EXPECT_EQ(pose_of(body, -5), pose_of(body, 2));
  EXPECT_EQ(pose_of(body, 99), pose_of(body, 4));
  EXPECT_EQ(pose_of(body, 99).translation, (Vec3{2, 0, 0}));
}

TEST(Pose, after_a_step_the_later_key_holds_at_that_very_time) {
  const Body body = body_about({0, 1, 0}, {turn_key(0, 0), turn_key(5, 0, {1, 0, 0}),
                                           turn_key(5, 0, {7, 0, 0}), turn_key(10, 0, {8, 0, 0})});
  expect_near(pose_of(body, std::nextafter(5.0, 0.0)).translation, {1, 0, 0});
  EXPECT_EQ(pose_of(body, 5).translation, (Vec3{7, 0, 0}));
}

TEST(Pose, turns_count_whole_rounds) {
  const Body body = body_about({0, 0, 1}, {turn_key(0, 0), turn_key(8, 720)});
  expect_same_rotation(pose_of(body, 1).rotation, rotation_about({0, 0, 1}, kPi / 2));
  expect_same_rotation(pose_of(body, 6).rotation, rotation_about({0, 0, 1}, 3 * kPi));
}

TEST(Pose, quaternions_go_the_shorter_way_at_constant_speed) {
  const Vec3 axis = normalized({1, -1, 2});
  const Quat a = rotation_about({1, 0, 0}, 0.4);
  Quat b = a * rotation_about(axis, 2.0);
  b = {-b.w, -b.x, -b.y, -b.z};  // the same rotation, the longer way round
  const Body body = body_about({0, 1, 0}, {quat_key(0, a), quat_key(10, b)});
  for (const double u : {0.1, 0.35, 0.9})
    expect_same_rotation(pose_of(body, 10 * u).rotation, a * rotation_about(axis, 2.0 * u));
}

TEST(Pose, a_turn_and_a_quaternion_may_follow_each_other) {
  const Quat quarter = rotation_about({1, 0, 0}, kPi / 2);
  const Body body = body_about({0, 0, 1}, {turn_key(0, 360), quat_key(4, quarter), turn_key(8, 90)});
  expect_same_rotation(pose_of(body, 0).rotation, Quat{});
  expect_same_rotation(pose_of(body, 2).rotation, rotation_about({1, 0, 0}, kPi / 4));
  expect_same_rotation(pose_of(body, 4).rotation, quarter);
  expect_same_rotation(pose_of(body, 8).rotation, rotation_about({0, 0, 1}, kPi / 2));
}

TEST(Pose, rotations_stay_of_unit_length) {
  const Body body = body_about(normalized({1, 1, 1}),
                               {turn_key(0, 0), quat_key(3, rotation_about({0, 1, 0}, 2)), turn_key(10, 700)},
                               Ease::kSmooth);
  for (double time = 0; time <= 10; time += 0.37) {
    const Quat q = pose_of(body, time).rotation;
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, kTiny);
  }
}

}  // namespace
}  // namespace strad
