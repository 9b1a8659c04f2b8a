// Which sides light reaches: dark insides, lit rooms however they are wound.
#include "solve/prepare/reach.h"

#include <gtest/gtest.h>

#include <algorithm>

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

// A room of 4 x 3 x 2 m with a spotlight in a corner of its ceiling.
Scene lit_room() {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  add_spot(&scene, {3.5, 2.5, 1.9}, {1.5, 1.5, 0.5}, 0.9, 1.2, {1, 1, 1});
  return scene;
}

// Far too small for walks to tell: closed surfaces are dark inside, whichever way they are wound.
TEST(Reach, InsidesOfManySmallBoxesAreDark) {
  Scene scene = lit_room();
  for (int i = 0; i < 200; ++i) {
    const Vec3 l{0.3 + 0.3 * (i % 10), 0.3 + 0.3 * (i / 10 % 5), 0.3 + 0.3 * (i / 50)};
    add_box(&scene, l, l + Vec3{0.01, 0.02, 0.03}, i % 2 == 1,
            i % 3 == 0 ? 0 : add_body(&scene, {0.1, 0, 0}));
  }
  const std::vector<bool> r = reached(scene);
  for (uint32_t i = 0; i < 200; ++i) expect_sides(r, 6 + 6 * i, i % 2 == 0, i % 2 == 1);
}

TEST(Reach, SmallOpenSurfacesAreLitOnBothSides) {
  Scene scene = lit_room();
  const auto first = static_cast<uint32_t>(scene.polygons.size());
  for (int i = 0; i < 200; ++i) {
    const Vec3 at{0.3 + 0.3 * (i % 10), 0.3 + 0.3 * (i / 10 % 5), 0.3 + 0.3 * (i / 50)};
    add_polygon(&scene, {at, at + Vec3{0.01, 0, 0}, at + Vec3{0.01, 0, 0.01}, at + Vec3{0, 0, 0.01}});
    // A box without its lid: five sides that share edges, not all of them.
    add_box(&scene, at + Vec3{0.1, 0, 0}, at + Vec3{0.12, 0.02, 0.02}, false);
    std::swap(scene.polygons.back(), scene.polygons[scene.polygons.size() - 5]);
    scene.polygons.pop_back();
  }
  const std::vector<bool> r = reached(scene);
  for (uint32_t p = first; p < scene.polygons.size(); ++p) {
    EXPECT_TRUE(r[2 * p]) << p;
    EXPECT_TRUE(r[2 * p + 1]) << p;
  }
}

TEST(Reach, ALampInsideASmallBoxLightsItsInside) {
  Scene scene = lit_room();
  const uint32_t lantern = add_box(&scene, {1, 1, 0.5}, {1.04, 1.04, 0.54}, false);
  const uint32_t other = add_box(&scene, {2, 1, 0.5}, {2.04, 1.04, 0.54}, false);
  add_spot(&scene, {1.02, 1.02, 0.53}, {1.02, 1.02, 0}, 0.5, 0.9, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  expect_sides(r, lantern, true, true);
  expect_sides(r, other, true, false);
}

// A wall across x between two y, z from 0 to 2, 0.1 m thick.
void add_wall(Scene* scene, double x, double y0, double y1) {
  add_box(scene, {x, y0, 0}, {x + 0.1, y1, 2}, false);
}

// The last of three rooms, with doors at opposite ends of the walls between: some light gets there, by many
// reflections. Its lamp hangs in the first.
TEST(Reach, ARoomBehindTwoDoorsIsLit) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {12, 6, 2}, true);
  add_wall(&scene, 4, 0, 5.6);
  add_wall(&scene, 8, 0.4, 6);
  const uint32_t book = add_box(&scene, {11.5, 5, 1}, {11.55, 5.2, 1.3}, false);
  add_spot(&scene, {1, 1, 1.9}, {1, 1, 0}, 0.3, 0.5, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  expect_sides(r, 0, true, false);
  expect_sides(r, book, true, false);
}

// Five sides of a box, open towards the floor that it stands on: sealed by contact, not by edges.
TEST(Reach, TheInsideOfACoverOnTheFloorIsDark) {
  Scene scene = lit_room();
  const auto cover = static_cast<uint32_t>(scene.polygons.size());
  add_box(&scene, {1, 1, 0}, {2, 2, 0.5}, false);
  // The bottom is the one whose corners all lie on the floor.
  const auto bottom =
      std::find_if(scene.polygons.begin() + cover, scene.polygons.end(), [&](const Polygon& p) {
        for (int c = 0; c < p.corner_count(); ++c)
          if (scene.vertices[p.corners[c]].z != 0) return false;
        return true;
      });
  ASSERT_NE(bottom, scene.polygons.end());
  scene.polygons.erase(bottom);
  const std::vector<bool> r = reached(scene);
  for (uint32_t p = cover; p < cover + 5; ++p) {
    EXPECT_TRUE(r[2 * p]) << p;
    EXPECT_FALSE(r[2 * p + 1]) << p;
  }
}

// A tile of a floor with a box on all of it.
TEST(Reach, WhatIsCoveredIsDark) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  scene.polygons.erase(std::find_if(scene.polygons.begin(), scene.polygons.end(), [&](const Polygon& p) {
    for (int c = 0; c < p.corner_count(); ++c)
      if (scene.vertices[p.corners[c]].z != 0) return false;
    return true;
  }));
  const auto first = static_cast<uint32_t>(scene.polygons.size());
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 3; ++y) {
      const Vec3 at{1.0 * x, 1.0 * y, 0};
      add_polygon(&scene, {at, at + Vec3{1, 0, 0}, at + Vec3{1, 1, 0}, at + Vec3{0, 1, 0}});
    }
  add_box(&scene, {1, 1, 0}, {2, 2, 0.5}, false);
  add_spot(&scene, {3.5, 2.5, 1.9}, {1.5, 1.5, 0.5}, 0.9, 1.2, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  for (uint32_t tile = 0; tile < 12; ++tile) EXPECT_EQ(r[2 * (first + tile)], tile != 4) << tile;
}

// A box of 20 x 20 x 20 cm in a hall of 20 x 20 x 5 m, less than a thousandth of all area, with a slot of 1
// cm along one edge of its top: few walks from inside find the way out.
TEST(Reach, ASmallBoxWithASlotIsLitInside) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {20, 20, 5}, true);
  const uint32_t box = add_box(&scene, {9, 9, 1}, {9.2, 9.2, 1.2}, false);
  const auto top = std::find_if(scene.polygons.begin() + box, scene.polygons.end(), [&](const Polygon& p) {
    for (int c = 0; c < p.corner_count(); ++c)
      if (scene.vertices[p.corners[c]].z != 1.2) return false;
    return true;
  });
  ASSERT_NE(top, scene.polygons.end());
  scene.polygons.erase(top);
  add_polygon(&scene, {{9, 9, 1.2}, {9.19, 9, 1.2}, {9.19, 9.2, 1.2}, {9, 9.2, 1.2}});
  add_spot(&scene, {5, 5, 4.9}, {5, 5, 0}, 0.9, 1.2, {1, 1, 1});
  const std::vector<bool> r = reached(scene);
  for (uint32_t p = box; p < box + 6; ++p) {
    EXPECT_TRUE(r[2 * p]) << p;
    EXPECT_TRUE(r[2 * p + 1]) << p;
  }
}

}  // namespace
}  // namespace strad
