// Direct light at a point: emitters and spots, shadows, glows.
#include <gtest/gtest.h>

#include <cmath>

#include "light/direct.h"
#include "light_test_scene.h"

namespace strad {
namespace {

constexpr int kSamples = 1024;
const SurfacePoint kOrigin{{0, 0, 0}, {0, 0, 1}, kNone};

// Irradiance at the origin from a rectangle [x0, x1] x [y0, y1] at height h with radiance 1.
double from_rectangle(double x0, double x1, double y0, double y1, double h) {
  const auto g = [&](double x, double y) {
    const double u = x / h, v = y / h, ru = std::sqrt(1 + u * u), rv = std::sqrt(1 + v * v);
    return 0.5 * (u / ru * std::atan(v / ru) + v / rv * std::atan(u / rv));
  };
  return g(x1, y1) - g(x0, y1) - g(x1, y0) + g(x0, y0);
}

// Faces down.
uint32_t add_lamp(Scene* scene, double x0, double x1, double y0, double y1, double h, Rgb emission,
                  uint32_t body = 0) {
  return add_polygon(scene, {{x0, y0, h}, {x0, y1, h}, {x1, y1, h}, {x1, y0, h}}, body, {}, emission);
}

Rgb light_at(const Scene& scene, const SurfacePoint& point, double time = 0, uint64_t seed = 1) {
  const Tracer tracer(scene);
  return DirectLight(scene, tracer).irradiance(instant_at(scene, time), point, kSamples, seed);
}

TEST(DirectLight, SquareLampOverAFloor) {
  Scene scene;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 2, {3, 2, 1});
  add_polygon(&scene, {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  const double e = from_rectangle(-0.5, 0.5, -0.5, 0.5, 2);
  const Rgb light = light_at(scene, kOrigin);
  EXPECT_NEAR(light.r, 3 * e, 1e-5);
  EXPECT_NEAR(light.g, 2 * e, 1e-5);
  EXPECT_NEAR(light.b, 1 * e, 1e-5);
}

TEST(DirectLight, ALampGivesNothingBehindItself) {
  Scene scene;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, -1, {1, 1, 1});  // below the point, facing down
  EXPECT_TRUE(is_black(light_at(scene, {{0, 0, 0}, {0, 0, -1}, kNone})));
  Scene above;
  add_lamp(&above, -0.5, 0.5, -0.5, 0.5, 1, {1, 1, 1});
  EXPECT_FALSE(is_black(light_at(above, kOrigin)));
  EXPECT_TRUE(is_black(light_at(above, {{0, 0, 0}, {0, 0, -1}, kNone})));
}

TEST(DirectLight, ALampDoesNotLightItself) {
  Scene scene;
  const uint32_t lamp = add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 1, {1, 1, 1});
  EXPECT_TRUE(is_black(light_at(scene, {{0, 0, 1}, {0, 0, -1}, lamp})));
}

// A plate half-way covers, seen from the origin, the part of the lamp with x > 0.1: what is left is a
// rectangle, too.
TEST(DirectLight, APlateLeavesTheRestOfTheLamp) {
  Scene scene;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 2, {1, 1, 1});
  add_polygon(&scene, {{0.05, -1, 1}, {1, -1, 1}, {1, 1, 1}, {0.05, 1, 1}});
  const double left = from_rectangle(-0.5, 0.1, -0.5, 0.5, 2);
  EXPECT_NEAR(light_at(scene, kOrigin).r, left, 0.01 * left);
}

TEST(DirectLight, ACoveredLampIsDark) {
  Scene scene;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 2, {1, 1, 1});
  add_spot(&scene, {0, 0, 2}, {0, 0, 0}, 0.2, 0.3, {1, 1, 1});
  add_polygon(&scene, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
  EXPECT_TRUE(is_black(light_at(scene, kOrigin)));
}

TEST(DirectLight, GlowScalesEmission) {
  Scene scene;
  scene.end = 10;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 2, {1, 1, 1});
  scene.glows.push_back({0, {{0, 1}, {10, 0}}});
  const double e = from_rectangle(-0.5, 0.5, -0.5, 0.5, 2);
  EXPECT_NEAR(light_at(scene, kOrigin, 4).r, 0.6 * e, 1e-5);
  EXPECT_TRUE(is_black(light_at(scene, kOrigin, 10)));
}

TEST(DirectLight, ALampOnABodyMoves) {
  Scene scene;
  scene.end = 10;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 1, {1, 1, 1}, add_body(&scene, {0, 0, 5}));
  for (const double time : {0.0, 2.5, 10.0}) {
    const double e = from_rectangle(-0.5, 0.5, -0.5, 0.5, 1 + time / 2);
    EXPECT_NEAR(light_at(scene, kOrigin, time).r, e, 1e-5 * e);
  }
}

// E = I cos / r^2: at (0, 0, 0) from (3, 0, 4) the distance is 5, the cosine 4/5.
TEST(DirectLight, SpotFallsWithTheSquareOfTheDistance) {
  Scene scene;
  add_spot(&scene, {3, 0, 4}, {0, 0, 0}, 0.1, 0.2, {50, 25, 0});
  add_polygon(&scene, {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  const Rgb light = light_at(scene, kOrigin);
  EXPECT_NEAR(light.r, 50 * 0.8 / 25, 1e-5);
  EXPECT_NEAR(light.g, 25 * 0.8 / 25, 1e-5);
  EXPECT_EQ(light.b, 0);
  EXPECT_TRUE(is_black(light_at(scene, {{0, 0, 0}, {0, 0, -1}, kNone})));  // from below
  EXPECT_TRUE(is_black(light_at(scene, {{0, 2, 0}, {0, 0, 1}, kNone})));   // outside the cone
}

TEST(DirectLight, TheSameSeedGivesTheSameLight) {
  Scene scene;
  add_lamp(&scene, -0.5, 0.5, -0.5, 0.5, 2, {1, 1, 1});
  add_polygon(&scene, {{0.05, -1, 1}, {1, -1, 1}, {1, 1, 1}, {0.05, 1, 1}});
  EXPECT_EQ(light_at(scene, kOrigin, 0, 7), light_at(scene, kOrigin, 0, 7));
}

}  // namespace
}  // namespace strad
