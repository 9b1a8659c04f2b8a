// Directions of rays, and their densities.
#include "solve/gather/direction_guide.h"

#include <gtest/gtest.h>

#include <cmath>

namespace strad {
namespace {

// All light comes from one bin of 64, a hundred rays in each. Half of the rays go everywhere. The root mean
// square is 1 in that bin and sqrt(2 / 64 / 102) = 0.0175 in the others, so its density is
// 0.5 + 0.5 * 64 / (1 + 63 * 0.0175) = 15.7.
DirectionDensity density_with_a_gap(Point2 gap) {
  DirectionCounts counts;
  for (int i = 0; i < 6400; ++i) {
    const Point2 xi{(i / 80 + 0.5) / 80, (i % 80 + 0.5) / 80};
    const double brought = direction_bin(xi) == direction_bin(gap) ? 1 : 0;
    counts.add(xi, brought, brought * brought);
  }
  return DirectionDensity(counts);
}

TEST(DirectionDensity, IsHighWhereLightComesFrom) {
  const Point2 gap{0.3, 0.7};
  const DirectionDensity density = density_with_a_gap(gap);
  int there = 0;
  double weights = 0;
  for (int i = 0; i < 10000; ++i) {
    float at = 0;
    const Point2 xi = density.warp({(i / 100 + 0.5) / 100, (i % 100 + 0.5) / 100}, &at);
    if (direction_bin(xi) == direction_bin(gap)) {
      ++there;
      EXPECT_NEAR(at, 15.7, 0.2);
    }
    weights += 1 / at;
  }
  EXPECT_NEAR(there, 10000 * 15.7 / 64, 60);
  EXPECT_NEAR(weights / 10000, 1, 0.01);  // the integral of 1
}

// By the cosine, one ray in 64 brings 1: the variance is 63 times the square of the mean. Of this density a
// ray brings 1 / 15.7 with a probability of 15.7 / 64: 64 / 15.7 - 1 = 3.1, and a little more since nothing
// is held to bring quite nothing.
TEST(DirectionDensity, KnowsTheDeviationThatIsLeft) {
  const float deviation = density_with_a_gap({0.3, 0.7}).deviation();
  EXPECT_GT(deviation, std::sqrt(3.1f));
  EXPECT_LT(deviation, std::sqrt(3.1f + 64 * 64 * (2.0f / 64 / 102) / 0.52f));
}

// A tenth of the rays that tell directions for sure moves the density by a tenth as much.
TEST(DirectionDensity, FewRaysHardlyMoveIt) {
  DirectionCounts counts;
  counts.add({0.3, 0.7}, 1, 1);
  float at = 0;
  DirectionDensity(counts).warp({0.3, 0.7}, &at);
  EXPECT_NEAR(at, 1, 0.05);
}

TEST(DirectionDensity, IsUniformWhereNothingIsKnown) {
  float at = 0;
  const Point2 xi = DirectionDensity(DirectionCounts{}).warp({0.31, 0.72}, &at);
  EXPECT_EQ(at, 1);
  EXPECT_NEAR(xi.u, 0.31, 1e-6);
  EXPECT_NEAR(xi.v, 0.72, 1e-6);
}

}  // namespace
}  // namespace strad
