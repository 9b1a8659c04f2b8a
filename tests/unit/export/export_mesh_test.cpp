// Surfaces as triangles: nothing torn, nothing lost, both sides where both are lit.
#include <gtest/gtest.h>

#include <map>

#include "export/mesh.h"
#include "export_scene.h"

namespace strad {
namespace {

Vec3 area_vector(const ExportBody& body, const std::array<uint32_t, 3>& t) {
  const Vec3 a = body.corners[t[0]].position, b = body.corners[t[1]].position,
             c = body.corners[t[2]].position;
  return 0.5 * cross(b - a, c - a);
}

Vec3 total_area(const ExportBody& body) {
  Vec3 sum;
  for (const auto& triangle : body.triangles) sum += area_vector(body, triangle);
  return sum;
}

const auto kZero = [](Vec3) { return Rgb{}; };
const auto kOne = [](Vec3) { return grey(1); };

TEST(ExportMesh, FlatQuadBecomesTwoTrianglesSeenFromTheFront) {
  const Scene scene = square_scene();
  MeshBuilder builder(scene);
  builder.face(0, 0);
  const auto bodies = export_mesh(scene, lit_slab(scene, builder.take(), kOne, kZero), ExportLight::kAll);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].corners.size(), 4u);
  EXPECT_EQ(bodies[0].triangles.size(), 2u);
  EXPECT_NEAR(total_area(bodies[0]).z, 1, 1e-12);
}

// Light xy on the unit square is what a bilinear quad shows and two triangles cannot: at the centre 1/4, not
// 1/2. Alone, it is cut into quarters, each about its centre; beside another, whose edges must not have new
// corners, about its own.
void expect_twisted(bool alone, size_t corners, size_t triangles) {
  Scene scene = square_scene();
  if (!alone) {  // it goes on to x = 2
    Polygon next = scene.polygons[0];
    next.corners[0] = scene.polygons[0].corners[1];
    next.corners[3] = scene.polygons[0].corners[2];
    for (const auto& [c, y] : {std::pair{1, 0.0}, std::pair{2, 1.0}}) {
      next.corners[c] = static_cast<uint32_t>(scene.vertices.size());
      scene.vertices.push_back({2, y, 0});
    }
    scene.polygons.push_back(next);
  }
  MeshBuilder builder(scene);
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) builder.face(p, 0);
  const Slab slab = lit_slab(
      scene, builder.take(), [](Vec3 p) { return grey(p.x * p.y); }, kZero);
  const auto bodies = export_mesh(scene, slab, ExportLight::kAll);
  EXPECT_EQ(bodies[0].corners.size(), corners);
  EXPECT_EQ(bodies[0].triangles.size(), triangles);
  EXPECT_NEAR(total_area(bodies[0]).z, alone ? 1 : 2, 1e-12);
  const std::vector<Rgb> direct = light_at(slab, 0).direct;
  for (const ExportCorner& corner : bodies[0].corners) {
    EXPECT_NEAR(corner_irradiance(corner, direct).r, corner.position.x * corner.position.y, 1e-6);
  }
}
TEST(ExportMesh, TwistedQuadsAreCutAboutTheirCentres) {
  expect_twisted(true, 9 + 4, 16);
  expect_twisted(false, 6 + 2, 8);
}

// One quarter of the square is split twice more: its vertices hang on the edges of its neighbours.
TEST(ExportMesh, NoTriangleHasACornerOnAnothersEdge) {
  const Scene scene = square_scene();
  MeshBuilder builder(scene);
  builder.face(0, 0);
  builder.split(0);
  builder.split(1);
  builder.split(builder.mesh().elements[1].first_child + 2);
  const auto bowl = [](Vec3 p) { return grey(p.x * p.x + p.y * p.y); };  // of which every vertex matters
  const ExportBody body =
      export_mesh(scene, lit_slab(scene, builder.take(), bowl, kZero), ExportLight::kAll)[0];
  EXPECT_GT(body.triangles.size(), 20u);
  EXPECT_NEAR(total_area(body).z, 1, 1e-12);
  std::map<std::pair<uint32_t, uint32_t>, int> uses;
  for (const auto& t : body.triangles) {
    EXPECT_GT(area_vector(body, t).z, 0);
    for (int i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  }
  for (const auto& [edge, count] : uses) {
    const Vec3 a = body.corners[edge.first].position, b = body.corners[edge.second].position;
    const bool border = (a.x == b.x && (a.x == 0 || a.x == 1)) || (a.y == b.y && (a.y == 0 || a.y == 1));
    EXPECT_EQ(count, border ? 1 : 2) << a.x << "," << a.y << " to " << b.x << "," << b.y;
  }
}

// Light that its neighbours tell needs no vertices; direct light needs none where only indirect light is
// shown.
TEST(ExportMesh, WhatWouldNotShowIsLeftOut) {
  const Scene scene = square_scene();
  MeshBuilder builder(scene);
  builder.face(0, 0);
  builder.split(0);
  builder.split(2);
  const Slab slab = lit_slab(
      scene, builder.take(), [](Vec3 p) { return grey(p.x * p.x); },
      [](Vec3 p) { return grey(p.x + 2 * p.y); });
  EXPECT_EQ(export_mesh(scene, slab, ExportLight::kIndirect)[0].triangles.size(), 2u);
  EXPECT_GT(export_mesh(scene, slab, ExportLight::kAll)[0].triangles.size(), 8u);
}

TEST(ExportMesh, BackLiesBehindTheFrontAndFacesAway) {
  const Scene scene = square_scene();
  MeshBuilder builder(scene);
  builder.face(0, 0);
  builder.face(0, 1);
  const ExportBody body =
      export_mesh(scene, lit_slab(scene, builder.take(), kOne, kZero), ExportLight::kAll)[0];
  ASSERT_EQ(body.corners.size(), 8u);
  int backs = 0;
  for (const auto& triangle : body.triangles) {
    const bool back = area_vector(body, triangle).z < 0;
    for (const uint32_t c : triangle) {
      EXPECT_NEAR(body.corners[c].position.z, back ? -export_lift(scene) : 0, 1e-12);
    }
    backs += back;
  }
  EXPECT_EQ(backs, 2);
}

TEST(ExportMesh, BackAloneStaysInPlace) {
  const Scene scene = square_scene();
  MeshBuilder builder(scene);
  builder.face(0, 1);
  const ExportBody body =
      export_mesh(scene, lit_slab(scene, builder.take(), kOne, kZero), ExportLight::kAll)[0];
  EXPECT_NEAR(total_area(body).z, -1, 1e-12);
  for (const ExportCorner& corner : body.corners) EXPECT_EQ(corner.position.z, 0);
}

TEST(ExportMesh, UnlitPolygonIsThereAndDark) {
  const Scene scene = square_scene();
  const Slab slab = lit_slab(scene, MeshBuilder(scene).take(), kOne, kZero);
  const ExportBody body = export_mesh(scene, slab, ExportLight::kAll)[0];
  EXPECT_NEAR(total_area(body).z, 1, 1e-12);
  for (const ExportCorner& corner : body.corners) EXPECT_EQ(corner_irradiance(corner, {}), Rgb{});
}

TEST(ExportMesh, EmitterLitOnItsBackOnlyShowsBothSides) {
  Scene scene = square_scene();
  scene.materials[0].emission = {1, 1, 1};
  MeshBuilder builder(scene);
  builder.face(0, 1);
  const ExportBody body =
      export_mesh(scene, lit_slab(scene, builder.take(), kOne, kZero), ExportLight::kAll)[0];
  int emitting = 0;
  for (const ExportCorner& corner : body.corners) emitting += corner.emits;
  EXPECT_EQ(emitting, 4);
  EXPECT_EQ(body.corners.size(), 8u);
}

TEST(ExportMesh, CornersAreOrderedByMaterialWithinABody) {
  Scene scene = square_scene();
  scene.vertices.insert(scene.vertices.end(), {{2, 0, 0}, {3, 0, 0}, {3, 1, 0}});
  scene.bodies.push_back({.name = "empty"});
  scene.bodies.push_back({.name = "mover"});
  scene.objects.push_back({.name = "flag", .body = 2});
  scene.materials.push_back({.name = "red", .emission = {}});
  scene.polygons[0].material = 1;
  scene.polygons.push_back({.corners = {4, 5, 6, kNone}, .material = 0, .object = 0});
  scene.polygons.push_back({.corners = {4, 5, 6, kNone}, .material = 0, .object = 1});
  const auto bodies =
      export_mesh(scene, lit_slab(scene, MeshBuilder(scene).take(), kOne, kZero), ExportLight::kAll);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].body, 0u);
  EXPECT_EQ(bodies[1].body, 2u);
  ASSERT_EQ(bodies[0].corners.size(), 7u);
  for (size_t i = 0; i < 7; ++i) EXPECT_EQ(bodies[0].corners[i].material, i < 3 ? 0u : 1u);
  EXPECT_NEAR(total_area(bodies[0]).z, 1.5, 1e-12);
}

}  // namespace
}  // namespace strad
