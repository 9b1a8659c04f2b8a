// Which links the oracle makes: every exchange once, finer for smaller errors, split in time only for
// geometry.
#include "solve/links/refinement.h"

#include <gtest/gtest.h>

#include "refined.h"

namespace strad {
namespace {

// A room with a spotlight that moves, and with a plate that does where `plate` says so.
Scene room(bool plate) {
  Scene scene;
  scene.end = 8;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  add_spot(&scene, {2, 1.5, 1.9}, {1, 1, 0}, 0.4, 0.6, {10, 10, 10});
  scene.spots[0].keys.push_back({8, {2, 1.5, 1.9}, {3, 2, 0}, {10, 10, 10}});
  if (plate)
    add_polygon(&scene, {{0.5, 1, 1}, {1.5, 1, 1}, {1.5, 2, 1}, {0.5, 2, 1}}, add_body(&scene, {2, 0, 0}));
  return scene;
}

struct RoomRefined : Refined {
  RoomRefined(bool plate, std::initializer_list<double> thresholds)
      : Refined(room(plate), Roots::kFaces, thresholds) {}
};

TEST(Refinement, EveryExchangeIsLinkedOnceAtATime) {
  const RoomRefined refined(true, {0.02, 0.005});
  const size_t nodes = refined.bench.nodes->nodes().size(), cells = refined.bench.grid.cell_count();
  std::vector<uint8_t> blocked(nodes * nodes * cells, 0);
  uint64_t twice = 0, linked = 0;
  for (const Link& link : refined.links())
    for (const uint32_t p : leaves_below(*refined.bench.nodes, link.receiver))
      for (const uint32_t q : leaves_below(*refined.bench.nodes, link.emitter))
        for (uint32_t c = link.interval.cell; c < link.interval.cell + link.interval.cell_count(); ++c) {
          twice += blocked[(p * nodes + q) * cells + c]++ > 0;
          ++linked;
        }
  EXPECT_EQ(twice, 0u);
  EXPECT_GT(linked, 1000u);
}

TEST(Refinement, NothingIsSplitInTimeWhileNothingMoves) {
  const RoomRefined still(false, {0.005});
  for (const Link& link : still.links()) {
    EXPECT_FALSE(link.estimate.dynamic);
    EXPECT_EQ(link.interval, still.bench.always());
  }
  EXPECT_EQ(still.refinement->counts().refined_in_time, 0u);
  EXPECT_GT(still.refinement->counts().refined_in_space, 0u);
  const RoomRefined moving(true, {0.001});
  EXPECT_GT(moving.refinement->counts().refined_in_time, 0u);
}

TEST(Refinement, SmallerErrorsNeedMoreLinks) {
  size_t last = 0;
  for (const double threshold : {0.01, 0.002, 0.0005}) {
    const RoomRefined refined(false, {threshold});
    EXPECT_GT(refined.links().size(), last);
    last = refined.links().size();
  }
}

TEST(Refinement, LinksJoinSurfacesThatSeeEachOther) {
  const RoomRefined refined(false, {0.01});
  const std::vector<Node>& nodes = refined.bench.nodes->nodes();
  for (const Link& link : refined.links()) {
    EXPECT_NE(nodes[link.receiver].face, nodes[link.emitter].face);
    EXPECT_GT(link.estimate.kernel[0], 0);
    EXPECT_LT(link.estimate.kernel[0], kPi);
  }
}

// Before anything is reflected only what is lit directly emits: the ceiling, out of the beam, does not.
TEST(Refinement, OnlyLitSurfacesEmit) {
  const RoomRefined refined(false, {0.01});
  const std::vector<Node>& nodes = refined.bench.nodes->nodes();
  bool floor = false;
  for (const Link& link : refined.links()) {
    EXPECT_NE(nodes[link.emitter].face, 1u);
    floor = floor || nodes[link.emitter].face == 0;
  }
  EXPECT_TRUE(floor);
}

}  // namespace
}  // namespace strad
