// Positions on polygons and on a refined mesh.
#include "solution/mesh.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

Scene scene_of(std::vector<Vec3> corners) {
  Scene scene;
  scene.vertices = std::move(corners);
  Polygon polygon;
  for (uint32_t i = 0; i < scene.vertices.size(); ++i) polygon.corners[i] = i;
  scene.polygons.push_back(polygon);
  return scene;
}
Scene triangle_scene() { return scene_of({{1, 0, 2}, {4, 1, 2}, {2, 5, 3}}); }
Scene parallelogram_scene() { return scene_of({{0, 1, 0}, {2, 1, 0}, {3, 1, -4}, {1, 1, -4}}); }
Scene kite_scene() { return scene_of({{0, 0, 1}, {5, 1, 1}, {4, 3, 1}, {1, 2, 1}}); }

void expect_round_trip(const Scene& scene, Vec2 uv) {
  const Polygon& polygon = scene.polygons[0];
  const Vec2 back = parametric_of(scene, polygon, point_of(scene, polygon, uv));
  EXPECT_NEAR(back.x, uv.x, 1e-12);
  EXPECT_NEAR(back.y, uv.y, 1e-12);
}

TEST(Mesh, ParametricInvertsPoint) {
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const Vec2 uv{i / 8.0, j / 8.0};
      expect_round_trip(parallelogram_scene(), uv);
      expect_round_trip(kite_scene(), uv);
      if (i + j <= 8) expect_round_trip(triangle_scene(), uv);
    }
  }
}

TEST(Mesh, ParametricOfEitherWinding) {
  expect_round_trip(scene_of({{0, 0, 1}, {1, 2, 1}, {4, 3, 1}, {5, 1, 1}}), {0.3, 0.8});
  expect_round_trip(scene_of({{1, 0, 2}, {2, 5, 3}, {4, 1, 2}}), {0.3, 0.2});
}

TEST(Mesh, ParametricClampsIntoPolygon) {
  const Scene quad = parallelogram_scene();
  const Vec2 beyond = parametric_of(quad, quad.polygons[0], {10, 1, 10});
  EXPECT_EQ(beyond, (Vec2{1, 0}));
  const Scene triangle = triangle_scene();
  const Vec2 far = parametric_of(triangle, triangle.polygons[0], {100, 200, 0});
  EXPECT_GE(far.x, 0);
  EXPECT_GE(far.y, 0);
  EXPECT_LE(far.x + far.y, 1 + 1e-12);
}

TEST(Mesh, DegeneratePolygonsGiveFinitePositions) {
  const Scene line = scene_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  const Vec2 uv = parametric_of(line, line.polygons[0], {1, 0, 0});
  EXPECT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
  const Scene point = scene_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  const Vec2 none = parametric_of(point, point.polygons[0], {1, 1, 1});
  EXPECT_TRUE(std::isfinite(none.x) && std::isfinite(none.y));
}

TEST(Mesh, NormalAndArea) {
  const Scene quad = parallelogram_scene();  // base 2 along x, 4 along -z: normal x cross -z = +y, area 8
  EXPECT_NEAR(length(polygon_normal(quad, quad.polygons[0]) - Vec3{0, 1, 0}), 0, 1e-15);
  EXPECT_NEAR(polygon_area(quad, quad.polygons[0]), 8, 1e-12);
  const Scene triangle = scene_of({{0, 0, 0}, {3, 0, 0}, {0, 2, 0}});
  EXPECT_NEAR(length(polygon_normal(triangle, triangle.polygons[0]) - Vec3{0, 0, 1}), 0, 1e-15);
  EXPECT_NEAR(polygon_area(triangle, triangle.polygons[0]), 3, 1e-12);
}

uint32_t midpoint(Mesh* mesh, uint32_t a, uint32_t b) {
  MeshVertex vertex{{a, b, kNone, kNone}, 0.5 * (mesh->vertices[a].position + mesh->vertices[b].position)};
  mesh->vertices.push_back(vertex);
  return static_cast<uint32_t>(mesh->vertices.size() - 1);
}

void set_children(Mesh* mesh, uint32_t parent, const std::vector<std::vector<uint32_t>>& children) {
  mesh->elements[parent].first_child = static_cast<uint32_t>(mesh->elements.size());
  for (const std::vector<uint32_t>& corners : children) {
    Element child;
    std::copy(corners.begin(), corners.end(), child.vertices);
    mesh->elements.push_back(child);
  }
}

void split(Mesh* mesh, uint32_t e) {
  const Element element = mesh->elements[e];
  const uint32_t* v = element.vertices;
  const uint32_t a = midpoint(mesh, v[0], v[1]), b = midpoint(mesh, v[1], v[2]);
  if (element.corner_count() == 3) {
    const uint32_t c = midpoint(mesh, v[2], v[0]);
    return set_children(mesh, e, {{v[0], a, c}, {a, v[1], b}, {c, b, v[2]}, {b, c, a}});
  }
  const uint32_t c = midpoint(mesh, v[2], v[3]), d = midpoint(mesh, v[3], v[0]), m = midpoint(mesh, a, c);
  set_children(mesh, e, {{v[0], a, m, d}, {a, v[1], b, m}, {m, b, v[2], c}, {d, m, c, v[3]}});
}

// The first face, with its root and every fourth element after it split.
Mesh refined_mesh(const Scene& scene) {
  const Polygon& polygon = scene.polygons[0];
  Mesh mesh;
  Element root;
  for (int i = 0; i < polygon.corner_count(); ++i) {
    mesh.vertices.push_back({{kNone, kNone, kNone, kNone}, scene.vertices[polygon.corners[i]]});
    root.vertices[i] = static_cast<uint32_t>(i);
  }
  mesh.elements.push_back(root);
  mesh.faces.push_back({0, 0, 0});
  mesh.face_of_side = {0, kNone};
  split(&mesh, 0);
  for (uint32_t e = 1; e <= 4; ++e) split(&mesh, e);
  split(&mesh, 8);
  return mesh;
}

// Interpolating the vertices' own positions must give the position asked for: a test of descent, of the
// orders of corners and children, and of the weights at once.
void expect_reproduces_positions(const Scene& scene) {
  const Mesh mesh = refined_mesh(scene);
  const bool quad = scene.polygons[0].corner_count() == 4;
  for (int i = 0; i <= 37; ++i) {
    for (int j = 0; j <= (quad ? 37 : 37 - i); ++j) {
      const Vec2 uv{i / 37.0, j / 37.0};
      const MeshPoint point = locate(mesh, 0, uv);
      ASSERT_EQ(mesh.elements[point.element].first_child, kNone);
      Vec3 position;
      float sum = 0;
      for (int k = 0; k < (quad ? 4 : 3); ++k) {
        EXPECT_GE(point.weights[k], -1e-6f);
        sum += point.weights[k];
        position += static_cast<double>(point.weights[k]) * mesh.vertices[point.vertices[k]].position;
      }
      EXPECT_NEAR(sum, 1, 1e-6);
      EXPECT_NEAR(length(position - point_of(scene, scene.polygons[0], uv)), 0, 1e-5);
    }
  }
}
TEST(Mesh, LocateReproducesPositionsOfTriangles) { expect_reproduces_positions(triangle_scene()); }
TEST(Mesh, LocateReproducesPositionsOfQuads) { expect_reproduces_positions(parallelogram_scene()); }
TEST(Mesh, LocateReproducesPositionsOfGeneralQuads) { expect_reproduces_positions(kite_scene()); }

}  // namespace
}  // namespace strad
