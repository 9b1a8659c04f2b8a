// Numbers, vectors and names as POV-Ray reads them.
#include <gtest/gtest.h>

#include <cstdio>

#include "base/rng.h"
#include "export/pov/text.h"

namespace strad {
namespace {

TEST(PovText, ColoursKeepFiveDigitsOverTheWholeRangeOfFloats) {
  for (int i = 0; i < 20000; ++i) {
    const double exponent = -30 + 65 * unit_from(hash_of(i, 1));
    const auto value = static_cast<float>(std::pow(10.0, exponent) * (i % 2 ? 1 : -1));
    const std::string text = (PovText() << Rgb{value, 0, value}).take();
    double r = 0, g = 1, b = 0;
    ASSERT_EQ(std::sscanf(text.c_str(), "<%lf,%lf,%lf>", &r, &g, &b), 3) << text;
    ASSERT_NEAR(r / value, 1, 5.1e-5) << text;
    ASSERT_EQ(g, 0);
    ASSERT_EQ(b, r);
  }
}

TEST(PovText, ColoursAtPowersOfTen) {
  EXPECT_EQ((PovText() << Rgb{1, 10, 100000}).take(), "<10000e-4,10000e-3,10000e1>");
  EXPECT_EQ((PovText() << Rgb{0.1f, 0.999999f, 12345}).take(), "<10000e-5,10000e-4,12345>");
}

TEST(PovText, PointsReadBackAsTheSameFloats) {
  EXPECT_EQ((PovText() << Vec3{0.1, -2, 1e-7}).take(), "<0.1,-2,1e-07>");
  EXPECT_EQ(PovText().exact({0.1, 1.0 / 3, -5}).take(), "<0.1,0.3333333333333333,-5>");
}

// A quarter turn about z takes x to y and y to -x; POV-Ray's matrix has these images as its rows.
TEST(PovText, PosesAreRowsOfImages) {
  const Pose pose{rotation_about({0, 0, 1}, kPi / 2), {4, 5, 6}};
  double m[12];
  const std::string text = (PovText() << pose).take();
  ASSERT_EQ(std::sscanf(text.c_str(), "matrix <%lf,%lf,%lf, %lf,%lf,%lf, %lf,%lf,%lf, %lf,%lf,%lf>", m, m + 1,
                        m + 2, m + 3, m + 4, m + 5, m + 6, m + 7, m + 8, m + 9, m + 10, m + 11),
            12);
  const double expected[12] = {0, 1, 0, -1, 0, 0, 0, 0, 1, 4, 5, 6};
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(m[i], expected[i], 1e-15) << i;
}

TEST(PovText, IdentifiersArePlainAndUnique) {
  const std::vector<std::string> expected{"crane_1", "crane_1_2", "crane_1_3", "_", "__2"};
  EXPECT_EQ(pov_identifiers({"crane.1", "crane 1", "crane-1", "\"", "{"}), expected);
}

}  // namespace
}  // namespace strad
