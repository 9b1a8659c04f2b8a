// Propagation along links against closed forms.
#include "solve/transport.h"

#include <gtest/gtest.h>

#include <numeric>

#include "workbench.h"

namespace strad {
namespace {

Scene two_squares() {
  Scene scene;
  scene.end = 8;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0, {0.8f, 0.5f, 0});
  add_polygon(&scene, {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, 0, {0.5f, 0.5f, 0.5f});
  return scene;
}

Link link_of(uint32_t receiver, uint32_t emitter, Interval interval, std::initializer_list<float> kernel) {
  Link link;
  link.receiver = receiver;
  link.emitter = emitter;
  link.interval = interval;
  link.estimate.dynamic = kernel.size() > 1;
  std::fill(link.estimate.kernel, link.estimate.kernel + kMaxOrder, *kernel.begin());
  std::copy(kernel.begin(), kernel.end(), link.estimate.kernel);
  return link;
}

// Radiance of all nodes at all dates, with direct light `direct` on the leaves of node 0's tree only.
struct Propagated {
  std::vector<Rgb> radiance;
  TransportResult result;
};
Propagated solve(const Workbench& bench, const std::vector<Link>& links, Rgb direct, const Balance& balance) {
  const auto count = static_cast<uint32_t>(bench.nodes->nodes().size());
  const LinkTable table = make_link_table(bench.grid, count, links);
  TransportInput input;
  input.grid = &bench.grid, input.tree = bench.nodes.get(), input.links = &table;
  input.balance = &balance;
  input.direct = [&](size_t node, size_t) { return bench.nodes->nodes()[node].face == 0 ? direct : Rgb{}; };
  input.residual = 1e-6;
  std::vector<uint32_t> dates(bench.grid.node_count());
  std::iota(dates.begin(), dates.end(), 0u);
  Propagated p;
  p.result = propagate(input, dates, 0, &p.radiance);
  return p;
}
Balance even(const Workbench& bench) {
  const size_t count = bench.nodes->nodes().size();
  return {std::vector<float>(count, 1.0f), std::vector<float>(count, 1.0f)};
}

// L0 = r0 / pi (E + k L1), L1 = r1 / pi k L0:  L0 = (r0 / pi) E / (1 - r0 r1 (k / pi)^2).
double first_radiance(double r0, double r1, double k, double e) {
  return r0 / kPi * e / (1 - r0 * r1 * k * k / kPi / kPi);
}

TEST(Transport, TwoSurfacesReflectForever) {
  const Workbench bench(two_squares());
  const float k = 2.5f;
  const std::vector<Link> links{link_of(0, 1, bench.always(), {k}), link_of(1, 0, bench.always(), {k})};
  const Propagated p = solve(bench, links, {2, 1, 1}, even(bench));
  const uint32_t dates = bench.grid.node_count();
  for (const uint32_t date : {0u, dates / 2, dates - 1}) {
    const Rgb l0 = p.radiance[date], l1 = p.radiance[dates + date];
    EXPECT_NEAR(l0.r, first_radiance(0.8, 0.5, k, 2), 1e-5);
    EXPECT_NEAR(l0.g, first_radiance(0.5, 0.5, k, 1), 1e-5);
    EXPECT_EQ(l0.b, 0);
    EXPECT_NEAR(l1.r, 0.5 / kPi * k * l0.r, 1e-5);
    EXPECT_EQ(l1.b, 0);
  }
  EXPECT_LT(p.result.residual, 1e-6);
  EXPECT_GT(p.result.iterations, 3);
}

TEST(Transport, WithoutLinksOnlyDirectLightIsReflected) {
  const Workbench bench(two_squares());
  const Propagated p = solve(bench, {}, {1, 1, 1}, even(bench));
  EXPECT_NEAR(p.radiance[0].r, 0.8 / kPi, 1e-6);
  EXPECT_TRUE(is_black(p.radiance[bench.grid.node_count()]));
}

// A linear kernel on the second half of the time: nothing before, the line after.
TEST(Transport, AKernelOfTimeHoldsOnItsInterval) {
  const Workbench bench(two_squares(), 2, 16);
  const Interval half{8, 3};
  const auto kernel = [](double s) { return 0.5 + s; };
  const Link link =
      link_of(1, 0, half,
              {static_cast<float>(kernel(gauss_nodes(2)[0])), static_cast<float>(kernel(gauss_nodes(2)[1]))});
  const Propagated p = solve(bench, {link}, {1, 1, 1}, even(bench));
  const uint32_t dates = bench.grid.node_count();
  for (uint32_t date = 0; date < dates; ++date) {
    const double s = (node_time(bench.grid, date) - 4) / 4;
    const double expected = s < 0 ? 0 : 0.5 / kPi * kernel(s) * 0.8 / kPi;
    EXPECT_NEAR(p.radiance[dates + date].r, expected, 1e-6) << date;
  }
}

// A link to a node reaches all leaves below it; a link from a node carries their mean by area.
TEST(Transport, LinksOfNodesPushAndPull) {
  Workbench bench(two_squares());
  const std::vector<uint32_t> first = bench.leaves_of(0, 2), second = bench.leaves_of(1, 1);
  const uint32_t dates = bench.grid.node_count();
  const uint32_t quarter = bench.nodes->nodes()[0].first_child;
  const std::vector<Link> links{link_of(1, 0, bench.always(), {1.0f}),
                                link_of(second[2], quarter, bench.always(), {0.5f})};
  const Propagated p = solve(bench, links, {1, 1, 1}, even(bench));
  const double l0 = 0.8 / kPi;
  EXPECT_NEAR(p.radiance[0].r, l0, 1e-6);  // the mean of its leaves
  for (const uint32_t leaf : first) EXPECT_NEAR(p.radiance[leaf * dates].r, l0, 1e-6);
  for (const uint32_t leaf : second) {
    const double k = leaf == second[2] ? 1.5 : 1;
    EXPECT_NEAR(p.radiance[leaf * dates].r, 0.5 / kPi * k * l0, 1e-6);
  }
  EXPECT_NEAR(p.radiance[dates].r, 0.5 / kPi * (1 + 0.5 / 4) * l0, 1e-6);
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
      Link link{p, q, bench.always(), bench.kernels->estimate(p, q, bench.always())};
      for (float& k : link.estimate.kernel) k *= 0.9f;
      if (link.estimate.kernel[0] > 0) links.push_back(link);
    }
  const std::vector<float> one(bench.nodes->nodes().size(), 1.0f);
  const Balance b = balance(bench.grid, *bench.nodes, links, one, one);
  const auto worst = [&](const Balance& scales) {
    const auto count = static_cast<uint32_t>(bench.nodes->nodes().size());
    const LinkTable table = make_link_table(bench.grid, count, links);
    TransportInput input;
    input.grid = &bench.grid, input.tree = bench.nodes.get(), input.links = &table;
    input.balance = &scales;
    // Each surface emits 1 and gathers pi of it directly: E = pi.
    input.direct = [](size_t, size_t) { return static_cast<float>(kPi) * Rgb{1, 1, 1}; };
    input.residual = 1e-6;
    std::vector<Rgb> radiance;
    propagate(input, {0}, 0, &radiance);
    double largest = 0;
    for (const uint32_t leaf : leaves) largest = std::max<double>(largest, std::abs(radiance[leaf].r - 1));
    return largest;  // rho Le / (1 - rho) = 1
  };
  EXPECT_LT(worst(b), 0.01);
  EXPECT_GT(worst(even(bench)), 0.08);  // else the loss above was none
}

}  // namespace
}  // namespace strad
