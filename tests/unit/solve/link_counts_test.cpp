// Links counted at their receivers, and the mesh that shows them.
#include "solve/links/link_counts.h"

#include <gtest/gtest.h>

#include "transport_bench.h"

namespace strad {
namespace {

// Two walls that face one another, the first split into four.
struct Walls {
  Workbench bench;
  std::vector<uint32_t> quarters;
  Walls() : bench(scene()), quarters(bench.children_of(0)) {}
  static Scene scene() {
    Scene scene;
    scene.end = 1;
    add_polygon(&scene, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    add_polygon(&scene, {{0, 0, 1}, {0, 2, 1}, {2, 2, 1}, {2, 0, 1}});
    return scene;
  }
  // One still link to the first wall, two intervals of one that changes and a still one to its first quarter,
  // none to the second wall.
  LinkTable table() const {
    const Interval all = bench.always(), first{0, all.log2_cells - 1},
                   second{first.cell_count(), all.log2_cells - 1};
    return make_link_table(
        bench.grid, static_cast<uint32_t>(bench.nodes->nodes().size()),
        {link_of(0, 1, all, {0.1f}), link_of(quarters[0], 1, first, {0.1f, 0.2f}),
         link_of(quarters[0], 1, second, {0.2f, 0.3f}), link_of(quarters[0], 1, all, {0.1f})});
  }
};

// Four at the first quarter, of which it has one from its parent; that one at the other quarters.
TEST(LinkCounts, AreThoseOfANodeAndItsAncestors) {
  const Walls walls;
  const std::vector<uint32_t> arriving = arriving_links(*walls.bench.nodes, walls.table());
  EXPECT_EQ(arriving[0], 1u);
  EXPECT_EQ(arriving[1], 0u);
  EXPECT_EQ(arriving[walls.quarters[0]], 4u);
  for (int q = 1; q < 4; ++q) EXPECT_EQ(arriving[walls.quarters[static_cast<size_t>(q)]], 1u);
}

// Five leaves: four quarters and the other wall, with 4 corners of 15 bytes and 1 + 4 * 4 + 4 bytes a face.
// The wall comes first among the leaves, black and without links; the first quarter, with most, is white.
TEST(LinkCounts, PlyHoldsALeafAFace) {
  const Walls walls;
  const std::string ply = links_as_ply(*walls.bench.nodes, walls.table());
  const std::string end = "end_header\n";
  const size_t body = ply.find(end) + end.size();
  EXPECT_NE(ply.find("element vertex 20\n"), std::string::npos);
  EXPECT_NE(ply.find("element face 5\n"), std::string::npos);
  ASSERT_EQ(ply.size(), body + 5 * (4 * 15 + 21));
  const auto byte = [&](size_t at) { return static_cast<uint8_t>(ply[body + at]); };
  const auto colour = [&](size_t leaf) {
    return std::vector<int>{byte(60 * leaf + 12), byte(60 * leaf + 13)};
  };
  const auto links = [&](size_t leaf) { return static_cast<int>(byte(5 * 60 + 21 * leaf + 17)); };
  EXPECT_EQ(colour(0), (std::vector<int>{0, 0}));
  EXPECT_EQ(colour(1), (std::vector<int>{255, 255}));
  const std::vector<int> expected{0, 4, 1, 1, 1};
  for (size_t leaf = 0; leaf < 5; ++leaf) EXPECT_EQ(links(leaf), expected[leaf]) << "leaf " << leaf;
}

}  // namespace
}  // namespace strad
