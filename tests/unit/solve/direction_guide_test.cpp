// Directions of rays, and their densities.
#include "solve/gather/direction_guide.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

// All light comes from one bin of 64, a hundred rays in each. Half of the rays go everywhere. The root mean
// square is 1 in that bin and sqrt(2 / 64 / 102) = 0.0175 in the others, so its density is
// 0.5 + 0.5 * 64 / (1 + 63 * 0.0175) = 15.7.
DirectionDensity density_with_a_gap(Point2 gap) {
  DirectionCounts counts;
  for (int i = 0; i < 6400; ++i) {
    const Point2 xi{(i / 80 + 0.5) / 80, (i % 80 + 0.5) / 80};
    counts.add(xi, direction_bin(xi) == direction_bin(gap) ? 1 : 0);
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

TEST(DirectionDensity, IsUniformWhereNothingIsKnown) {
  float at = 0;
  const Point2 xi = DirectionDensity(DirectionCounts{}).warp({0.31, 0.72}, &at);
  EXPECT_EQ(at, 1);
  EXPECT_NEAR(xi.u, 0.31, 1e-6);
  EXPECT_NEAR(xi.v, 0.72, 1e-6);
}

}  // namespace
}  // namespace strad
