// Where a solution is checked: spread by area, pixels and time.
#include "frame/check_points.h"

#include <gtest/gtest.h>

#include "synthetic.h"

namespace strad {
namespace {

constexpr uint32_t kCount = 400;
const TimeRange kRange{2, 6};

// A floor of 3 m^2, a shelf of 1 m^2 above it and a black one of 1 m^2; only the floor's and the black one's
// fronts and the shelf's back have a mesh.
Scene shelves() {
  Scene scene;
  add_quad(&scene, {0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0});
  add_quad(&scene, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  add_quad(&scene, {2, 0, 1}, {3, 0, 1}, {3, 1, 1}, {2, 1, 1}, {});
  return scene;
}
const std::vector<bool> kMeshed{true, false, false, true, true, false};

size_t count_of(const std::vector<CheckPoint>& points, uint32_t polygon, bool front) {
  size_t count = 0;
  for (const CheckPoint& point : points)
    count += point.place.polygon == polygon && point.place.front == front;
  return count;
}

TEST(CheckPoints, AreSpreadByArea) {
  const Scene scene = shelves();
  for (uint64_t seed = 0; seed < 5; ++seed) {
    const std::vector<CheckPoint> points = points_by_area(scene, kMeshed, kRange, kCount, seed);
    // 3 of 4 m^2 and 1 of 4 m^2; an eighth as many, 50, on the sides without a mesh.
    EXPECT_NEAR(static_cast<double>(count_of(points, 0, true)), 300, 1);
    EXPECT_NEAR(static_cast<double>(count_of(points, 1, false)), 100, 1);
    EXPECT_NEAR(static_cast<double>(count_of(points, 0, false)), 37.5, 1);
    EXPECT_NEAR(static_cast<double>(count_of(points, 1, true)), 12.5, 1);
    EXPECT_EQ(points.size(), 450u);  // none on the black shelf
    double meshed = 0, unmeshed = 0;
    for (const CheckPoint& point : points) (point.meshed ? meshed : unmeshed) += point.weight;
    EXPECT_NEAR(meshed, 4, 1e-9);
    EXPECT_NEAR(unmeshed, 4, 1e-9);
  }
}

TEST(CheckPoints, AreSpreadOverASideAndOverTime) {
  const Scene scene = shelves();
  size_t left = 0, tenths[10] = {};
  for (const CheckPoint& point : points_by_area(scene, kMeshed, kRange, kCount, 7)) {
    if (!point.meshed) continue;
    ASSERT_GE(point.time, kRange.begin);
    ASSERT_LT(point.time, kRange.end);
    ++tenths[static_cast<int>((point.time - kRange.begin) / (kRange.end - kRange.begin) * 10)];
    left += point.place.polygon == 0 && point.place.rest_point.x < 1;
  }
  for (const size_t tenth : tenths) EXPECT_NEAR(static_cast<double>(tenth), 40, 3);
  // A third of the floor's 300; one deviation of points at random is 8.2.
  EXPECT_NEAR(static_cast<double>(left), 100, 8);
}

TEST(CheckPoints, SeedsDrawOthers) {
  const Scene scene = shelves();
  const auto first = [&](uint64_t seed) {
    return points_by_area(scene, kMeshed, kRange, kCount, seed).front();
  };
  EXPECT_EQ(first(1).place.rest_point, first(1).place.rest_point);
  EXPECT_NE(first(1).place.rest_point, first(2).place.rest_point);
  EXPECT_NE(first(1).time, first(2).time);
}

TEST(CheckPoints, CameraSeesThem) {
  // Straight down from 1 m over the floor's plane, 90 degrees high and wide: a square of 2 x 2 m, of which
  // the floor fills x from 0 to 1 and y from 0 to 1, a quarter; nothing is behind the rest.
  Scene scene;
  add_quad(&scene, {0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0});
  add_camera(&scene, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90);
  const Tracer tracer(scene);
  const Surfaces surfaces(scene, tracer);
  const std::vector<CheckPoint> points =
      points_by_camera(scene, surfaces, scene.cameras[0], {100, 100}, kRange, kCount, 3);
  EXPECT_NEAR(static_cast<double>(points.size()), 100, 5);
  size_t near = 0;
  for (const CheckPoint& point : points) {
    EXPECT_TRUE(point.place.front);
    EXPECT_NEAR(point.place.rest_point.z, 0, 1e-9);
    EXPECT_LE(point.place.rest_point.x, 1 + 1e-9);
    near += point.place.rest_point.x < 0.5;
  }
  EXPECT_NEAR(static_cast<double>(near), 50, 5);
}

}  // namespace
}  // namespace strad
