// Propagation along links between patches against closed forms.
#include "solve/links/transport.h"

#include <gtest/gtest.h>

#include "transport_bench.h"

namespace strad {
namespace {

Scene two_squares() {
  Scene scene;
  scene.end = 8;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0, {0.8f, 0.5f, 0});
  add_polygon(&scene, {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, 0, {0.5f, 0.5f, 0.5f});
  return scene;
}

// Irradiance `direct` on the leaves of node 0's tree only.
NodeLight solve_lit_first(Transport* transport, Rgb direct) {
  return transport->solve([&](size_t slot) {
    const Node& node = transport->bench.node(static_cast<uint32_t>(slot));  // patches only: a slot is a node
    return node.face == 0 ? static_cast<float>(1 / kPi) * (node.reflectance * direct) : Rgb{};
  });
}

// L0 = r0 / pi (E + k L1), L1 = r1 / pi k L0:  L0 = (r0 / pi) E / (1 - r0 r1 (k / pi)^2).
double first_radiance(double r0, double r1, double k, double e) {
  return r0 / kPi * e / (1 - r0 * r1 * k * k / kPi / kPi);
}

TEST(Transport, TwoSurfacesReflectForever) {
  const Workbench bench(two_squares());
  const float k = 2.5f;
  Transport transport(bench, {link_of(0, 1, bench.always(), {k}), link_of(1, 0, bench.always(), {k})});
  const NodeLight light = solve_lit_first(&transport, {2, 1, 1});
  const uint32_t time_samples = bench.grid.sample_count();
  for (const uint32_t time_sample : {0u, time_samples / 2, time_samples - 1}) {
    const Rgb l0 = transport.radiance(light, 0, time_sample), l1 = transport.radiance(light, 1, time_sample);
    EXPECT_NEAR(l0.r, first_radiance(0.8, 0.5, k, 2), 1e-5);
    EXPECT_NEAR(l0.g, first_radiance(0.5, 0.5, k, 1), 1e-5);
    EXPECT_EQ(l0.b, 0);
    EXPECT_NEAR(l1.r, 0.5 / kPi * k * l0.r, 1e-5);
    EXPECT_NEAR(transport.irradiance(light, 1, time_sample).r, k * l0.r, 1e-5);
    EXPECT_EQ(l1.b, 0);
  }
  EXPECT_LT(light.residual, 1e-6);
  EXPECT_GT(light.iterations, 3);
}

TEST(Transport, WithoutLinksOnlyDirectLightIsReflected) {
  const Workbench bench(two_squares());
  Transport transport(bench, {});
  const NodeLight light = solve_lit_first(&transport, {1, 1, 1});
  EXPECT_NEAR(transport.radiance(light, 0).r, 0.8 / kPi, 1e-6);
  EXPECT_TRUE(is_black(transport.radiance(light, 1)));
}

// A linear kernel on the second half of the time: nothing before, the line after.
TEST(Transport, AKernelOfTimeHoldsOnItsInterval) {
  const Workbench bench(two_squares(), 2, 16);
  const Interval half{8, 3};
  const auto kernel = [](double s) { return 0.5 + s; };
  Transport transport(bench, {link_of(1, 0, half,
                                      {static_cast<float>(kernel(gauss_nodes(2)[0])),
                                       static_cast<float>(kernel(gauss_nodes(2)[1]))})});
  const NodeLight light = solve_lit_first(&transport, {1, 1, 1});
  for (uint32_t time_sample = 0; time_sample < bench.grid.sample_count(); ++time_sample) {
    const double s = (sample_time(bench.grid, time_sample) - 4) / 4;
    const double expected = s < 0 ? 0 : 0.5 / kPi * kernel(s) * 0.8 / kPi;
    EXPECT_NEAR(transport.radiance(light, 1, time_sample).r, expected, 1e-6) << time_sample;
  }
}

// A link to a node reaches all leaves below it; a link from a node carries their mean by area.
TEST(Transport, LinksOfNodesPushAndPull) {
  Workbench bench(two_squares());
  const std::vector<uint32_t> first = bench.leaves_of(0, 2), second = bench.leaves_of(1, 1);
  const uint32_t quarter = bench.node(0).first_child;
  Transport transport(
      bench, {link_of(1, 0, bench.always(), {1.0f}), link_of(second[2], quarter, bench.always(), {0.5f})});
  const NodeLight light = solve_lit_first(&transport, {1, 1, 1});
  const double l0 = 0.8 / kPi;
  EXPECT_NEAR(transport.radiance(light, 0).r, l0, 1e-6);  // the mean of its leaves
  for (const uint32_t leaf : first) EXPECT_NEAR(transport.radiance(light, leaf).r, l0, 1e-6);
  for (const uint32_t leaf : second) {
    const double k = leaf == second[2] ? 1.5 : 1;
    EXPECT_NEAR(transport.radiance(light, leaf).r, 0.5 / kPi * k * l0, 1e-6);
  }
  EXPECT_NEAR(transport.radiance(light, 1).r, 0.5 / kPi * (1 + 0.5 / 4) * l0, 1e-6);
}

// Links of a closed box that have lost a tenth of their light: balance gives it back, so that the furnace has
// L = Le / (1 - rho) again, of which rho Le / (1 - rho) is reflected.
TEST(Transport, BalanceRestoresTheFurnace) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  Workbench bench(scene, 1, 4);
  std::vector<uint32_t> leaves;
  for (uint32_t p = 0; p < 6; ++p)
    for (const uint32_t leaf : bench.leaves_of(p, 2)) leaves.push_back(leaf);
  std::vector<Link> links;
  for (const uint32_t p : leaves)
    for (const uint32_t q : leaves) {
      Link link{p, q, bench.always(), bench.estimate(p, q, bench.always())};
      for (float& k : link.estimate.kernel) k *= 0.9f;
      if (link.estimate.kernel[0] > 0) links.push_back(link);
    }
  Transport transport(bench, links);
  const auto worst = [&] {
    // Each surface emits 1 and gathers pi of it directly, of which it reflects rho.
    const NodeLight light = transport.solve([](size_t) { return Rgb{0.5f, 0.5f, 0.5f}; });
    double largest = 0;
    for (const uint32_t leaf : leaves)
      largest = std::max<double>(largest, std::abs(transport.radiance(light, leaf).r - 1));
    return largest;  // rho Le / (1 - rho) = 1
  };
  EXPECT_GT(worst(), 0.08);  // else the loss above was none
  const std::vector<float> one(bench.nodes->nodes().size(), 1.0f);
  transport.input.form_factor_sums = &one;
  EXPECT_LT(worst(), 0.01);
}

}  // namespace
}  // namespace strad
