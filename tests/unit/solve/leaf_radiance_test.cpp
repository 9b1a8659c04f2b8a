// Light of the leaves: what reaches them directly, and what they reflect in the end.
#include "solve/links/leaf_radiance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "refined.h"
#include "solve/links/direct_of_leaves.h"

namespace strad {
namespace {

// What the leaves of a refined scene get directly.
struct Lit {
  Refined refined;
  Workspace work;
  FunctionBlock divided;
  Field surpluses;
  DirectOfLeaves direct;

  Lit(Scene scene, std::initializer_list<double> thresholds, double uniform_below = 0)
      : refined(std::move(scene), Roots::kClusters, thresholds, uniform_below),
        work{refined.bench.grid, *refined.bench.nodes, refined.bench.tracer, refined.bench.swept},
        divided(direct_of_divided_leaves(work, *refined.direct)),
        surpluses(refined.direct->take_surpluses()),
        direct(work, divided, surpluses) {}
  Lit(const Lit&) = delete;

  std::vector<Rgb> irradiance(uint32_t leaf) const {
    return direct.irradiance(leaf, 0, refined.bench.grid.cell_count());
  }
};

// A closed room of Le = 1 and rho = 0.5.
Scene furnace() {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  return scene;
}

// Whatever a point of a furnace sees has radiance 1, so E = pi: on walls, whose leaves are divided, and on a
// box so small that its sides are uniform. 16 points of each emitter are shadowed by the box or not: 1.5 %.
TEST(DirectOfLeaves, IsPiInAFurnace) {
  Scene scene = furnace();
  add_box(&scene, {1, 1, 1}, {1.05, 1.05, 1.05}, false, 0, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  const Lit lit(std::move(scene), {0.05}, 0.2);
  int uniform = 0, divided = 0;
  for (const uint32_t leaf : leaves_of(lit.work.tree)) {
    lit.divided.has(leaf) ? ++divided : ++uniform;
    for (const Rgb e : lit.irradiance(leaf)) ASSERT_NEAR(e.g, kPi, 0.015 * kPi) << "leaf " << leaf;
  }
  EXPECT_EQ(uniform, 6);
  EXPECT_GE(divided, 6);
}

// A spotlight 2 m above the middle of a floor of 4 x 4 m sees it as a cube's centre sees a side: in a sixth
// of all directions, 4 pi / 6 sr. So with I = 6 it gets 4 pi W, shared among its leaves by their areas.
TEST(DirectOfLeaves, HoldsThePowerOfASpotlight) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  add_polygon(&scene, {{-2, -2, 3}, {-2, 2, 3}, {2, 2, 3}, {2, -2, 3}});
  add_spot(&scene, {0, 0, 2}, {0, 0, 0}, 1.4, 1.5, {6, 6, 6});
  const Lit lit(std::move(scene), {0.02});
  double power = 0;
  for (const uint32_t leaf : leaves_of(lit.work.tree))
    power += surface_of(lit.work.tree, leaf).area * lit.irradiance(leaf)[5].r;
  EXPECT_NEAR(power, 4 * kPi, 0.02 * 4 * kPi);
}

// The cells asked for, and only those: E of a lamp whose glow is 1 in the first half and 3 in the second.
TEST(DirectOfLeaves, GivesTheCellsAskedFor) {
  Scene scene = furnace();
  for (uint32_t m = 0; m < scene.materials.size(); ++m) {
    Glow glow;
    glow.material = m;
    glow.keys = {{0, 1}, {0.5, 1}, {0.5, 3}, {1, 3}};
    scene.glows.push_back(glow);
  }
  const Lit lit(std::move(scene), {});
  const uint32_t cells = lit.work.grid.cell_count(), leaf = leaves_of(lit.work.tree).front();
  const auto order = static_cast<size_t>(lit.work.grid.order);
  const std::vector<Rgb> first = lit.direct.irradiance(leaf, 0, 2);
  const std::vector<Rgb> last = lit.direct.irradiance(leaf, cells - 3, 3);
  ASSERT_EQ(first.size(), 2 * order);
  ASSERT_EQ(last.size(), 3 * order);
  for (const Rgb e : first) EXPECT_NEAR(e.r, kPi, 0.01 * kPi);
  for (const Rgb e : last) EXPECT_NEAR(e.r, 3 * kPi, 0.03 * kPi);
}

// E = pi is reflected for the first time with radiance rho = 0.5, in all sum of 0.5^i = 1. Where the form
// factors of all leaves add up to 1 the links, whatever they err, carry exactly that: within the residual and
// the 3 digits of a block.
TEST(LeafRadiance, IsTheGeometricSeriesInAFurnace) {
  const Lit lit(furnace(), {0.05});
  const NodeTree& tree = lit.work.tree;
  const LinkTable table =
      make_link_table(lit.work.grid, static_cast<uint32_t>(tree.nodes().size()), lit.refined.links());
  const std::vector<ClusterReflection> reflections = reflections_of(tree);
  const std::vector<float> ones(tree.nodes().size(), 1.0f);
  TransportInput input;
  input.grid = &lit.work.grid, input.tree = &tree, input.links = &table;
  input.instants = &lit.refined.bench.instants, input.reflections = &reflections;
  input.form_factor_sums = &ones;
  const LeafSource source = [&](uint32_t leaf, uint32_t first_cell, uint32_t cells) {
    return lit.direct.reflected(leaf, first_cell, cells);
  };
  FunctionBlock radiance(tree.leaf_count(), leaves_of(tree), lit.work.grid.sample_count());
  set_to_source(lit.work, source, &radiance);
  for (const uint32_t leaf : leaves_of(tree)) ASSERT_NEAR(radiance.get(leaf, 3).g, 0.5, 0.01);  // rho E / pi
  const Propagation found = add_reflected(lit.work, source, input, 1, &radiance);
  for (const uint32_t leaf : leaves_of(tree))
    for (size_t d = 0; d < lit.work.grid.sample_count(); ++d)
      ASSERT_NEAR(radiance.get(leaf, d).g, 1, 0.01) << "leaf " << leaf;
  EXPECT_NEAR(mean_radiance(tree, radiance), 1, 0.01);
  EXPECT_LT(found.residual, input.residual);
  // 0.5^i of what is to come is below the residual, 1e-3, from i = 10 on.
  EXPECT_GE(found.iterations, 8);
  EXPECT_LE(found.iterations, 12);
}

// A correction may be negative, but leaves no radiance below a share of what it was.
TEST(LeafRadiance, ACorrectionIsLimited) {
  const Lit lit(furnace(), {0.05});
  const NodeTree& tree = lit.work.tree;
  const LinkTable table =
      make_link_table(lit.work.grid, static_cast<uint32_t>(tree.nodes().size()), lit.refined.links());
  const std::vector<ClusterReflection> reflections = reflections_of(tree);
  const std::vector<float> ones(tree.nodes().size(), 1.0f);
  TransportInput input;
  input.grid = &lit.work.grid, input.tree = &tree, input.links = &table;
  input.instants = &lit.refined.bench.instants, input.reflections = &reflections;
  input.form_factor_sums = &ones;
  // Every leaf sends out s by itself, so reflects s (0.5 + 0.25 + ...) = s in the end.
  for (const float s : {-0.1f, -0.8f, 2.0f}) {
    const LeafSource source = [&](uint32_t, uint32_t, uint32_t cells) {
      return std::vector<Rgb>(cells * static_cast<size_t>(lit.work.grid.order), Rgb{s, s, s});
    };
    FunctionBlock radiance(tree.leaf_count(), leaves_of(tree), lit.work.grid.sample_count());
    for (const uint32_t leaf : leaves_of(tree))
      for (size_t d = 0; d < radiance.sample_count(); ++d) radiance.set(leaf, d, {1, 1, 1});
    add_reflected(lit.work, source, input, 0.5f, &radiance);
    for (const uint32_t leaf : leaves_of(tree))
      ASSERT_NEAR(radiance.get(leaf, 3).g, std::clamp(1 + s, 0.5f, 2.0f), 0.01) << s;
  }
}

}  // namespace
}  // namespace strad
