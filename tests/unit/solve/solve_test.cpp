// The solve as a whole, on scenes whose light is known.
#include "solve/solve.h"

#include <gtest/gtest.h>

#include "../light/light_test_scene.h"
#include "base/error.h"
#include "base/parallel.h"

namespace strad {
namespace {

// A closed room in which every surface emits Le = 1 and reflects rho = 0.5.
Scene furnace() {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  return scene;
}

// A grey room with a spotlight of that intensity, and a box that moves through its beam.
Scene room_with_spot(float intensity) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.5f, 0.6f, 0.7f});
  const uint32_t body = add_body(&scene, {1.5, 0.5, 0});
  add_box(&scene, {1, 1, 0.3}, {1.6, 1.6, 0.8}, false, body);
  add_spot(&scene, {2, 1.5, 1.9}, {2, 1.5, 0}, 0.6, 0.9, {intensity, intensity, intensity});
  return scene;
}

SolveOptions rough() {
  SolveOptions options;
  options.error = 0.2;
  return options;
}

// E = pi L of all that a point sees: pi of emission, and as much again of what is reflected, for
// L = Le / (1 - rho) = 2. So at every vertex of the mesh, in a whole solve and at an instant: 2 % of noise
// for direct light and 3 % for the 64 rays of a gather, which all meet the same radiance
// but for the noise of leaves.
void expect_furnace(const Slab& slab, double time) {
  const VertexLight light = light_at(slab, time);
  double mean = 0;
  for (size_t v = 0; v < slab.mesh.vertices.size(); ++v)
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(light.direct[v][c], kPi, 0.02 * kPi) << "vertex " << v;
      ASSERT_NEAR(light.indirect[v][c], kPi, 0.03 * kPi) << "vertex " << v;
      mean +=
          (light.direct[v][c] + light.indirect[v][c]) / (3 * static_cast<double>(slab.mesh.vertices.size()));
    }
  EXPECT_NEAR(mean, 2 * kPi, 0.01 * 2 * kPi);
}

TEST(Solve, FurnaceIsLeOverOneMinusRhoEverywhere) {
  const Solved solved = solve(furnace(), rough());
  for (const double time : {0.0, 0.37, 1.0}) expect_furnace(solved.slab, time);
  EXPECT_GT(solved.stats.gather.rays, 0u);
  EXPECT_GT(solved.stats.bounces.rays, 0u);
}

TEST(Solve, FurnaceAtAnInstantAndWithoutClusters) {
  SolveOptions options = rough();
  options.instant = 0.5;
  expect_furnace(solve(furnace(), options).slab, 0.5);
  options.clusters = false;
  expect_furnace(solve(furnace(), options).slab, 0.5);
}

// White walls that emit nothing: dark. Dark walls that emit: no indirect light.
TEST(Solve, NoLightFromNothing) {
  SolveOptions options = rough();
  options.instant = 0;
  Scene dark;
  add_box(&dark, {0, 0, 0}, {4, 3, 2}, true, 0, {0.8f, 0.8f, 0.8f});
  for (const Rgb& e : light_at(solve(dark, options).slab, 0).indirect) EXPECT_TRUE(is_black(e));
  Scene black;
  add_box(&black, {0, 0, 0}, {4, 3, 2}, true, 0, {0, 0, 0}, {1, 1, 1});
  const Slab slab = solve(black, options).slab;
  for (const Rgb& e : light_at(slab, 0).indirect) EXPECT_TRUE(is_black(e));
}

// All thresholds follow the light, and a factor of 4 changes no digit of a binary number: the same mesh, and
// 4 times the light to the last bit.
TEST(Solve, FourTimesTheLampGivesFourTimesTheLight) {
  const Slab one = solve(room_with_spot(5), rough()).slab, four = solve(room_with_spot(20), rough()).slab;
  ASSERT_EQ(one.mesh.vertices.size(), four.mesh.vertices.size());
  for (const double time : {0.1, 0.5, 0.93}) {
    const VertexLight a = light_at(one, time), b = light_at(four, time);
    double total = 0;
    for (size_t v = 0; v < a.direct.size(); ++v) {
      EXPECT_EQ(b.direct[v], 4 * a.direct[v]) << "vertex " << v;
      EXPECT_EQ(b.indirect[v], 4 * a.indirect[v]) << "vertex " << v;
      total += a.indirect[v].g;
    }
    EXPECT_GT(total, 0);
  }
}

void expect_same(const Field& a, const Field& b) {
  EXPECT_EQ(a.first_piece, b.first_piece);
  EXPECT_EQ(a.pieces, b.pieces);
  EXPECT_EQ(a.coefficients, b.coefficients);
}

TEST(Solve, AnyNumberOfThreadsGivesTheSameSolution) {
  set_thread_count(1);
  const Solved one = solve(room_with_spot(5), rough());
  set_thread_count(3);
  const Solved three = solve(room_with_spot(5), rough());
  EXPECT_EQ(one.slab.mesh.elements.size(), three.slab.mesh.elements.size());
  expect_same(one.slab.direct, three.slab.direct);
  expect_same(one.slab.indirect, three.slab.indirect);
  EXPECT_EQ(one.stats.total.rays, three.stats.total.rays);
  EXPECT_EQ(one.work.links, three.work.links);
}

// At 25 times the default error a vertex and a leaf send an eighth and a quarter of the rays, and there are
// fewer of both and fewer looks at the box: a seventh of all rays of gathers is more than a draft may take.
TEST(Solve, ADraftTracesFewRays) {
  SolveOptions draft;
  draft.error = 0.5;
  const SolveStats few = solve(room_with_spot(5), draft).stats, many = solve(room_with_spot(5), {}).stats;
  EXPECT_GT(few.gather.rays, 0u);
  EXPECT_LT(7 * few.gather.rays, many.gather.rays);
  EXPECT_LT(4 * few.bounces.rays, many.bounces.rays);
}

// Each phase begins once, in order, and no later than what is done.
TEST(Solve, TellsItsPhases) {
  std::vector<std::string> names;
  double last = 0;
  SolveOptions options = rough();
  options.instant = 0;
  solve(furnace(), options, [&](double done, const std::string& name) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1);
    last = done;
    names.push_back(name);
  });
  EXPECT_EQ(names,
            (std::vector<std::string>{"preparation", "direct light", "links", "bounces", "final gather"}));
}

TEST(Solve, RefusesOptionsOutOfRange) {
  const auto refused = [](const auto& change) {
    SolveOptions options;
    change(&options);
    EXPECT_THROW(solve(furnace(), options), BadInput);
  };
  refused([](SolveOptions* o) { o->error = 0; });
  refused([](SolveOptions* o) { o->error = -0.1; });
  refused([](SolveOptions* o) { o->error = std::nan(""); });
  refused([](SolveOptions* o) { o->order = 0; });
  refused([](SolveOptions* o) { o->order = 4; });
  refused([](SolveOptions* o) { o->instant = 1.1; });
  refused([](SolveOptions* o) { o->begin = -0.1; });
  refused([](SolveOptions* o) { o->end = 1.1; });
  refused([](SolveOptions* o) { o->begin = 0.6, o->end = 0.4; });
  refused([](SolveOptions* o) { o->instant = 0.5, o->begin = 0; });
}

}  // namespace
}  // namespace strad
