// Vectors, boxes, frames and rigid motions: known values and properties.
#include <gtest/gtest.h>

#include "base/pose.h"

namespace strad {
namespace {

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-12); }

TEST(Vec, CrossIsRightHanded) {
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(normalized(Vec3{}), Vec3{});
  EXPECT_EQ(normalized(Vec3{0, 3, 0}), (Vec3{0, 1, 0}));
}

// The construction switches sign at n.z = 0: both sides, and both poles.
TEST(Vec, FrameIsOrthonormalAndRightHanded) {
  for (const Vec3 n : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0.6, 0, -0.8}, Vec3{0.6, 0.8, 0}}) {
    const Frame frame = frame_about(n);
    EXPECT_NEAR(length(frame.tangent), 1, 1e-12);
    EXPECT_NEAR(dot(frame.tangent, n), 0, 1e-12);
    expect_near(cross(frame.tangent, frame.bitangent), n);
  }
}

TEST(Vec, SegmentMeetsABoxOnlyWithinItsReach) {
  Box box;
  EXPECT_TRUE(box.empty());
  box.add(Vec3{1, -1, -1});
  box.add(Vec3{2, 1, 1});
  EXPECT_TRUE(box.meets({0, 0, 0}, {1, 0, 0}, 1.5));
  EXPECT_FALSE(box.meets({0, 0, 0}, {1, 0, 0}, 0.5));
  EXPECT_FALSE(box.meets({0, 0, 0}, {-1, 0, 0}, 10));
  EXPECT_FALSE(box.meets({0, 2, 0}, {1, 0, 0}, 10));
}

TEST(Pose, QuarterTurnAboutZTakesXToY) {
  expect_near(rotate(rotation_about({0, 0, 1}, kPi / 2), {1, 0, 0}), {0, 1, 0});
}

TEST(Pose, ProductAppliesTheRightFactorFirstAndInverseUndoes) {
  const Pose a{rotation_about({0, 1, 0}, 0.7), {1, 2, 3}};
  const Pose b{rotation_about({0.6, 0.8, 0}, -1.9), {-4, 0, 2}};
  const Vec3 p{0.3, -5, 2};
  expect_near((a * b) * p, a * (b * p));
  expect_near(inverse(a) * (a * p), p);
  expect_near(rotate_back(a, rotate(a, p)), p);
}

}  // namespace
}  // namespace strad
