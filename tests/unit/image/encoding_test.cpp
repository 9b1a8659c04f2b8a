// Light becomes whole numbers by the curve that is asked for, without bands and without a change of the mean.
#include "image/encoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "image/srgb.h"

namespace strad {
namespace {

TEST(Encoding, DitheredBytesHaveTheMeanOfTheLight) {
  // Light that lies between two bytes on the curve, in every place of a step: 64 thresholds a block of 8 x 8
  // pixels, so that the mean byte of a block is off by at most 1/64, and by half of that beside it.
  for (int step = 0; step < 100; ++step) {
    const float value = 100 + static_cast<float>(step) / 100;
    const Image image(24, 16, {linear_from_srgb(value / 255), 0, 1});
    Encoding encoding;
    encoding.dither = true;
    const std::vector<uint8_t> bytes = bytes_of(image, encoding);
    double sum = 0;
    for (size_t i = 0; i < bytes.size(); i += 3) {
      sum += bytes[i];
      ASSERT_TRUE(bytes[i] == 100 || bytes[i] == 101);
      ASSERT_EQ(bytes[i + 1], 0);
      ASSERT_EQ(bytes[i + 2], 255);
    }
    EXPECT_NEAR(sum / (24 * 16), value, 1.01 / 64) << step;
  }
}

TEST(Encoding, LightWithAByteOfItsOwnKeepsItWhenDithered) {
  for (int byte = 0; byte < 256; ++byte) {
    const float light = linear_from_byte(static_cast<uint8_t>(byte));
    const Image image(8, 8, {light, light, light});
    Encoding encoding;
    encoding.dither = true;
    for (const uint8_t found : bytes_of(image, encoding)) ASSERT_EQ(found, byte);
  }
}

TEST(Encoding, NeighboursOfTheDitherPatternDifferByAboutHalfAStep) {
  // At half a step, Bayer's matrix is a chessboard.
  const float light = linear_from_srgb(100.5f / 255);
  const Image image(8, 8, {light, light, light});
  Encoding encoding;
  encoding.dither = true;
  const std::vector<uint8_t> bytes = bytes_of(image, encoding);
  for (size_t y = 0; y < 8; ++y)
    for (size_t x = 0; x < 8; ++x) EXPECT_EQ(bytes[3 * (8 * y + x)] - 100, (x + y) % 2 == 0 ? 0 : 1);
}

TEST(Encoding, WordsAreWithinHalfAStep) {
  const Image image(1, 1, {0.2f, 0.5f, 2});
  const std::vector<uint16_t> words = words_of(image, {});
  EXPECT_NEAR(words[0], 65535 * srgb_from_linear(0.2f), 0.51);
  EXPECT_NEAR(words[1], 65535 * srgb_from_linear(0.5f), 0.51);
  EXPECT_EQ(words[2], 65535);
}

TEST(Encoding, LinearNumbersAreInProportionToLightUpToWhite) {
  Encoding encoding{Depth::kByte, ToneCurve::kLinear, 2, false};
  const Image image(1, 1, {1, 0.5f, 3});  // of a white of 2: 1/2, 1/4, above
  const std::vector<uint8_t> bytes = bytes_of(image, encoding);
  EXPECT_EQ(bytes, (std::vector<uint8_t>{128, 64, 255}));
}

TEST(Encoding, FilmicIsHablesCurve) {
  const Encoding encoding{Depth::kUsual, ToneCurve::kFilmic, usual_white(ToneCurve::kFilmic), false};
  EXPECT_EQ(shown_light(0.0f, encoding), 0);
  EXPECT_EQ(shown_light(5.6f, encoding), 1);
  EXPECT_EQ(shown_light(100.0f, encoding), 1);
  EXPECT_EQ(shown_light(std::numeric_limits<float>::quiet_NaN(), encoding), 0);
  // f(x) = (x (0.15 x + 0.05) + 0.004) / (x (0.15 x + 0.5) + 0.06) - 1/15, Hable's slide with his constants.
  // f(0.36) = 0.041440 / 0.259440 - 1/15 = 0.093062; f(11.2) = 19.380 / 24.476 - 1/15 = 0.725129.
  EXPECT_NEAR(shown_light(0.18f, encoding), 0.093062 / 0.725129, 1e-4);
  float last = 0;
  for (float light = 0.01f; light < 5.6f; light += 0.01f) {
    const float shown = shown_light(light, encoding);
    EXPECT_GT(shown, last);
    last = shown;
  }
}

}  // namespace
}  // namespace strad
