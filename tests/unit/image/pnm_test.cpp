// PPM and PFM: literal golden bytes, round trips, and every kind of damaged file.
#include "image/pnm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "image/srgb.h"

namespace strad {
namespace {

Image two_pixels() {
  Image image(2, 1);
  image.at(0, 0) = {0, 0.5f, 1};
  image.at(1, 0) = {-3, 40, 0.0031308f};
  return image;
}

TEST(Ppm, HasTheseBytes) {
  // 255 * (1.055 * 0.5^(1/2.4) - 0.055) = 187.5 rounds to 188; 255 * 12.92 * 0.0031308 = 10.3
  const std::string expected{"P6\n2 1\n255\n\x00\xbc\xff\x00\xff\x0a", 17};
  EXPECT_EQ(encode_ppm(two_pixels()), expected);
}

TEST(Ppm, EveryByteComesBack) {
  Image image(256, 1);
  for (uint32_t x = 0; x < 256; ++x) {
    const float linear = linear_from_byte(static_cast<uint8_t>(x));
    image.at(x, 0) = {linear, linear, linear};
    EXPECT_EQ(srgb_byte(linear), x);
  }
  EXPECT_EQ(decode_pnm(encode_ppm(image), "test"), image);
}

TEST(Ppm, SixteenBitsAndCommentsAreRead) {
  const std::string bytes{"P6 # made by hand\n# 3 4\n1 1\n65535\n\xff\xff\x00\x00\x80\x00", 40};
  const Image image = decode_pnm(bytes, "test");
  EXPECT_EQ(image.at(0, 0).r, 1);
  EXPECT_EQ(image.at(0, 0).g, 0);
  EXPECT_FLOAT_EQ(image.at(0, 0).b, linear_from_srgb(32768.0f / 65535));
}

TEST(Pfm, HasTheseBytes) {
  Image image(1, 1);
  image.at(0, 0) = {1, -2, 0};
  const std::string expected{"PF\n1 1\n-1.0\n\x00\x00\x80\x3f\x00\x00\x00\xc0\x00\x00\x00\x00", 24};
  EXPECT_EQ(encode_pfm(image), expected);
}

TEST(Pfm, RowsComeBackInOrderWithAllTheirBits) {
  Image image(3, 2);
  for (uint32_t i = 0; i < 6; ++i) image.pixels[i] = {0.1f * static_cast<float>(i), 1e30f, -1e-30f};
  image.at(1, 1).g = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(decode_pnm(encode_pfm(image), "test"), image);
}

TEST(Pfm, WhatIsNotFiniteIsRefused) {
  for (const float value :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    Image image(3, 2);
    image.at(1, 0).b = value;
    EXPECT_THROW(decode_pnm(encode_pfm(image), "test"), BadInput);
  }
}

TEST(Pfm, BigEndianAndGreyAreRead) {
  const Image image = decode_pnm(std::string{"Pf\n1 2\n1.0\n\x3f\x80\x00\x00\x40\x00\x00\x00", 19}, "test");
  EXPECT_EQ(image.at(0, 0), (Rgb{2, 2, 2}));  // the first in the file is the lowest row
  EXPECT_EQ(image.at(0, 1), (Rgb{1, 1, 1}));
}

TEST(Pnm, EveryTruncationAndAnyTailIsRefused) {
  for (const std::string& whole : {encode_ppm(two_pixels()), encode_pfm(two_pixels())}) {
    for (size_t length = 0; length < whole.size(); ++length)
      EXPECT_THROW(decode_pnm(whole.substr(0, length), "test"), BadInput) << length;
    EXPECT_THROW(decode_pnm(whole + '\0', "test"), BadInput);
  }
}

TEST(Pnm, LyingHeadersAreRefusedByName) {
  for (const char* header : {"P5\n1 1\n255\n", "P6\n0 1\n255\n", "P6\n-1 1\n255\n", "P6\n1x 1\n255\n",
                             "P6\n4294967295 4294967295\n255\n", "P6\n1 1\n0\nabc", "P6\n1 1\n65536\nabcdef",
                             "PF\n1 1\n0\nabcdabcdabcd", "PF\n1 1\nnan\nabcdabcdabcd", "# only"}) {
    try {
      decode_pnm(header, "small.ppm");
      ADD_FAILURE() << header;
    } catch (const BadInput& error) {
      EXPECT_EQ(std::string(error.what()).rfind("small.ppm: found ", 0), 0u) << error.what();
    }
  }
}

TEST(Exposure, ScalesByPowersOfTwo) {
  Image image = two_pixels();
  expose(&image, -1);
  EXPECT_EQ(image.at(1, 0).g, 20);
}

TEST(Srgb, NotANumberIsBlack) { EXPECT_EQ(srgb_byte(std::nanf("")), 0); }

}  // namespace
}  // namespace strad
