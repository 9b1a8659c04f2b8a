// Points are found in the picture where rays of the camera meet them, and other programs find them there too.
#include "frame/projection.h"

#include <gtest/gtest.h>

#include "frame/camera.h"

namespace strad {
namespace {

const CameraState kCamera{{1, 2, 3}, {-2, 0.5, 7}, {0.1, 1, 0.2}, 0.9};
constexpr uint32_t kWidth = 320, kHeight = 200;

// (x y z 1) M
std::array<double, 4> times(Vec3 p, const Matrix44& m) {
  std::array<double, 4> result{};
  const double row[] = {p.x, p.y, p.z, 1};
  for (size_t column = 0; column < 4; ++column)
    for (size_t k = 0; k < 4; ++k) result[column] += row[k] * m[4 * k + column];
  return result;
}

TEST(Projection, FindsPointsWhereTheCamerasRaysMeetThem) {
  const Projection projection(kCamera, kWidth, kHeight);
  const CameraRays rays(kCamera, kWidth, kHeight);
  for (const Vec2 at : {Vec2{0, 0}, Vec2{160, 100}, Vec2{313.25, 7.5}, Vec2{-40, 260}}) {
    const Vec3 point = rays.from() + 5.5 * rays.direction(at.x, at.y);
    const std::optional<Vec2> pixel = projection.pixel_of(point);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, at.x, 1e-9);
    EXPECT_NEAR(pixel->y, at.y, 1e-9);
  }
  EXPECT_FALSE(projection.pixel_of(kCamera.from - (kCamera.to - kCamera.from)));
  EXPECT_NEAR(projection.depth_of(kCamera.to), length(kCamera.to - kCamera.from), 1e-12);
}

TEST(Projection, MatricesAgreeWithPixels) {
  const Projection projection(kCamera, kWidth, kHeight);
  const Vec3 point{-1.5, 1, 6};
  const std::optional<Vec2> pixel = projection.pixel_of(point);
  const std::array<double, 4> ndc = times(point, projection.ndc_from_world());
  EXPECT_NEAR((ndc[0] / ndc[3] + 1) / 2 * kWidth, pixel->x, 1e-9);
  EXPECT_NEAR((1 - ndc[1] / ndc[3]) / 2 * kHeight, pixel->y, 1e-9);
  // A camera that looks along -z: its depth is -z, and lengths are kept.
  const std::array<double, 4> camera = times(point, projection.camera_from_world());
  EXPECT_NEAR(-camera[2], projection.depth_of(point), 1e-12);
  EXPECT_NEAR(length(Vec3{camera[0], camera[1], camera[2]}), length(point - kCamera.from), 1e-12);
  EXPECT_NEAR(camera[3], 1, 1e-12);
  // The screen 1 m ahead is as wide as the field of view says: 2 tan(0.45) high, 320 / 200 times as wide.
  EXPECT_NEAR(projection.screen_width(), 2 * std::tan(0.45) * 1.6, 1e-12);
}

}  // namespace
}  // namespace strad
