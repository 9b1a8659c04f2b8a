// Rigid motions found from points, pieces that move alike, and keys that say as much.
#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"
#include "import/poses/body_keys.h"
#include "import/poses/follow.h"
#include "import/poses/rigid_fit.h"
#include "scene/body_pose.h"

namespace strad {
namespace {

double any(uint64_t seed, uint64_t index) {
  return static_cast<double>(hash_of(seed, index) >> 11) * 0x1p-52 - 1;
}
Vec3 any_point(uint64_t seed, uint64_t i) {
  return {any(seed, 3 * i), any(seed, 3 * i + 1), any(seed, 3 * i + 2)};
}
Pose any_pose(uint64_t seed) {
  const Vec3 axis = normalized(any_point(seed, 100));
  return {rotation_about(axis, kPi * any(seed, 400)), 10 * any_point(seed, 102)};
}

std::vector<Vec3> cloud(uint64_t seed, size_t count, Vec3 scale) {
  std::vector<Vec3> points;
  for (size_t i = 0; i < count; ++i) {
    const Vec3 p = any_point(seed, i);
    points.push_back({scale.x * p.x + 5, scale.y * p.y, scale.z * p.z});
  }
  return points;
}

std::vector<Vec3> moved(const Pose& pose, std::vector<Vec3> points) {
  for (Vec3& p : points) p = pose * p;
  return points;
}

// Solids, flat pieces, needles and a single triangle. Rounding of coordinates up to 20 is
// 2e-15; across a needle a thousand times as long as wide the turn about it amplifies it as often, and
// random triangles are thinner still.
TEST(RigidFit, finds_any_motion_to_rounding) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    for (const Vec3 scale : {Vec3{1, 1, 1}, {1, 1, 0}, {1, 1e-3, 1e-3}, {1e-2, 1e-2, 1e-2}}) {
      for (const size_t count : {size_t{3}, size_t{20}}) {
        const std::vector<Vec3> rest = cloud(seed, count, scale), seen = moved(any_pose(seed), rest);
        EXPECT_LE(fit_error(fit_rigid(rest, seen), rest, seen), 1e-11) << seed;
      }
    }
  }
}

TEST(RigidFit, half_turns_and_none) {
  const std::vector<Vec3> rest = cloud(1, 9, {1, 1, 1});
  for (const Vec3 axis : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const std::vector<Vec3> seen = moved({rotation_about(axis, kPi), {}}, rest);
    EXPECT_LE(fit_error(fit_rigid(rest, seen), rest, seen), 1e-13);
  }
  EXPECT_LE(fit_error(fit_rigid(rest, rest), rest, rest), 1e-14);
  const std::vector<Vec3> one{{1, 2, 3}}, there{{4, 6, 8}};
  EXPECT_EQ(fit_rigid(one, there), (Pose{{}, {3, 4, 5}}));
}

// The best motion of a mirror image is far from it.
TEST(RigidFit, leaves_what_is_not_rigid) {
  const std::vector<Vec3> rest = cloud(3, 20, {1, 1, 1});
  std::vector<Vec3> mirrored = rest, grown = rest;
  for (Vec3& p : mirrored) p.x = -p.x;
  for (Vec3& p : grown) p = 1.001 * p;
  EXPECT_GT(fit_error(fit_rigid(rest, mirrored), rest, mirrored), 0.1);
  EXPECT_GT(fit_error(fit_rigid(rest, grown), rest, grown), 1e-4);
}

// Five pieces: 0 rests, 1 and 3 go together, 2 goes with them until frame 2, then alone; 4 grows at frame 3.
TEST(PoseFollower, groups_what_moves_alike) {
  std::vector<std::vector<Vec3>> rest;
  for (uint64_t piece = 0; piece < 5; ++piece) rest.push_back(cloud(piece, 8, {1, 1, 1}));
  PoseFollower follower({rest.begin(), rest.end()});
  std::vector<std::vector<Vec3>> now = rest;
  std::vector<std::vector<uint32_t>> bent;
  for (uint64_t frame = 1; frame < 5; ++frame) {
    const Pose together = any_pose(frame), alone = any_pose(frame + 100);
    now[1] = moved(together, rest[1]);
    now[3] = moved(together, rest[3]);
    now[2] = moved(frame < 2 ? together : alone, rest[2]);
    if (frame == 3) now[4] = moved({}, rest[4]), now[4][0].x += 0.1;
    bent.push_back(follower.add_frame([&](uint32_t piece) { return std::span<const Vec3>(now[piece]); }));
    if (frame == 3) now[4] = rest[4];
  }
  EXPECT_EQ(bent, (std::vector<std::vector<uint32_t>>{{}, {}, {4}, {}}));
  ASSERT_EQ(follower.groups().size(), 3u);
  EXPECT_EQ(follower.groups()[0].pieces, (std::vector<uint32_t>{0, 4}));
  EXPECT_TRUE(follower.groups()[0].poses.empty());
  const bool swapped = follower.groups()[1].pieces.size() == 1;
  const PoseFollower::Group &together = follower.groups()[swapped ? 2 : 1],
                            &alone = follower.groups()[swapped ? 1 : 2];
  EXPECT_EQ(together.pieces, (std::vector<uint32_t>{1, 3}));
  EXPECT_EQ(alone.pieces, (std::vector<uint32_t>{2}));
  ASSERT_EQ(together.poses.size(), 5u);
  ASSERT_EQ(alone.poses.size(), 5u);
  // What they did before they parted is the same.
  EXPECT_LE(fit_error(alone.poses[1], rest[2], moved(any_pose(1), rest[2])), 1e-12);
}

BodyKey turned(double time, Vec3 move, double turn) { return {time, move, turn, false, {}}; }

// Motion given as a body, sampled at the frames, and found again.
struct Case {
  Box bounds;
  std::vector<double> times;
  std::vector<Pose> poses;
};

Case sampled(const Body& body, int frames) {
  Case made;
  made.bounds.add(Vec3{-1, 0, 1});
  made.bounds.add(Vec3{1, 2, 4});
  for (int i = 0; i < frames; ++i) {
    made.times.push_back(i / 25.0);
    made.poses.push_back(pose_in_parent(body, made.times.back()));
  }
  return made;
}

double worst(const Body& found, const Case& made) {
  double worst = 0;
  for (size_t i = 0; i < made.times.size(); ++i) {
    const Pose pose = pose_in_parent(found, made.times[i]);
    for (const Vec3 p : {made.bounds.lower, made.bounds.upper})
      worst = std::max(worst, length(pose * p - made.poses[i] * p));
  }
  return worst;
}

constexpr double kTolerance = 1e-5;

TEST(BodyKeys, a_crane_has_two_keys_about_its_pivot) {
  Body crane{
      "", 0, {0.5, 0, 3}, {0, 0, 1}, Ease::kLinear, {turned(0, {}, 0), turned(4, {2, 0, 0}, 450 * kDegree)},
      {}};
  const Case made = sampled(crane, 101);
  const Body found = body_with_keys(made.poses, made.times, {made.bounds, kTolerance});
  ASSERT_EQ(found.keys.size(), 2u);
  EXPECT_NEAR(found.pivot.x, 0.5, 1e-11);
  EXPECT_NEAR(found.pivot.y, 0, 1e-11);
  EXPECT_EQ(found.axis, (Vec3{0, 0, 1}));
  EXPECT_NEAR(found.keys[1].turn, 450 * kDegree, 1e-11);  // more than a whole turn
  EXPECT_NEAR(found.keys[1].move.x, 2, 1e-11);
  EXPECT_LE(worst(found, made), 1e-11);
}

// It starts, stops, turns back: a key where each happens, and the pivot is not drawn away by them.
TEST(BodyKeys, starts_and_stops_have_keys) {
  Body cart{"", 0, {1, 2, 3}, {0, 1, 0}, Ease::kLinear, {}, {}};
  cart.keys = {turned(0.4, {}, 0), turned(1.2, {1, 0, 0}, 0.5), turned(2, {1, 0, 0}, 0.5),
               turned(3.6, {0, 0, 1}, -2)};
  const Case made = sampled(cart, 101);
  const Body found = body_with_keys(made.poses, made.times, {made.bounds, kTolerance});
  EXPECT_EQ(found.keys.size(), 5u);  // the first at 0, where it rests
  EXPECT_LE(worst(found, made), 1e-9);
}

TEST(BodyKeys, a_body_that_does_not_turn_has_no_pivot) {
  Body lift{"", 0, {}, {0, 1, 0}, Ease::kLinear, {turned(0, {}, 0), turned(4, {0, 3, 0}, 0)}, {}};
  const Case made = sampled(lift, 101);
  const Body found = body_with_keys(made.poses, made.times, {made.bounds, kTolerance});
  EXPECT_EQ(found.pivot, (Vec3{}));
  ASSERT_EQ(found.keys.size(), 2u);
  EXPECT_EQ(found.keys[1].move, (Vec3{0, 3, 0}));
}

// A pendulum under way at both ends needs a key a frame with linear easing, and few with smooth easing;
// between the frames it is then where it should be, too.
TEST(BodyKeys, a_pendulum_is_smooth) {
  Case made;
  made.bounds.add(Vec3{-0.1, -2, -0.1});
  made.bounds.add(Vec3{0.1, 0, 0.1});
  const auto pose_at = [](double t) {
    return Pose{rotation_about({0, 0, 1}, 0.5 * std::sin(1.6 * t + 0.4)), {}};
  };
  for (int i = 0; i < 250; ++i) made.times.push_back(i / 25.0), made.poses.push_back(pose_at(i / 25.0));
  const double tolerance = 1e-5 * made.bounds.diagonal();
  const Body found = body_with_keys(made.poses, made.times, {made.bounds, tolerance});
  EXPECT_EQ(found.ease, Ease::kSmooth);
  EXPECT_LT(found.keys.size(), 225u);
  EXPECT_LE(worst(found, made), tolerance);
  for (uint64_t i = 0; i < 200; ++i) {
    const double t = 9.96 * (any(9, i) + 1) / 2;
    const Vec3 p = made.bounds.lower;
    EXPECT_LE(length(pose_in_parent(found, t) * p - pose_at(t) * p), 2 * tolerance) << t;
  }
}

// Tumbling about changing axes: quaternions.
TEST(BodyKeys, tumbling_has_quaternions) {
  Body tumbling{"", 0, {0, 1, 2}, {0, 1, 0}, Ease::kLinear, {}, {}};
  for (uint64_t k = 0; k < 5; ++k) {
    const Quat q = k == 0 ? Quat{} : rotation_about(normalized(any_point(k, 7)), 1);
    tumbling.keys.push_back({static_cast<double>(k), k == 0 ? Vec3{} : any_point(k, 1), 0, true, q});
  }
  const Case made = sampled(tumbling, 101);
  const Body found = body_with_keys(made.poses, made.times, {made.bounds, kTolerance});
  EXPECT_EQ(found.keys.size(), 5u);
  EXPECT_TRUE(found.keys[1].has_quat);
  EXPECT_LE(worst(found, made), 1e-9);
}

}  // namespace
}  // namespace strad
