// Solid angles of triangles and directions within them.
#include "frame/spherical_triangle.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

TEST(SphericalTriangle, OctantIsAnEighthOfTheSphere) {
  EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), kPi / 2, 1e-12);
}

// The mean of a direction over the octant: each coordinate averages 1/2 over the hemisphere it points to, and
// by symmetry over each of its four octants. The mean of z^2 is 1/3, as over the sphere.
TEST(SphericalTriangle, DirectionsAreUniformInSolidAngle) {
  const Vec3 a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1};
  constexpr int kSide = 64;
  Vec3 sum;
  double squares = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec3 d = direction_in(a, b, c, kPi / 2, (i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
    EXPECT_NEAR(length(d), 1, 1e-9);
    EXPECT_GE(std::min({d.x, d.y, d.z}), -1e-9);
    sum += d / (kSide * kSide);
    squares += d.z * d.z / (kSide * kSide);
  }
  // The midpoint rule with 64 points a side errs by less than 1e-3 on smooth functions of slope about 1.
  EXPECT_NEAR(sum.x, 0.5, 1e-3);
  EXPECT_NEAR(sum.y, 0.5, 1e-3);
  EXPECT_NEAR(sum.z, 0.5, 1e-3);
  EXPECT_NEAR(squares, 1.0 / 3, 1e-3);
}

}  // namespace
}  // namespace strad
