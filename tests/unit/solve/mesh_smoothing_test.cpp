// Smoothing takes out noise and leaves light: what is linear stays, an edge stays, noise shrinks.
#include "solve/mesh/mesh_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/rng.h"
#include "solve/mesh/mesh_builder.h"
#include "workbench.h"

namespace strad {
namespace {

constexpr size_t kTimes = 12;

// A unit square in 16 x 16 elements, and functions at its vertices.
struct Grid {
  Scene scene;
  Mesh mesh;
  std::vector<uint32_t> leaves;
  std::vector<CoarseFunction> functions;

  explicit Grid(const std::function<double(Vec3 at, uint32_t vertex, size_t time_sample)>& light) {
    scene.end = 1;
    add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    MeshBuilder builder(scene);
    builder.face(0, 0);
    leaves = {0};
    for (int level = 0; level < 4; ++level) {
      std::vector<uint32_t> children;
      for (const uint32_t leaf : leaves) {
        builder.split(leaf);
        for (uint32_t c = 0; c < 4; ++c) children.push_back(builder.mesh().elements[leaf].first_child + c);
      }
      leaves = children;
    }
    mesh = builder.take();
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      std::vector<Rgb> values;
      for (size_t t = 0; t < kTimes; ++t) {
        const auto value = static_cast<float>(light(mesh.vertices[v].position, v, t));
        values.push_back({value, value, value});
      }
      functions.emplace_back(values);
    }
  }
  void smoothed() {
    smooth(opposite_neighbours(mesh, leaves, 1), [&](uint32_t v) -> CoarseFunction& { return functions[v]; });
  }
  // Root mean square over vertices and time samples of the difference between the functions and `light`.
  double error(const std::function<double(Vec3 at, size_t time_sample)>& light) const {
    double sum = 0;
    for (uint32_t v = 0; v < functions.size(); ++v)
      for (size_t t = 0; t < kTimes; ++t)
        sum += std::pow(functions[v][t].r - light(mesh.vertices[v].position, t), 2);
    return std::sqrt(sum / static_cast<double>(functions.size() * kTimes));
  }
};

double noise(uint32_t vertex, size_t time_sample) {
  return unit_from(hash_of(vertex, static_cast<uint64_t>(time_sample))) - 0.5;
}

TEST(MeshSmoothing, PairsAreOppositeAndAsFar) {
  const Grid grid([](Vec3, uint32_t, size_t) { return 1.0; });
  const auto pairs = opposite_neighbours(grid.mesh, grid.leaves, 0.07);
  EXPECT_TRUE(opposite_neighbours(grid.mesh, grid.leaves, 0.06)[100].empty());  // 1/16 apart
  std::map<size_t, int> vertices_of_pairs;
  for (uint32_t v = 0; v < pairs.size(); ++v) {
    ++vertices_of_pairs[pairs[v].size()];
    for (const NeighbourPair& pair : pairs[v]) {
      const Vec3 middle = 0.5 * (grid.mesh.vertices[pair.a].position + grid.mesh.vertices[pair.b].position);
      EXPECT_LT(length(middle - grid.mesh.vertices[v].position), 1e-12);
    }
  }
  EXPECT_EQ(vertices_of_pairs[0], 4);        // corners
  EXPECT_EQ(vertices_of_pairs[1], 4 * 15);   // edges
  EXPECT_EQ(vertices_of_pairs[2], 15 * 15);  // inside
}

TEST(MeshSmoothing, LinearLightStays) {
  const auto light = [](Vec3 at, size_t time_sample) {
    return 1 + at.x * static_cast<double>(time_sample) + 0.5 * at.y;
  };
  Grid grid([&](Vec3 at, uint32_t, size_t time_sample) { return light(at, time_sample); });
  const double before = grid.error(light);  // of what the functions keep
  grid.smoothed();
  EXPECT_LT(grid.error(light), 2 * before + 1e-6);
}

TEST(MeshSmoothing, NoiseShrinks) {
  const auto light = [](Vec3 at, size_t) { return 2 + at.x; };
  Grid grid([&](Vec3 at, uint32_t v, size_t time_sample) {
    return light(at, time_sample) + 0.1 * noise(v, time_sample);
  });
  const double before = grid.error(light);
  grid.smoothed();
  EXPECT_LT(grid.error(light), 0.55 * before);
}

TEST(MeshSmoothing, AnEdgeIsNoNoise) {
  const auto light = [](Vec3 at, size_t) { return at.x < 0.5 ? 1.0 : 3.0; };
  Grid grid([&](Vec3 at, uint32_t v, size_t time_sample) {
    return light(at, time_sample) + 0.02 * noise(v, time_sample);
  });
  grid.smoothed();
  for (uint32_t v = 0; v < grid.functions.size(); ++v)
    EXPECT_NEAR(grid.functions[v][3].r, light(grid.mesh.vertices[v].position, 3), 0.02) << v;
}

}  // namespace
}  // namespace strad
