// Floors are cut under walls, and nowhere else.
#include "solve/prepare/wall_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../light/light_test_scene.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

// A room of 8 x 4 x 3 m with a lamp in its western half. Polygon 0 is the floor.
Scene room() {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {8, 4, 3}, true);
  add_spot(&scene, {2, 2, 2.9}, {2, 2, 0}, 1.2, 1.5, {1, 1, 1});
  return scene;
}

// Polygons of the floor's object, and their area.
struct Floor {
  int pieces = 0;
  double area = 0;
};
Floor floor_of(const Scene& scene) {
  Floor floor;
  for (const Polygon& polygon : scene.polygons) {
    if (polygon.object != 0) continue;
    ++floor.pieces;
    floor.area += polygon_area(scene, polygon);
  }
  return floor;
}

// Does a polygon of the floor reach from one side of x to the other, within y0 to y1?
bool crosses(const Scene& scene, double x, double y0, double y1) {
  return std::any_of(scene.polygons.begin(), scene.polygons.end(), [&](const Polygon& polygon) {
    if (polygon.object != 0) return false;
    Box box;
    for (int c = 0; c < polygon.corner_count(); ++c) box.add(scene.vertices[polygon.corners[c]]);
    return box.lower.x < x - 0.01 && box.upper.x > x + 0.01 && box.lower.y < y1 && box.upper.y > y0;
  });
}

TEST(WallCuts, AnEmptyRoomStaysAsItIs) {
  const Scene before = room(), after = cut_under_walls(before).scene;
  EXPECT_EQ(after.polygons.size(), before.polygons.size());
  EXPECT_EQ(after.vertices.size(), before.vertices.size());
}

// A screen across the room at x = 4 with light on both of its sides (there is a gap above it).
TEST(WallCuts, AFloorIsCutUnderAScreen) {
  Scene scene = room();
  add_polygon(&scene, {{4, 0, 0}, {4, 4, 0}, {4, 4, 2}, {4, 0, 2}});
  EXPECT_TRUE(crosses(scene, 4, 0, 4));
  const Scene cut = cut_under_walls(scene).scene;
  EXPECT_FALSE(crosses(cut, 4, 0, 4));
  const Floor floor = floor_of(cut);
  EXPECT_EQ(floor.pieces, 2);
  EXPECT_NEAR(floor.area, 32, 0.01);  // but for a gap of 2e-6 diagonals
}

// The room is closed: light reaches the inner side of each polygon, the front, and both sides of the screen.
// The two pieces of the floor have from it that their undersides are dark.
TEST(WallCuts, PiecesAreDarkWhereThePolygonWas) {
  Scene scene = room();
  add_polygon(&scene, {{4, 0, 0}, {4, 4, 0}, {4, 4, 2}, {4, 0, 2}});
  const CutScene cut = cut_under_walls(scene);
  ASSERT_EQ(cut.dark.size(), 2 * cut.scene.polygons.size());
  const auto screen = static_cast<uint32_t>(cut.scene.polygons.size()) - 1;
  for (uint32_t p = 0; p < cut.scene.polygons.size(); ++p) {
    EXPECT_FALSE(cut.dark[2 * p]) << p;
    EXPECT_EQ(cut.dark[2 * p + 1], p != screen) << p;
  }
  EXPECT_TRUE(cut_under_walls(room()).dark.empty());  // nothing stands on its floor
}

// A screen that ends at y = 2: the cut goes no farther, so the floor crosses x = 4 beyond and only there.
TEST(WallCuts, ACutEndsWithItsWall) {
  Scene scene = room();
  add_polygon(&scene, {{4, 0, 0}, {4, 2, 0}, {4, 2, 2}, {4, 0, 2}});
  const Scene cut = cut_under_walls(scene).scene;
  EXPECT_FALSE(crosses(cut, 4, 0, 1.9));
  EXPECT_TRUE(crosses(cut, 4, 2.1, 4));
  EXPECT_EQ(floor_of(cut).pieces, 3);
  EXPECT_NEAR(floor_of(cut).area, 32, 0.01);
}

// Two screens at right angles, at x = 4 and, beyond it, at y = 2: three pieces.
TEST(WallCuts, CutsOfSeveralWalls) {
  Scene scene = room();
  add_polygon(&scene, {{4, 0, 0}, {4, 4, 0}, {4, 4, 2}, {4, 0, 2}});
  add_polygon(&scene, {{4, 2, 0}, {8, 2, 0}, {8, 2, 2}, {4, 2, 2}});
  const Floor floor = floor_of(cut_under_walls(scene).scene);
  EXPECT_EQ(floor.pieces, 3);
  EXPECT_NEAR(floor.area, 32, 0.01);
}

// A box of 1 m on the floor is furniture: its sides stand on the floor on both sides of the dark within.
TEST(WallCuts, FurnitureDoesNotCut) {
  Scene scene = room();
  add_box(&scene, {3, 1, 0}, {4, 2, 1}, false);
  EXPECT_EQ(floor_of(cut_under_walls(scene).scene).pieces, 1);
}

// The diagonal is 9.4 m: a step of 0.1 m is lower than a fiftieth, and so is a post of 0.15 m narrower.
TEST(WallCuts, LowAndNarrowThingsDoNotCut) {
  Scene low = room();
  add_polygon(&low, {{4, 0, 0}, {4, 4, 0}, {4, 4, 0.1}, {4, 0, 0.1}});
  EXPECT_EQ(floor_of(cut_under_walls(low).scene).pieces, 1);
  Scene post = room();
  add_polygon(&post, {{4, 2, 0}, {4, 2.15, 0}, {4, 2.15, 2}, {4, 2, 2}});
  EXPECT_EQ(floor_of(cut_under_walls(post).scene).pieces, 1);
}

// The end of a partition, 0.15 m wide, with the lintel of a door against it: less than a fiftieth of the
// diagonal long, but the contact parts the face.
TEST(WallCuts, AJambIsCutUnderItsLintel) {
  Scene scene = room();
  add_box(&scene, {4, 0, 0}, {4.15, 2, 3}, false);
  add_box(&scene, {4, 2, 2}, {4.15, 3, 3}, false);
  add_box(&scene, {4, 3, 0}, {4.15, 4, 3}, false);
  const Scene cut = cut_under_walls(scene).scene;
  int below = 0, above = 0;
  for (const Polygon& polygon : cut.polygons) {
    Box box;
    for (int c = 0; c < polygon.corner_count(); ++c) box.add(cut.vertices[polygon.corners[c]]);
    if (box.lower.y < 1.99 || box.upper.y > 2.01 || box.upper.x > 4.2) continue;
    below += box.lower.z < 0.01 && box.upper.z < 2.01;
    above += box.lower.z > 1.99;
    EXPECT_FALSE(box.lower.z < 1.9 && box.upper.z > 2.1);
  }
  EXPECT_EQ(below, 1);
  EXPECT_EQ(above, 2);  // the rest of the jamb, and the end of the lintel
}

TEST(WallCuts, WhatMovesDoesNotCut) {
  Scene scene = room();
  const uint32_t body = add_body(&scene, {0.5, 0, 0});
  add_polygon(&scene, {{4, 0, 0}, {4, 4, 0}, {4, 4, 2}, {4, 0, 2}}, body);
  EXPECT_EQ(floor_of(cut_under_walls(scene).scene).pieces, 1);
}

// A screen that hangs 0.1 m above the floor lets light pass below it.
TEST(WallCuts, WhatHangsDoesNotCut) {
  Scene scene = room();
  add_polygon(&scene, {{4, 0, 0.1}, {4, 4, 0.1}, {4, 4, 2}, {4, 0, 2}});
  EXPECT_EQ(floor_of(cut_under_walls(scene).scene).pieces, 1);
}

}  // namespace
}  // namespace strad
