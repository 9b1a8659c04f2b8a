// Which sides light reaches: dark insides, lit rooms however they are wound.
#include "solve/reach.h"

#include <gtest/gtest.h>

#include "../light/light_test_scene.h"

namespace strad {
namespace {

std::vector<bool> reached(const Scene& scene) {
  const Tracer tracer(scene);
  return reached_sides(scene, tracer, make_time_grid(scene.start, scene.end, {}, 2, 64));
}

void expect_sides(const std::vector<bool>& reached, uint32_t first_polygon, bool front, bool back) {
  for (uint32_t p = first_polygon; p < first_polygon + 6; ++p) {
    EXPECT_EQ(reached[2 * p], front) << "front of polygon " << p;
    EXPECT_EQ(reached[2 * p + 1], back) << "back of polygon " << p;
  }
}

TEST(Reach, TheInsideOfAClosedBoxIsDark) {
  Scene scene;
  scene.end = 1;
  const uint32_t room = add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  const uint32_t box = add_box(&scene, {1, 1, 0.5}, {2, 2, 1.2}, false);
  add_spot(&scene, {3, 2, 1.8}, {1.5, 1.5, 1}, 0.5, 0.9, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  expect_sides(r, room, true, false);
  expect_sides(r, box, true, false);
}

TEST(Reach, ARoomWoundInsideOutIsLit) {
  Scene scene;
  scene.end = 1;
  const uint32_t room = add_box(&scene, {0, 0, 0}, {4, 3, 2}, false);
  add_spot(&scene, {3, 2, 1.8}, {1.5, 1.5, 0}, 0.5, 0.9, {1, 1, 1});
  expect_sides(reached(scene), room, false, true);
}

TEST(Reach, AnEmitterLightsInFrontOfIt) {
  Scene scene;
  scene.end = 1;
  const uint32_t room = add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  const uint32_t box = add_box(&scene, {1, 1, 0.5}, {2, 2, 1.2}, false);
  add_polygon(&scene, {{1, 1, 1.99}, {1, 2, 1.99}, {2, 2, 1.99}, {2, 1, 1.99}}, 0, {}, {5, 5, 5});
  const std::vector<bool> r = reached(scene);
  expect_sides(r, room, true, false);
  expect_sides(r, box, true, false);
}

TEST(Reach, ALampInsideABoxStaysThere) {
  Scene scene;
  scene.end = 1;
  const uint32_t room = add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  const uint32_t box = add_box(&scene, {1, 1, 0.5}, {2, 2, 1.2}, false);
  add_spot(&scene, {1.5, 1.5, 1}, {1.5, 1.5, 0.5}, 0.5, 0.9, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  expect_sides(r, room, false, false);
  expect_sides(r, box, false, true);
}

// A lamp that enters a chamber for the last fifth of the animation only.
TEST(Reach, WhatIsLitForAWhileCounts) {
  Scene scene;
  scene.end = 10;
  const uint32_t first = add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  const uint32_t second = add_box(&scene, {5, 0, 0}, {9, 3, 2}, true);
  add_spot(&scene, {3, 1.5, 1}, {3, 1.5, 0}, 0.5, 0.9, {1, 1, 1});
  SpotKey moved = scene.spots[0].keys[0];
  moved.time = 8;
  scene.spots[0].keys.push_back(moved);
  moved.at.x = moved.aim.x = 7;
  scene.spots[0].keys.push_back(moved);
  const std::vector<bool> r = reached(scene);
  expect_sides(r, first, true, false);
  expect_sides(r, second, true, false);
}

TEST(Reach, WithoutLightAllIsDark) {
  Scene scene;
  scene.end = 1;
  const uint32_t room = add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  expect_sides(reached(scene), room, false, false);
}

// Too small to be met by any walk, yet in the light.
TEST(Reach, TheSmallestSurfaceCounts) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  const uint32_t speck = add_polygon(&scene, {{1, 1, 1}, {1.001, 1, 1}, {1, 1.001, 1}});
  add_spot(&scene, {3, 2, 1.8}, {1.5, 1.5, 0}, 0.5, 0.9, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  EXPECT_TRUE(r[2 * speck]);
  EXPECT_TRUE(r[2 * speck + 1]);
}

}  // namespace
}  // namespace strad
