// Colours: arithmetic by channel, luminance, largest channel, black and finite colours.
#include "base/rgb.h"

#include <gtest/gtest.h>

#include <limits>

namespace strad {
namespace {

TEST(Rgb, ArithmeticGoesByChannel) {
  const Rgb a{1, 2, 3}, b{0.5f, 0.25f, 4};
  EXPECT_EQ(a + b, (Rgb{1.5f, 2.25f, 7}));
  EXPECT_EQ(a - b, (Rgb{0.5f, 1.75f, -1}));
  EXPECT_EQ(a * b, (Rgb{0.5f, 0.5f, 12}));
  EXPECT_EQ(2 * a, (Rgb{2, 4, 6}));
  EXPECT_EQ(a * 2, 2 * a);
}

TEST(Rgb, ChannelsAreRedGreenBlue) {
  Rgb a{1, 2, 3};
  EXPECT_EQ(a[0], a.r);
  EXPECT_EQ(a[1], a.g);
  EXPECT_EQ(a[2], a.b);
  a[2] = 9;
  EXPECT_EQ(a, (Rgb{1, 2, 9}));
}

// The weights of Rec. 709 add up to 1, so white keeps its luminance.
TEST(Rgb, LuminanceOfWhiteIsOneAndGreenCountsMost) {
  EXPECT_FLOAT_EQ(luminance({1, 1, 1}), 1);
  EXPECT_GT(luminance({0, 1, 0}), luminance({1, 0, 0}));
  EXPECT_GT(luminance({1, 0, 0}), luminance({0, 0, 1}));
  EXPECT_EQ(luminance({}), 0);
}

TEST(Rgb, LargestChannelIsFoundWhereverItIs) {
  EXPECT_EQ(max_channel({3, 1, 2}), 3);
  EXPECT_EQ(max_channel({1, 3, 2}), 3);
  EXPECT_EQ(max_channel({1, 2, 3}), 3);
  EXPECT_EQ(max_channel({-3, -1, -2}), -1);
}

TEST(Rgb, BlackIsAllChannelsZero) {
  EXPECT_TRUE(is_black({}));
  EXPECT_FALSE(is_black({1, 0, 0}));
  EXPECT_FALSE(is_black({0, 1, 0}));
  EXPECT_FALSE(is_black({0, 0, 1e-30f}));
}

TEST(Rgb, OneChannelBeyondNumbersIsEnough) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(is_finite(Rgb{1, -2, 3e38f}));
  EXPECT_FALSE(is_finite(Rgb{kInfinity, 0, 0}));
  EXPECT_FALSE(is_finite(Rgb{0, nan, 0}));
  EXPECT_FALSE(is_finite(Rgb{0, 0, -kInfinity}));
}

}  // namespace
}  // namespace strad
