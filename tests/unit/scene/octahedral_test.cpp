// Normals survive 32 bits, and their codes survive being read and written again.
#include "scene/octahedral.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

TEST(Octahedral, DirectionsComeBackWithin0003Degrees) {
  // Codes are 1/32767 apart, so at most sqrt(2) / 2 of that away in the square. Its map to the sphere
  // stretches lengths by at most sqrt(3) where the octahedron's faces are nearest to the centre, at 1 /
  // sqrt(3): by 3 / 1 along the slope at most. 3 * 0.7071 / 32767 rad = 0.0037 degrees bounds what the survey
  // measures as less.
  double worst = 0;
  for (uint32_t i = 0; i < 20000; ++i) {
    const double z = 2 * unit_from(hash_of(i, 1)) - 1, angle = 2 * kPi * unit_from(hash_of(i, 2));
    const Vec3 v{std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
    const Vec3 back = octahedral_vector(octahedral_code(3.5 * v));
    worst = std::max(worst, length(cross(v, back)));
    EXPECT_NEAR(length(back), 1, 1e-12);
    EXPECT_GT(dot(v, back), 0);
  }
  EXPECT_LT(worst * 180 / kPi, 0.0037);
}

TEST(Octahedral, AxesAreExact) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3 v;
      v[axis] = sign;
      EXPECT_EQ(octahedral_vector(octahedral_code(v)), v);
    }
  }
}

TEST(Octahedral, CodesOfDecodedVectorsStay) {
  // Also on the border of the square, where two codes mean one direction.
  for (uint32_t i = 0; i < 20000; ++i) {
    uint32_t code = static_cast<uint32_t>(hash_of(i, 3));
    if (i % 4 == 1) code &= 0xffff;             // u = -1
    if (i % 4 == 2) code = code << 16 | 65534;  // v = 1
    const uint32_t once = octahedral_code(octahedral_vector(code));
    EXPECT_EQ(octahedral_code(octahedral_vector(once)), once) << code;
  }
}

}  // namespace
}  // namespace strad
