// Bounces take out what the links have left of errors.
#include "solve/gather/bounces.h"

#include <gtest/gtest.h>

#include "refined.h"

namespace strad {
namespace {

// A closed room of Le = 1 and rho = 0.5: every leaf reflects rho E / pi = 0.5 of what it gets directly, and
// in all the sum of 0.5^i = 1.
struct Furnace {
  Refined refined;
  Workspace work;
  FunctionBlock divided;
  Field surpluses;
  DirectOfLeaves direct;
  LinkTable links;
  std::vector<ClusterReflection> reflections;
  std::vector<float> ones;
  TransportInput input;

  Furnace()
      : refined(room(), Roots::kClusters, {0.05}),
        work{refined.bench.grid, *refined.bench.nodes, refined.bench.tracer, refined.bench.swept},
        divided(direct_of_divided_leaves(work, *refined.direct)),
        surpluses(refined.direct->take_surpluses()),
        direct(work, divided, surpluses),
        links(make_link_table(work.grid, static_cast<uint32_t>(work.tree.nodes().size()), refined.links())),
        reflections(reflections_of(work.tree)),
        ones(work.tree.nodes().size(), 1.0f) {
    input.grid = &work.grid, input.tree = &work.tree, input.links = &links;
    input.instants = &refined.bench.instants, input.reflections = &reflections;
    input.form_factor_sums = &ones;
  }
  Furnace(const Furnace&) = delete;
  static Scene room() {
    Scene scene;
    scene.end = 1;
    add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
    return scene;
  }
  FunctionBlock uniform(float value) const {
    FunctionBlock radiance(work.tree.leaf_count(), leaves_of(work.tree), work.grid.sample_count());
    for (const uint32_t leaf : radiance.rows())
      for (size_t d = 0; d < radiance.sample_count(); ++d) radiance.set(leaf, d, {value, value, value});
    return radiance;
  }
};

// Too dark or too bright by a fifth at first. A bounce alone would leave half of that; with what the links
// make of the residual nothing is left but the digits of a block and the direct light's error, 1 %.
TEST(Bounces, MendAnErrorThatAllLeavesShare) {
  const Furnace furnace;
  for (const float wrong : {0.8f, 1.2f}) {
    FunctionBlock radiance = furnace.uniform(wrong);
    const Bounces bounces = correct_by_bounces(furnace.work, furnace.direct, furnace.input, 0.02, &radiance);
    for (const uint32_t leaf : radiance.rows()) ASSERT_NEAR(radiance.get(leaf, 3).g, 1, 0.01) << wrong;
    EXPECT_LE(bounces.rounds, 3);
    EXPECT_GT(bounces.rays, 0u);
  }
}

// What is right stays, after a single round.
TEST(Bounces, LeaveWhatIsRight) {
  const Furnace furnace;
  FunctionBlock radiance = furnace.uniform(1);
  const Bounces bounces = correct_by_bounces(furnace.work, furnace.direct, furnace.input, 0.02, &radiance);
  for (const uint32_t leaf : radiance.rows()) ASSERT_NEAR(radiance.get(leaf, 3).g, 1, 0.01);
  EXPECT_EQ(bounces.rounds, 1);
  EXPECT_LT(bounces.change, 0.01);
}

}  // namespace
}  // namespace strad
