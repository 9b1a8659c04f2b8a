// Leaves are divided where the light on them varies, as finely as the error asks for.
#include "solve/links/divided_leaves.h"

#include <gtest/gtest.h>

#include "refined.h"

namespace strad {
namespace {

// A room of 4 x 3 x 2 m whose floor, polygon 0, has a spotlight's beam on it. Links are so coarse that its
// six faces are leaves.
struct SpotlitFloor : Refined {
  static Scene room() {
    Scene scene;
    scene.end = 1;
    add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
    add_spot(&scene, {1, 0.75, 1.9}, {1, 0.75, 0}, 0.2, 0.3, {10, 10, 10});
    return scene;
  }
  SpotlitFloor() : Refined(room(), Roots::kFaces, {100}) {}
  size_t parts_with(double threshold) {
    divide_leaves(*refinement, threshold, bench.nodes.get());
    size_t parts = 0;
    for (const Node& node : bench.nodes->nodes()) parts += node.is_part;
    return parts;
  }
};

TEST(DividedLeaves, AreWhereLightVaries) {
  SpotlitFloor lit;
  const size_t faces = lit.bench.nodes->nodes().size();
  EXPECT_EQ(lit.parts_with(1e-3), 4u + 16u);  // two levels
  for (size_t n = faces; n < lit.bench.nodes->nodes().size(); ++n)
    EXPECT_EQ(lit.bench.nodes->nodes()[n].face, 0u);
}

// The mean of the quarters' squared differences is known: the beam lies in one quarter of the floor, so that
// has four times the mean and the others nothing. The rms difference is sqrt(3) times the mean.
TEST(DividedLeaves, FollowTheError) {
  SpotlitFloor lit;
  const Node& floor = lit.bench.nodes->nodes()[0];
  const double error = std::sqrt(3.0) * lit.refinement->shading_of(0).radiance *
                       std::sqrt(floor.area / lit.refinement->total_area());
  EXPECT_EQ(lit.parts_with(1.01 * error), 0u);
  EXPECT_EQ(lit.parts_with(0.99 * error), 4u);  // errors of quarters are a quarter of it
}

TEST(DividedLeaves, AreFewerWhereErrorsCountLess) {
  SpotlitFloor lit;
  lit.light_all(1);  // as bright everywhere: no quarter differs but by direct light
  EXPECT_EQ(lit.parts_with(10), 0u);
}

}  // namespace
}  // namespace strad
