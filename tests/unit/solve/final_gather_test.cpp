// Gathers along rays over the radiance of leaves.
#include "solve/gather/final_gather.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "refined.h"
#include "solve/links/direct_of_leaves.h"

namespace strad {
namespace {

// A room of 4 x 3 x 2 m with a spotlight; its leaves send out what they reflect of that at once.
struct SpotlitRoom {
  Refined refined;
  Workspace work;
  std::vector<uint32_t> leaves;
  FunctionBlock radiance;

  SpotlitRoom()
      : refined(room(), Roots::kFaces, {0.02, 0.005}),
        work{refined.bench.grid, *refined.bench.nodes, refined.bench.tracer, refined.bench.swept},
        leaves(leaves_of(work.tree)),
        radiance(work.tree.leaf_count(), leaves, work.grid.sample_count()) {
    FunctionBlock divided = direct_of_divided_leaves(work, *refined.direct);
    const Field surpluses = refined.direct->take_surpluses();
    const DirectOfLeaves direct(work, std::move(divided), surpluses);
    for (const uint32_t leaf : leaves) {
      const std::vector<Rgb> reflected = direct.reflected(leaf, 0, work.grid.cell_count());
      for (size_t d = 0; d < reflected.size(); ++d) radiance.set(leaf, d, reflected[d]);
    }
  }
  static Scene room() {
    Scene scene;
    scene.end = 1;
    add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
    add_spot(&scene, {2, 1.5, 1.9}, {1.3, 1.2, 0}, 0.4, 0.5, {10, 10, 10});
    return scene;
  }
  double area(uint32_t leaf) const { return surface_of(work.tree, leaf).area; }
};

// All that leaves send out, pi A L, arrives on the leaves of the closed room: the areas times what they
// gather add up to it. With 1024 rays a leaf, whose origins and directions are not in step, to 0.5 %.
TEST(FinalGather, WhatIsSentOutArrives) {
  const SpotlitRoom lit;
  const FinalGather gather(lit.work.tree, lit.work.tracer, lit.work.grid, lit.work.swept, lit.radiance, {},
                           {}, {1024});
  double sent = 0, arrived = 0;
  uint64_t rays = 0;
  for (const uint32_t leaf : lit.leaves) {
    sent += kPi * lit.area(leaf) * lit.radiance.get(leaf, 3).g;
    arrived += lit.area(leaf) * gather.over_leaf(leaf, &rays).irradiance[3].g;
  }
  EXPECT_NEAR(arrived / sent, 1, 0.005);
  EXPECT_EQ(rays, 1024 * lit.leaves.size());
}

// Everything has radiance 1, so E is pi, exactly, at vertices and over leaves.
TEST(FinalGather, UniformRadianceGivesPi) {
  SpotlitRoom lit;
  for (const uint32_t leaf : lit.leaves)
    for (size_t d = 0; d < lit.radiance.sample_count(); ++d) lit.radiance.set(leaf, d, {1, 1, 1});
  const FinalGather gather(lit.work.tree, lit.work.tracer, lit.work.grid, lit.work.swept, lit.radiance, {},
                           {}, {64});
  uint64_t rays = 0;
  for (const uint32_t leaf : lit.leaves)
    EXPECT_NEAR(gather.over_leaf(leaf, &rays).irradiance[5].r, kPi, 1e-4) << leaf;
  EXPECT_NEAR(gather.at_vertex(0, &rays).irradiance[5].r, kPi, 1e-4);
}

// A bar of 0.3 m between two blocks, 0.03 m of it inside each. Its corners see nothing but the dark inside of
// the blocks; the parts of its sides around them see the room for four fifths. All that is seen sends out 1,
// and what is hidden does not count, so E is pi everywhere on the bar.
TEST(FinalGather, CornersOfSmallFacesMayLieInsideOfOthers) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {1.97, 1.5, 1}, {2.27, 1.54, 1.04}, false);
  add_box(&scene, {1.5, 1.2, 0.7}, {2, 1.8, 1.3}, false);
  add_box(&scene, {2.24, 1.2, 0.7}, {2.8, 1.8, 1.3}, false);
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  const Workbench bench(std::move(scene), 2, 16, Roots::kFaces, 0.5);
  const MeshBuilder& builder = bench.builder;
  FunctionBlock radiance(bench.nodes->leaf_count(), leaves_of(*bench.nodes), bench.grid.sample_count());
  for (const uint32_t leaf : radiance.rows())
    for (size_t d = 0; d < radiance.sample_count(); ++d) radiance.set(leaf, d, {1, 1, 1});
  const FinalGather gather(*bench.nodes, bench.tracer, bench.grid, bench.swept, radiance, {}, {}, {256});
  uint64_t rays = 0;
  int sides = 0;
  for (uint32_t f = 0; f < builder.undivided_faces(); ++f) {
    const Element& root = builder.mesh().elements[builder.mesh().faces[f].element];
    if (is_uniform(root)) continue;  // the ends of the bar
    ++sides;
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(gather.at_vertex(root.vertices[c], &rays).irradiance[5].g, kPi, 1e-3) << f << ' ' << c;
  }
  EXPECT_EQ(sides, 4);
}

// Rays that go where others have found light bring the same, with less noise: the mean over all leaves of the
// squared error falls to less than half with the directions of 1024 rays a leaf.
TEST(FinalGather, GuidedRaysAreUnbiased) {
  const SpotlitRoom lit;
  const auto gather_by = [&](const DirectionGuide& guide, int rays) {
    return FinalGather(lit.work.tree, lit.work.tracer, lit.work.grid, lit.work.swept, lit.radiance, {}, guide,
                       {rays});
  };
  std::vector<DirectionCounts> counts(lit.work.tree.nodes().size());
  const FinalGather learning = gather_by({}, 1024);
  uint64_t rays = 0;
  for (const uint32_t leaf : lit.leaves) learning.over_leaf(leaf, &rays, &counts[leaf]);
  const DirectionGuide guide(lit.work.tree, std::move(counts));
  const FinalGather exact = gather_by({}, 16384), plain = gather_by({}, 128), guided = gather_by(guide, 128);
  double error = 0, plain_squares = 0, guided_squares = 0;
  size_t vertices = 0;
  for (uint32_t v = 0; v < lit.work.tree.builder().mesh().vertices.size(); v += 17, ++vertices) {
    const double truth = exact.at_vertex(v, &rays).irradiance[3].g;
    const double by_cosine = plain.at_vertex(v, &rays).irradiance[3].g / truth - 1,
                 by_guide = guided.at_vertex(v, &rays).irradiance[3].g / truth - 1;
    error += by_guide, plain_squares += by_cosine * by_cosine, guided_squares += by_guide * by_guide;
  }
  const auto n = static_cast<double>(vertices);
  EXPECT_NEAR(error / n, 0, 4 * std::sqrt(guided_squares) / n);  // four standard errors
  EXPECT_LT(guided_squares, 0.5 * plain_squares);
}

}  // namespace
}  // namespace strad
