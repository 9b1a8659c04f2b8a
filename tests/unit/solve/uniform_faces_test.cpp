// Small faces that have one vertex for all their corners: which they are, and that they survive the stream
// and show what they should.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "export/mesh.h"
#include "solution/mesh_io.h"
#include "solution/solution.h"
#include "solve/mesh/mesh_builder.h"
#include "workbench.h"

namespace strad {
namespace {

// A floor of one quad, a ball of small triangles about (2, 2, 1), and n x n small quads in one plane.
constexpr int kFlat = 16;  // a power of 2: corners of neighbours agree to the bit
struct Ball {
  Scene scene;
  uint32_t first_of_ball, first_flat, end;
  explicit Ball(double radius = 0.5) {
    scene.end = 1;
    add_polygon(&scene, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
    first_of_ball = static_cast<uint32_t>(scene.polygons.size());
    const auto at = [&](int i, int j) {
      const double theta = kPi * (i + 1) / 13, phi = 2 * kPi * j / 24;
      return Vec3{2, 2, 1} +
             radius * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    };
    for (int i = 0; i < 11; ++i)
      for (int j = 0; j < 24; ++j) {
        add_polygon(&scene, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        add_polygon(&scene, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    first_flat = static_cast<uint32_t>(scene.polygons.size());
    add_parts(&scene, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, kFlat);
    end = static_cast<uint32_t>(scene.polygons.size());
  }
  Mesh mesh(double below, uint32_t* undivided_faces = nullptr) const {
    MeshBuilder builder(scene);
    std::vector<bool> fronts(2 * scene.polygons.size());
    for (size_t s = 0; s < fronts.size(); s += 2) fronts[s] = true;
    builder.add_faces(fronts, below);
    // The floor in sixteenths.
    const uint32_t floor = builder.mesh().faces[builder.mesh().face_of_side[0]].element;
    if (!is_uniform(builder.mesh().elements[floor])) {
      builder.split(floor);
      for (uint32_t c = 0; c < 4; ++c) builder.split(builder.mesh().elements[floor].first_child + c);
    }
    if (undivided_faces) {
      *undivided_faces = builder.undivided_faces();
      EXPECT_EQ(builder.undivided_vertices(), builder.undivided_faces());  // all of them are uniform
    }
    return builder.take();
  }
};

const Element& root_of(const Mesh& mesh, uint32_t polygon) {
  return mesh.elements[mesh.faces[mesh.face_of_side[2 * polygon]].element];
}

TEST(UniformFaces, SmallFacesOfCurvedSurfacesAre) {
  const Ball ball;
  const Mesh mesh = ball.mesh(0.2);
  EXPECT_FALSE(is_uniform(root_of(mesh, 0)));  // large
  for (uint32_t p = ball.first_of_ball; p < ball.first_flat; ++p) {
    EXPECT_TRUE(is_uniform(root_of(mesh, p))) << p;
    EXPECT_EQ(root_of(mesh, p).corner_count(), 3);
  }
}

// Where neighbours share corners in one plane, one vertex per face saves nothing. Faces at the rim are like
// the others.
TEST(UniformFaces, FineFlatGridsAreNot) {
  const Ball ball;
  const Mesh mesh = ball.mesh(0.2);
  for (int i = 0; i < kFlat; ++i)
    for (int j = 0; j < kFlat; ++j)
      EXPECT_FALSE(is_uniform(root_of(mesh, ball.first_flat + static_cast<uint32_t>(i * kFlat + j))));
}

TEST(UniformFaces, OnlyBelowTheSizeGiven) {
  const Ball ball;
  const Mesh none = ball.mesh(0.01), all = ball.mesh(10);
  for (const Element& element : none.elements) EXPECT_FALSE(is_uniform(element));
  for (uint32_t p = ball.first_of_ball; p < ball.first_flat; ++p) EXPECT_TRUE(is_uniform(root_of(all, p)));
}

// Readers find the function of a uniform face by the face's number.
TEST(UniformFaces, ComeFirstAndInOrder) {
  const Ball ball;
  uint32_t count = 0;
  const Mesh mesh = ball.mesh(0.2, &count);
  EXPECT_GE(count, ball.first_flat - ball.first_of_ball);
  for (uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const Element& root = mesh.elements[mesh.faces[f].element];
    EXPECT_EQ(is_uniform(root), f < count);
    if (f >= count) {
      for (int c = 0; c < root.corner_count(); ++c) EXPECT_GE(root.vertices[c], count);
      continue;
    }
    EXPECT_EQ(root.first_child, kNone);
    for (int c = 0; c < root.corner_count(); ++c) EXPECT_EQ(root.vertices[c], f);
    EXPECT_TRUE(f == 0 || mesh.faces[f].polygon > mesh.faces[f - 1].polygon);
  }
}

// Within the ball each triangle has one across each edge; at its open ends one is missing, so there are none.
TEST(UniformFaces, OfCurvedSurfacesHaveNeighboursAllAround) {
  const Ball ball;
  MeshBuilder builder(ball.scene);
  std::vector<bool> both(2 * ball.scene.polygons.size(), true);
  builder.add_faces(both, 0.2);
  const auto neighbours = builder.curved_neighbours();
  ASSERT_EQ(neighbours.size(), builder.undivided_faces());
  size_t with = 0;
  for (uint32_t f = 0; f < neighbours.size(); ++f) {
    if (neighbours[f].empty()) continue;
    ++with;
    EXPECT_EQ(neighbours[f].size(), 3u);
    for (const uint32_t n : neighbours[f]) {
      EXPECT_EQ(builder.mesh().faces[n].side, builder.mesh().faces[f].side);
      EXPECT_NE(n, f);
    }
  }
  EXPECT_LE(with, 2u * (2 * 11 * 24 - 2 * 24));
  EXPECT_GT(with, 900u);  // a seam of the sphere may be torn by rounding
}

TEST(UniformFaces, NodesHaveTheAreaOfThePolygon) {
  Workbench bench(Ball().scene, 1, 1, Roots::kFaces, 0.2);
  for (const Node& node : bench.nodes->nodes()) {
    const Polygon& polygon = bench.scene.polygons[bench.builder.mesh().faces[node.face].polygon];
    EXPECT_NEAR(node.area, polygon_area(bench.scene, polygon), 1e-6);
    Vec3 centre;
    for (int c = 0; c < polygon.corner_count(); ++c)
      centre += bench.scene.vertices[polygon.corners[c]] / polygon.corner_count();
    EXPECT_LT(length(node.centre - centre), 1e-9);
  }
}

TEST(UniformFaces, ComeBackFromTheStream) {
  const Ball ball;
  const Mesh mesh = ball.mesh(0.2);
  Bytes bytes;
  put_mesh(&bytes, ball.scene, mesh);
  ByteReader reader(bytes, "test");
  const Mesh back = get_mesh(&reader, ball.scene);
  ASSERT_EQ(back.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(back.elements.size(), mesh.elements.size());
  EXPECT_EQ(back.face_of_side, mesh.face_of_side);
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    EXPECT_EQ(back.elements[e].first_child, mesh.elements[e].first_child);
    EXPECT_TRUE(
        std::equal(mesh.elements[e].vertices, mesh.elements[e].vertices + 4, back.elements[e].vertices));
  }
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_EQ(back.vertices[v].position, mesh.vertices[v].position);
  for (size_t length = 0; length < bytes.size(); length += 97) {
    ByteReader cut(ByteSpan(bytes.data(), length), "test");
    EXPECT_ANY_THROW(get_mesh(&cut, ball.scene)) << length;
  }
}

// A still solution in which vertex v has irradiance v.
Slab numbered(const Scene& scene, Mesh mesh) {
  Slab slab;
  slab.grid = make_time_grid(scene.start, scene.end, {}, 1, 1);
  slab.mesh = std::move(mesh);
  slab.direct.order = slab.indirect.order = 1;
  for (size_t v = 0; v < slab.mesh.vertices.size(); ++v) {
    slab.direct.pieces.push_back({0, 0});
    const auto value = static_cast<float>(v);
    slab.direct.coefficients.push_back({value, value, value});
    slab.direct.first_piece.push_back(static_cast<uint32_t>(v + 1));
    slab.indirect.first_piece.push_back(0);
  }
  return slab;
}

TEST(UniformFaces, HaveOneValueAllOver) {
  const Ball ball;
  const Slab slab = numbered(ball.scene, ball.mesh(0.2));
  EXPECT_NO_THROW(validate(ball.scene, Solution{{slab}}));
  const VertexLight light = light_at(slab, 0.5);
  for (uint32_t p = ball.first_of_ball; p < ball.first_flat; p += 7) {
    const uint32_t face = slab.mesh.face_of_side[2 * p];
    for (const Vec2 uv : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0.3, 0.2}, Vec2{0.1, 0.8}, Vec2{0.5, 0.5}}) {
      const MeshPoint point = locate(slab.mesh, face, uv);
      EXPECT_NEAR(direct_at(slab, point, 0.5).g, face, 1e-4 * face + 1e-6);
      float sum = 0, weights = 0;
      for (int k = 0; k < 3; ++k) {
        sum += point.weights[k] * light.direct[point.vertices[k]].g;
        weights += point.weights[k];
      }
      EXPECT_NEAR(weights, 1, 1e-6);
      EXPECT_NEAR(sum, face, 1e-4 * face + 1e-6);
    }
  }
}

TEST(UniformFaces, AreExportedWithTheirOwnCorners) {
  const Ball ball;
  const Slab slab = numbered(ball.scene, ball.mesh(0.2));
  const std::vector<Rgb> direct = light_at(slab, 0.5).direct;
  const std::vector<ExportBody> bodies = export_mesh(ball.scene, slab, ExportLight::kAll);
  ASSERT_EQ(bodies.size(), 1u);
  // Each triangle of the ball, found by its centre, is exported once, as large as its polygon, with its one
  // value of light.
  std::map<std::tuple<long, long, long>, std::pair<double, float>> triangles;
  for (const auto& t : bodies[0].triangles) {
    Vec3 at[3], centre;
    float light = 0;
    for (size_t i = 0; i < 3; ++i) {
      const ExportCorner& corner = bodies[0].corners[t[i]];
      at[i] = corner.position;
      centre += at[i] / 3;
      light += corner_irradiance(corner, direct).r / 3;
    }
    const double area = 0.5 * length(cross(at[1] - at[0], at[2] - at[0]));
    triangles[{std::lround(centre.x * 1e4), std::lround(centre.y * 1e4), std::lround(centre.z * 1e4)}] = {
        area, light};
  }
  for (uint32_t p = ball.first_of_ball; p < ball.first_flat; ++p) {
    const Polygon& polygon = ball.scene.polygons[p];
    Vec3 centre;
    for (int c = 0; c < 3; ++c) centre += ball.scene.vertices[polygon.corners[c]] / 3;
    const auto found = triangles.find(
        {std::lround(centre.x * 1e4), std::lround(centre.y * 1e4), std::lround(centre.z * 1e4)});
    ASSERT_TRUE(found != triangles.end()) << p;
    EXPECT_NEAR(found->second.first, polygon_area(ball.scene, polygon), 1e-9);
    EXPECT_NEAR(found->second.second, slab.mesh.face_of_side[2 * p], 1e-2);
  }
}

// A box has edges, and light differs along its sides. So its small faces have vertices of their own at their
// corners, unless they are very small. They come after the uniform faces, before those that may be split.
TEST(WholeFaces, OfBoxesHaveCornersOfTheirOwn) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const auto add_box = [&](Vec3 at, double side) {
    const auto corner = [&](int i) {
      return at + side * Vec3{1.0 * (i & 1), 1.0 * (i >> 1 & 1), 1.0 * (i >> 2)};
    };
    for (const auto& face : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                             std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
      add_polygon(&scene, {corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
  };
  add_box({1, 1, 1}, 0.15);
  add_box({2, 2, 1}, 0.05);
  MeshBuilder builder(scene);
  std::vector<bool> fronts(2 * scene.polygons.size());
  for (size_t s = 0; s < fronts.size(); s += 2) fronts[s] = true;
  builder.add_faces(fronts, 0.2);
  const Mesh& mesh = builder.mesh();
  EXPECT_EQ(builder.undivided_faces(), 12u);
  EXPECT_EQ(builder.undivided_vertices(), 6u + 4 * 6);
  std::vector<int> users(mesh.vertices.size(), 0);
  for (uint32_t f = 0; f < builder.undivided_faces(); ++f) {
    const Element& root = mesh.elements[mesh.faces[f].element];
    EXPECT_EQ(is_uniform(root), mesh.faces[f].polygon > 6) << f;
    for (int c = 0; c < 4; ++c) ++users[root.vertices[c]];
  }
  for (uint32_t v = 0; v < builder.undivided_vertices(); ++v) EXPECT_EQ(users[v], v < 6 ? 4 : 1) << v;
  EXPECT_FALSE(is_uniform(root_of(mesh, 0)));
}

// In proportion to the longest edge: 1 from a twelfth of the scene's diagonal on, and never below 1/5.
TEST(UniformFaces, AccuracyShareGrowsWithSize) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}});              // diagonal 5: the scene's
  add_polygon(&scene, {{1, 1, 0}, {1.01, 1, 0}, {1.01, 1.01, 0}, {1, 1.01, 0}});  // a speck
  add_polygon(&scene, {{1, 1, 0}, {1.25, 1, 0}, {1.25, 1.2, 0}, {1, 1.2, 0}});    // 1/20 of the diagonal
  MeshBuilder builder(scene);
  for (uint32_t p = 0; p < 3; ++p) builder.face(p, 0);
  EXPECT_EQ(builder.accuracy_share(0), 1);
  EXPECT_NEAR(builder.accuracy_share(1), 0.2, 1e-12);
  EXPECT_NEAR(builder.accuracy_share(2), 12.0 / 20, 1e-9);
}

}  // namespace
}  // namespace strad
