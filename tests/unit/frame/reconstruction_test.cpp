// Interpolation over a mesh with leaves of many sizes.
#include "frame/reconstruction.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/rng.h"

namespace strad {
namespace {

// Splits elements of one face, sharing the vertices on edges as the solver does.
class Builder {
 public:
  Builder(const std::vector<Vec3>& corners) {
    Element root;
    for (size_t i = 0; i < corners.size(); ++i) {
      mesh.vertices.push_back({{kNone, kNone, kNone, kNone}, corners[i]});
      root.vertices[i] = static_cast<uint32_t>(i);
    }
    mesh.elements.push_back(root);
    mesh.faces.push_back({0, 0, 0});
    mesh.face_of_side = {0, kNone};
  }

  void split(uint32_t e) {
    const Element element = mesh.elements[e];
    const uint32_t* v = element.vertices;
    const uint32_t a = middle(v[0], v[1]), b = middle(v[1], v[2]);
    if (element.corner_count() == 3) {
      const uint32_t c = middle(v[2], v[0]);
      return add(e, {{v[0], a, c}, {a, v[1], b}, {c, b, v[2]}, {b, c, a}});
    }
    const uint32_t c = middle(v[2], v[3]), d = middle(v[3], v[0]);
    const uint32_t m = vertex({v[0], v[1], v[2], v[3]});
    add(e, {{v[0], a, m, d}, {a, v[1], b, m}, {m, b, v[2], c}, {d, m, c, v[3]}});
  }

  Mesh mesh;

 private:
  uint32_t vertex(const std::vector<uint32_t>& parents) {
    MeshVertex made;
    for (size_t i = 0; i < parents.size(); ++i) {
      made.parents[i] = parents[i];
      made.position += mesh.vertices[parents[i]].position / static_cast<double>(parents.size());
    }
    mesh.vertices.push_back(made);
    return static_cast<uint32_t>(mesh.vertices.size() - 1);
  }
  uint32_t middle(uint32_t a, uint32_t b) {
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      const uint32_t* p = mesh.vertices[v].parents;
      if (p[2] == kNone && ((p[0] == a && p[1] == b) || (p[0] == b && p[1] == a))) return v;
    }
    return vertex({a, b});
  }
  void add(uint32_t parent, const std::vector<std::vector<uint32_t>>& children) {
    mesh.elements[parent].first_child = static_cast<uint32_t>(mesh.elements.size());
    for (const auto& corners : children) {
      Element child;
      std::copy(corners.begin(), corners.end(), child.vertices);
      mesh.elements.push_back(child);
    }
  }
};

// Deep at one corner, untouched at others: leaves next to others one, two and three levels smaller.
Mesh graded_mesh(bool quad) {
  Builder builder(quad ? std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}
                       : std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}});
  builder.split(0);
  builder.split(2);
  builder.split(5);
  builder.split(8);
  builder.split(11);
  builder.split(12);
  builder.split(19);
  return builder.mesh;
}
Vec3 position(bool quad, Vec2 uv) { return quad ? Vec3{2 * uv.x, 3 * uv.y, 0} : Vec3{2 * uv.x, 3 * uv.y, 0}; }

std::vector<Rgb> values_of(const Mesh& mesh, const std::function<double(uint32_t)>& value) {
  std::vector<Rgb> values;
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const float x = static_cast<float>(value(v));
    values.push_back({x, 2 * x, -x});
  }
  return values;
}

void for_points(bool quad, const std::function<void(Vec2)>& test) {
  for (int i = 0; i <= 53; ++i) {
    for (int j = 0; j <= (quad ? 53 : 53 - i); ++j) test({i / 53.0, j / 53.0});
  }
}

class ReconstructionOf : public testing::TestWithParam<bool> {};

TEST_P(ReconstructionOf, LinearFunctionsIsExact) {
  const Mesh mesh = graded_mesh(GetParam());
  const auto linear = [](Vec3 p) { return 1 + 2 * p.x - 3 * p.y; };
  const auto values = values_of(mesh, [&](uint32_t v) { return linear(mesh.vertices[v].position); });
  const Reconstruction reconstruction(mesh);
  for_points(GetParam(), [&](Vec2 uv) {
    EXPECT_NEAR(reconstruction.smooth(values, 0, uv).r, linear(position(GetParam(), uv)), 1e-5);
  });
}

TEST_P(ReconstructionOf, RandomValuesHasNoCracks) {
  const Mesh mesh = graded_mesh(GetParam());
  const auto values = values_of(mesh, [](uint32_t v) { return unit_from(hash_of(v)); });
  const Reconstruction reconstruction(mesh);
  // Values are at most 1 apart and elements at least 1/16 wide: nothing may change by more than 16 times
  // the step (and some more for the deviations), where a crack would be as large for any step.
  const double step = 1e-5;
  for_points(GetParam(), [&](Vec2 uv) {
    const float here = reconstruction.smooth(values, 0, uv).r;
    for (const Vec2 side :
         {Vec2{step, 0}, Vec2{-step, 0}, Vec2{0, step}, Vec2{0, -step}, Vec2{step, -step}}) {
      const Vec2 near{std::clamp(uv.x + side.x, 0.0, 1.0), std::clamp(uv.y + side.y, 0.0, 1.0)};
      if (!GetParam() && near.x + near.y > 1) continue;
      EXPECT_NEAR(reconstruction.smooth(values, 0, near).r, here, 100 * step) << uv.x << ' ' << uv.y;
    }
  });
}

TEST_P(ReconstructionOf, LinesBetweenLeavesHasNoCracks) {
  const Mesh mesh = graded_mesh(GetParam());
  const auto values = values_of(mesh, [](uint32_t v) { return unit_from(hash_of(v, 1)); });
  const Reconstruction reconstruction(mesh);
  for (int line = 1; line < 16; ++line) {
    for (int i = 0; i <= 200; ++i) {
      const double at = line / 16.0, along = (GetParam() ? 1 : 1 - at) * i / 200, little = 1e-7;
      EXPECT_NEAR(
          reconstruction.smooth(values, 0, {at - little, along * (1 - little)}).g,
          reconstruction
              .smooth(values, 0,
                      {at + little, along * (1 - little) - (GetParam() ? 0 : 2 * little) * (i == 200)})
              .g,
          1e-4);
    }
  }
}

TEST_P(ReconstructionOf, SourcesGiveTheSameValue) {
  const Mesh mesh = graded_mesh(GetParam());
  const auto values = values_of(mesh, [](uint32_t v) { return unit_from(hash_of(v, 2)); });
  const Reconstruction reconstruction(mesh);
  for_points(GetParam(), [&](Vec2 uv) {
    Rgb smooth, flat;
    float weight = 0;
    for (const VertexWeight& s : reconstruction.smooth_sources(0, uv))
      smooth += s.weight * values[s.vertex], weight += s.weight;
    for (const VertexWeight& s : reconstruction.flat_sources(0, uv)) flat += s.weight * values[s.vertex];
    uint32_t leaf = kNone;
    EXPECT_NEAR(weight, 1, 1e-5);
    EXPECT_NEAR(smooth.r, reconstruction.smooth(values, 0, uv).r, 1e-5);
    EXPECT_NEAR(flat.r, reconstruction.flat(values, 0, uv, &leaf).r, 1e-5);
  });
}

TEST_P(ReconstructionOf, FlatIsConstantOnLeaves) {
  const Mesh mesh = graded_mesh(GetParam());
  const auto values = values_of(mesh, [](uint32_t v) { return unit_from(hash_of(v, 3)); });
  const Reconstruction reconstruction(mesh);
  std::vector<std::vector<float>> seen(mesh.elements.size());
  for_points(GetParam(), [&](Vec2 uv) {
    uint32_t leaf = kNone;
    const float value = reconstruction.flat(values, 0, uv, &leaf).r;
    seen[leaf].push_back(value);
    EXPECT_EQ(value, seen[leaf].front());
  });
}

INSTANTIATE_TEST_SUITE_P(, ReconstructionOf, testing::Bool(),
                         [](const auto& info) { return info.param ? "Quads" : "Triangles"; });

}  // namespace
}  // namespace strad
