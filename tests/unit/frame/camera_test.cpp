// Rays of a camera.
#include "frame/camera.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

void expect_near(Vec3 a, Vec3 b) { EXPECT_NEAR(length(a - b), 0, 1e-12); }

// 90 degrees high and twice as wide as high: the picture's plane at distance 1 spans y in [-1, 1] and x in
// [-2, 2].
const CameraState kAhead{{1, 2, 3}, {1, 2, -7}, {0, 1, 0}, kPi / 2};

TEST(Camera, MiddleLooksAhead) {
  const CameraRays camera(kAhead, 40, 20);
  expect_near(camera.from(), {1, 2, 3});
  expect_near(camera.direction(20, 10), {0, 0, -1});
}

TEST(Camera, CornersOfThePicture) {
  const CameraRays camera(kAhead, 40, 20);
  expect_near(camera.direction(0, 0), normalized({-2, 1, -1}));  // rows begin at the top
  expect_near(camera.direction(40, 0), normalized({2, 1, -1}));
  expect_near(camera.direction(40, 20), normalized({2, -1, -1}));
}

TEST(Camera, FieldOfViewIsVertical) {
  for (const uint32_t width : {10u, 20u, 80u}) {
    const CameraRays camera(kAhead, width, 20);
    expect_near(camera.direction(width / 2.0, 0), normalized({0, 1, -1}));
  }
}

TEST(Camera, UpNeedNotBeSquareToTheView) {
  const CameraRays camera({{0, 0, 0}, {0, 4, -3}, {0, 1, 0}, 1}, 10, 10);
  expect_near(camera.direction(5, 5), {0, 0.8, -0.6});
  EXPECT_NEAR(camera.direction(0, 5).y, camera.direction(10, 5).y, 1e-12);  // level
  EXPECT_GT(camera.direction(10, 5).x, 0);                                  // right is right
}

}  // namespace
}  // namespace strad
