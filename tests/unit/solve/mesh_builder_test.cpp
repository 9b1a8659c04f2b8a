// The mesh as it grows: shared vertices, hanging ones, no tears.
#include "solve/mesh/mesh_builder.h"

#include <gtest/gtest.h>

#include <set>

#include "../light/light_test_scene.h"
#include "base/rng.h"

namespace strad {
namespace {

// A quad, a triangle at its right edge and a quad at its top in one plane; another quad stands on its left
// edge; a fifth lies in the plane, too, but on a body.
Scene patchwork() {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_polygon(&scene, {{1, 0, 0}, {2, 0.5, 0}, {1, 1, 0}});
  add_polygon(&scene, {{1, 1, 0}, {1.2, 2, 0}, {0, 2, 0}, {0, 1, 0}});
  add_polygon(&scene, {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  add_polygon(&scene, {{0, 0, 0}, {0, -1, 0}, {1, -1, 0}, {1, 0, 0}}, add_body(&scene, {0, 0, 1}));
  return scene;
}

struct Grown {
  Scene scene = patchwork();
  MeshBuilder builder{scene};
  std::vector<uint32_t> faces;

  // Splits about one leaf in two, at random, `rounds` times over.
  explicit Grown(uint64_t seed, int rounds = 5) {
    for (uint32_t p = 0; p < scene.polygons.size(); ++p) faces.push_back(builder.face(p, 0));
    for (int round = 0; round < rounds; ++round) {
      const size_t count = builder.mesh().elements.size();
      for (uint32_t e = 0; e < count; ++e)
        if (builder.mesh().elements[e].first_child == kNone && hash_of(seed, round, e) % 2) builder.split(e);
    }
  }

  // Value of every vertex: mean of its parents' plus a random surplus, of hanging vertices the mean alone.
  std::vector<double> values(bool hanging_are_means) const {
    const std::vector<bool> hanging = builder.hanging_vertices();
    std::vector<double> values;
    for (uint32_t v = 0; v < builder.mesh().vertices.size(); ++v) {
      double value = hanging[v] && hanging_are_means ? 0 : unit_from(hash_of(v, 5)) - 0.5;
      const uint32_t* parents = builder.mesh().vertices[v].parents;
      const int count = parents[0] == kNone ? 0 : parents[2] == kNone ? 2 : 4;
      for (int p = 0; p < count; ++p) value += values[parents[p]] / count;
      values.push_back(value);
    }
    return values;
  }
  double interpolate(const std::vector<double>& values, uint32_t face, Vec2 uv) const {
    const MeshPoint point = locate(builder.mesh(), face, uv);
    double sum = 0;
    for (int k = 0; k < 4; ++k)
      if (point.vertices[k] != kNone)
        sum += static_cast<double>(point.weights[k]) * values[point.vertices[k]];
    return sum;
  }
  // Largest jump across lines of the first two faces on which elements can meet, and across the edge that
  // they share.
  double largest_tear(const std::vector<double>& values) const {
    double worst = 0;
    const double e = 1e-7;
    const auto compare = [&](uint32_t f, Vec2 a, uint32_t g, Vec2 b) {
      worst = std::max(worst, std::abs(interpolate(values, f, a) - interpolate(values, g, b)));
    };
    for (int line = 1; line < 32; ++line)
      for (int i = 0; i < 101; ++i) {
        const double c = line / 32.0, s = (i + 0.37) / 101.74;
        compare(faces[0], {c - e, s}, faces[0], {c + e, s});
        compare(faces[0], {s, c - e}, faces[0], {s, c + e});
        if (c + s < 1) compare(faces[1], {c - e, s}, faces[1], {c + e, s});
        if (c + s < 1) compare(faces[1], {s, c - e}, faces[1], {s, c + e});
        if (s < c) compare(faces[1], {s, c - s - e}, faces[1], {s, c - s + e});
      }
    for (int i = 0; i < 1001; ++i) {
      const double s = (i + 0.37) / 1001.74;
      compare(faces[0], {1 - e, s}, faces[1], {e, s});      // (1, s, 0), seen from both
      compare(faces[0], {s, 1 - e}, faces[2], {e, 1 - s});  // (s, 1, 0): from corner 3 to 0 of the other
    }
    return worst;
  }
};

TEST(MeshBuilder, HangingVerticesKeepTheSurfaceWhole) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Grown grown(seed);
    EXPECT_LT(grown.largest_tear(grown.values(true)), 2e-5) << seed;
    EXPECT_GT(grown.largest_tear(grown.values(false)), 1e-2) << seed;  // else nothing hung
  }
}

TEST(MeshBuilder, WithoutSplitsNothingHangs) {
  const Grown grown(1, 0);
  for (const bool hangs : grown.builder.hanging_vertices()) EXPECT_FALSE(hangs);
}

TEST(MeshBuilder, AnEvenMeshHasNoHangingVertices) {
  Scene scene = patchwork();
  MeshBuilder builder(scene);
  for (uint32_t p = 0; p < 3; ++p) builder.face(p, 0);
  for (int round = 0; round < 3; ++round) {
    const size_t count = builder.mesh().elements.size();
    for (uint32_t e = 0; e < count; ++e)
      if (builder.mesh().elements[e].first_child == kNone) builder.split(e);
  }
  for (const bool hangs : builder.hanging_vertices()) EXPECT_FALSE(hangs);
}

TEST(MeshBuilder, OnlyNeighboursInOnePlaneAndBodyShareCorners) {
  Grown grown(1, 0);
  const auto corners = [&](int f) {
    const Mesh& mesh = grown.builder.mesh();
    const Element& root = mesh.elements[mesh.faces[grown.faces[f]].element];
    return std::set<uint32_t>(root.vertices, root.vertices + root.corner_count());
  };
  const auto shared = [&](int f, int g) {
    const std::set<uint32_t> a = corners(f), b = corners(g);
    return std::count_if(a.begin(), a.end(), [&](uint32_t v) { return b.count(v) > 0; });
  };
  EXPECT_EQ(shared(0, 1), 2);
  EXPECT_EQ(shared(0, 2), 2);
  EXPECT_EQ(shared(1, 2), 1);
  EXPECT_EQ(shared(0, 3), 0);  // stands on it
  EXPECT_EQ(shared(0, 4), 0);  // moves
}

TEST(MeshBuilder, SidesAreApart) {
  Scene scene = patchwork();
  MeshBuilder builder(scene);
  const uint32_t front = builder.face(0, 0), back = builder.face(0, 1);
  EXPECT_NE(front, back);
  EXPECT_EQ(builder.face(0, 0), front);  // not made twice
  builder.split(builder.mesh().faces[front].element);
  EXPECT_EQ(builder.mesh().elements[builder.mesh().faces[back].element].first_child, kNone);
  EXPECT_EQ(builder.mesh().face_of_side[1], back);
  EXPECT_EQ(builder.mesh().face_of_side[2], kNone);
}

TEST(MeshBuilder, KeepsParentsAndFaces) {
  const Grown grown(3);
  const Mesh& mesh = grown.builder.mesh();
  for (uint32_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.elements[e].first_child == kNone) continue;
    for (uint32_t c = 0; c < 4; ++c) {
      const uint32_t child = mesh.elements[e].first_child + c;
      EXPECT_EQ(grown.builder.parent_of(child), e);
      EXPECT_EQ(grown.builder.face_of(child), grown.builder.face_of(e));
    }
    uint32_t middles[5];
    const int count = grown.builder.middles(e, middles);
    EXPECT_EQ(count, mesh.elements[e].corner_count() == 4 ? 5 : 3);
    for (int m = 0; m < count; ++m) EXPECT_LT(middles[m], mesh.vertices.size());
  }
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v)
    for (const uint32_t parent : mesh.vertices[v].parents) EXPECT_TRUE(parent == kNone || parent < v);
}

// Points at which light is sampled lie on the polygon, near their vertex but never on an edge.
TEST(MeshBuilder, SamplePointsAreInside) {
  const Grown grown(3);
  for (uint32_t v = 0; v < grown.builder.mesh().vertices.size(); ++v) {
    const Polygon& polygon =
        grown.scene.polygons[grown.builder.mesh().faces[grown.builder.face_of_vertex(v)].polygon];
    const Vec3 at = grown.builder.sample_point(v), normal = polygon_normal(grown.scene, polygon);
    EXPECT_LT(length(at - grown.builder.mesh().vertices[v].position), 0.03);
    EXPECT_NEAR(dot(at - grown.scene.vertices[polygon.corners[0]], normal), 0, 1e-12);
    for (int c = 0; c < polygon.corner_count(); ++c) {
      const Vec3 a = grown.scene.vertices[polygon.corners[c]];
      const Vec3 b = grown.scene.vertices[polygon.corners[(c + 1) % polygon.corner_count()]];
      EXPECT_GT(dot(cross(normal, normalized(b - a)), at - a), 1e-5);
    }
  }
}

}  // namespace
}  // namespace strad
