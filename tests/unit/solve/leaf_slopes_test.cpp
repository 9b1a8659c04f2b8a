// Slopes of radiance within leaves, from the means of the leaves around.
#include "solve/gather/leaf_slopes.h"

#include <gtest/gtest.h>

#include "solve/links/leaves.h"
#include "workbench.h"

namespace strad {
namespace {

// A parallelogram and a triangle, each divided twice; radiance is 3 + x + y / 2.
struct Sheet {
  Workbench bench;
  FunctionBlock radiance;

  Sheet() : bench(scene_of_two()) {
    for (const uint32_t root : {0u, 1u}) bench.leaves_of(root, 2);
    radiance = FunctionBlock(bench.nodes->leaf_count(), leaves_of(*bench.nodes), bench.grid.sample_count());
    for (const uint32_t leaf : radiance.rows()) {
      const float mean = at(bench.node(leaf).centre);
      for (size_t d = 0; d < radiance.sample_count(); ++d) radiance.set(leaf, d, {mean, mean, mean});
    }
  }
  static Scene scene_of_two() {
    Scene scene;
    scene.end = 1;
    add_polygon(&scene, {{0, 0, 0}, {2, 0, 0}, {2.5, 1, 0}, {0.5, 1, 0}});
    add_polygon(&scene, {{0, 0, 2}, {2, 0, 2}, {0, 2, 2}});
    return scene;
  }
  static float at(Vec3 p) { return static_cast<float>(3 + p.x + p.y / 2); }
};

// Light is linear, so the means of leaves and their slopes tell it exactly, but for the 8 bits of a mean:
// also in the leaf in the middle of a triangle, which is turned round.
TEST(LeafSlopes, LinearLightIsTold) {
  const Sheet sheet;
  const std::vector<float> noise(sheet.radiance.rows().size(), 0);
  const LeafSlopes slopes(*sheet.bench.nodes, sheet.radiance, noise);
  for (const uint32_t leaf : sheet.radiance.rows()) {
    const PatchPoints patch = patch_points(*sheet.bench.nodes, sheet.bench.node(leaf));
    const Vec2 uv[4] = {{0, 0}, {1, 0}, patch.corner_count == 4 ? Vec2{1, 1} : Vec2{0, 1}, {0, 1}};
    const float mean = sheet.radiance.get(leaf, 0).g;
    for (int c = 0; c < patch.corner_count; ++c)
      EXPECT_NEAR(mean * slopes.factor(leaf, uv[c]), Sheet::at(patch.corners[c]), 0.03) << leaf << ' ' << c;
  }
}

// Where every mean may be off by its own size, nothing is known of slopes.
TEST(LeafSlopes, NoiseIsNoSlope) {
  const Sheet sheet;
  const std::vector<float> noise(sheet.radiance.rows().size(), 1);
  const LeafSlopes slopes(*sheet.bench.nodes, sheet.radiance, noise);
  for (const uint32_t leaf : sheet.radiance.rows()) EXPECT_EQ(slopes.factor(leaf, {0, 0}), 1);
}

// Light falls off so fast that a linear function would be below 0 at an end of a leaf.
TEST(LeafSlopes, NoPointIsBlack) {
  Sheet sheet;
  for (const uint32_t leaf : sheet.radiance.rows()) {
    const auto mean = static_cast<float>(std::exp(-20 * sheet.bench.node(leaf).centre.x));
    for (size_t d = 0; d < sheet.radiance.sample_count(); ++d)
      sheet.radiance.set(leaf, d, {mean, mean, mean});
  }
  const std::vector<float> noise(sheet.radiance.rows().size(), 0);
  const LeafSlopes slopes(*sheet.bench.nodes, sheet.radiance, noise);
  for (const uint32_t leaf : sheet.radiance.rows())
    for (const Vec2 uv : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) EXPECT_GT(slopes.factor(leaf, uv), 0.04);
}

}  // namespace
}  // namespace strad
