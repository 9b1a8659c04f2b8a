// Metrics against values derived by hand.
#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/rng.h"

namespace strad {
namespace {

TEST(Metrics, EqualPicturesDoNotDiffer) {
  const Image image(3, 2, {0.1f, 0.2f, 0.3f});
  const Comparison same = compare(image, image);
  EXPECT_EQ(rel_rmse(same), 0);
  EXPECT_EQ(same.largest, 0);
  EXPECT_EQ(bias(same), 0);
}

TEST(Metrics, OneWrongPixelIsNamed) {
  // 6 pixels of 3 channels, mean 2 in the reference; one channel is 3 too large:
  // RMSE = sqrt(9 / 18), rel_rmse = that / 2; bias = 3 / 18 / 2.
  const Image a(3, 2, {2, 2, 2});
  Image b = a;
  b.at(2, 1).g = 5;
  const Comparison comparison = compare(a, b);
  EXPECT_DOUBLE_EQ(rel_rmse(comparison), std::sqrt(0.5) / 2);
  EXPECT_NEAR(bias(comparison), 1.0 / 12, 1e-12);
  EXPECT_EQ(comparison.largest, 3);
  EXPECT_EQ(comparison.worst.x, 2u);
  EXPECT_EQ(comparison.worst.y, 1u);
  EXPECT_EQ(comparison.worst.channel, 1);
  EXPECT_EQ(comparison.worst.a, 2);
  EXPECT_EQ(comparison.worst.b, 5);
}

TEST(Metrics, LeftOutPixelsDoNotCount) {
  const Image a(2, 1, {1, 1, 1});
  Image b = a;
  b.at(1, 0) = {9, 9, 9};
  EXPECT_EQ(compare(a, b, nullptr, {false, true}).largest, 0);
  EXPECT_EQ(compare(a, b, nullptr, {true, false}).largest, 8);
}

TEST(Metrics, ATwinTakesTheNoiseOfTheReferenceOut) {
  // Truth 1, two references with uniform noise in [-0.5, 0.5), an error of 0.1 everywhere. The estimate of
  // the mean square 0.01 has a standard deviation of about sqrt((1/12)^2 + 2 * 0.01 / 12) / sqrt(3 * 10^4) =
  // 5e-4: four of them are allowed.
  Image a(100, 100), twin(100, 100);
  const Image b(100, 100, {1.1f, 1.1f, 1.1f});
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const uint64_t key = 3 * i + static_cast<uint64_t>(channel);
      a.pixels[i][channel] = static_cast<float>(0.5 + unit_from(hash_of(1, key)));
      twin.pixels[i][channel] = static_cast<float>(0.5 + unit_from(hash_of(2, key)));
    }
  EXPECT_NEAR(compare(a, b, &twin).mean_square, 0.01, 0.002);
  EXPECT_GT(compare(a, b).mean_square, 0.08);
}

TEST(Metrics, BlackReferences) {
  const Image black(2, 2), grey(2, 2, {1, 1, 1});
  EXPECT_EQ(rel_rmse(compare(black, black)), 0);
  EXPECT_EQ(rel_rmse(compare(black, grey)), std::numeric_limits<double>::infinity());
}

TEST(Metrics, FlickerIsTheSecondDifferenceOfTime) {
  // Luminance 1, 1, 1.3 in half of the pixels: second difference 0.3 there, RMS 0.3 / sqrt(2).
  Image before(2, 1, {1, 1, 1}), middle = before, after = before;
  after.at(0, 0) = {1.3f, 1.3f, 1.3f};
  EXPECT_NEAR(flicker(before, middle, after).rms, 0.3 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(flicker(before, middle, after).mean, 1, 1e-6);
  // A steady change is none.
  middle.at(0, 0) = {1.1f, 1.1f, 1.1f};
  after.at(0, 0) = {1.2f, 1.2f, 1.2f};
  EXPECT_NEAR(flicker(before, middle, after).rms, 0, 1e-6);
}

TEST(Metrics, FramesWeighTheSame) {
  const Image a(2, 2, {1, 1, 1}), b(2, 2, {3, 3, 3});
  const Comparison mean = mean_of({compare(a, a), compare(a, b)});
  EXPECT_DOUBLE_EQ(rel_rmse(mean), std::sqrt(2.0));  // mean square (0 + 4) / 2 over mean 1
  EXPECT_EQ(mean.largest, 2);
}

TEST(Metrics, HeatGoesFromBlackToWhite) {
  const Image a(3, 1);
  Image b = a;
  b.at(1, 0).g = -0.2f;
  b.at(2, 0).b = 7;
  const Image heat = heat_map(a, b, 1);
  EXPECT_EQ(heat.at(0, 0), (Rgb{0, 0, 0}));
  EXPECT_NEAR(heat.at(1, 0).b, 1, 1e-5);
  EXPECT_NEAR(heat.at(1, 0).r, 0, 1e-5);
  EXPECT_EQ(heat.at(2, 0), (Rgb{1, 1, 1}));
}

TEST(Metrics, WhatCannotBeComparedIsRefusedByName) {
  Image a(2, 2), b(2, 3);
  EXPECT_THROW(require_equal_sizes(a, "a.exr", b, "b.exr"), BadInput);
  a.at(1, 0).g = std::nanf("");
  try {
    require_finite(a, "a.exr");
    ADD_FAILURE();
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(), "a.exr: the pixel in column 1 of row 0 is not finite");
  }
}

}  // namespace
}  // namespace strad
