// Pieces of a polygon cover it, keep its texture coordinates, and have a gap between them if asked for.
#include "scene/polygon_pieces.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

// A textured rectangle of 4 x 2 in the plane z = 1.
struct Table {
  Scene scene;
  Polygon polygon;
  Table() {
    scene.objects.push_back({"table", 0});
    scene.materials.emplace_back();
    for (const Vec2 uv : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
      polygon.corners[scene.vertices.size()] = polygon.uvs[scene.vertices.size()] =
          static_cast<uint32_t>(scene.vertices.size());
      scene.vertices.push_back({4 * uv.x, 2 * uv.y, 1});
      scene.uvs.push_back(uv);
    }
  }
};

double area_of(const Piece& piece) {
  Vec3 twice;
  for (size_t i = 2; i < piece.size(); ++i)
    twice += cross(piece[i - 1].position - piece[0].position, piece[i].position - piece[0].position);
  return 0.5 * twice.z;
}

TEST(PolygonPieces, FillThePolygon) {
  const Table table;
  const Piece whole = uncut_piece(table.scene, table.polygon);
  const Vec3 normal = normalized({1, 0.3, 0});
  for (const double offset : {0.1, 0.7, 1.9, 3.8, 4.2}) {
    const Halves halves = split(whole, normal, offset, 1e-6, 0);
    EXPECT_NEAR(area_of(halves.below) + area_of(halves.above), 8, 1e-9) << offset;
    for (const PieceCorner& corner : halves.below) EXPECT_LE(dot(normal, corner.position), offset + 1e-9);
    for (const PieceCorner& corner : halves.above) EXPECT_GE(dot(normal, corner.position), offset - 1e-9);
    for (const Piece& half : {halves.below, halves.above})
      for (const PieceCorner& corner : half) {
        EXPECT_NEAR(corner.uv.x, corner.position.x / 4, 1e-12);
        EXPECT_NEAR(corner.uv.y, corner.position.y / 2, 1e-12);
        EXPECT_EQ(corner.position.z, 1);
      }
  }
}

TEST(PolygonPieces, WhatThePlaneOnlyTouchesStaysWhole) {
  const Table table;
  const Piece whole = uncut_piece(table.scene, table.polygon);
  EXPECT_TRUE(split(whole, {1, 0, 0}, 0, 1e-6, 1e-5).below.empty());
  EXPECT_EQ(split(whole, {1, 0, 0}, 0, 1e-6, 1e-5).above.size(), 4u);
  EXPECT_TRUE(split(whole, {1, 0, 0}, 4, 1e-6, 1e-5).above.empty());
  EXPECT_TRUE(split(whole, {1, 0, 0}, 7, 1e-6, 1e-5).above.empty());
}

TEST(PolygonPieces, TheGapParts) {
  const Table table;
  const Halves halves = split(uncut_piece(table.scene, table.polygon), {0, 1, 0}, 1, 1e-6, 0.01);
  for (const PieceCorner& corner : halves.below) EXPECT_LE(corner.position.y, 0.99 + 1e-12);
  for (const PieceCorner& corner : halves.above) EXPECT_GE(corner.position.y, 1.01 - 1e-12);
}

TEST(PolygonPieces, BecomeTrianglesAndQuadsOfTheSameObjectAndMaterial) {
  Table table;
  table.polygon.material = 0;
  // A corner is cut off: a triangle and a pentagon, which is a quad and a triangle.
  const Halves halves =
      split(uncut_piece(table.scene, table.polygon), normalized({1, 1, 0}), std::sqrt(0.5), 1e-6, 0);
  ASSERT_EQ(halves.below.size(), 3u);
  ASSERT_EQ(halves.above.size(), 5u);
  const std::vector<Polygon> polygons =
      polygons_of({halves.below, halves.above}, table.polygon, &table.scene);
  ASSERT_EQ(polygons.size(), 3u);
  table.scene.polygons = polygons;
  EXPECT_NO_THROW(validate(table.scene));
  double area = 0;
  for (const Polygon& polygon : polygons) area += area_of(uncut_piece(table.scene, polygon));
  EXPECT_NEAR(area, 8, 1e-5);
}

}  // namespace
}  // namespace strad
