// Mattes are those of the Cryptomatte specification, so that compositors find things by their names.
#include "frame/cryptomatte.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace strad {
namespace {

TEST(Cryptomatte, HashIsMurmurHash3) {
  // Published test vectors of MurmurHash3_x86_32 with seed 0.
  EXPECT_EQ(murmur_hash(""), 0u);
  EXPECT_EQ(murmur_hash("test"), 0xba6bd213u);
  EXPECT_EQ(murmur_hash("hello"), 0x248bfa47u);
  EXPECT_EQ(murmur_hash("hello, world"), 0x149bbb7fu);
  EXPECT_EQ(murmur_hash("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(Cryptomatte, IdsAreNormalFiniteNumbers) {
  // One name in 128 has an exponent of 0 or 255, which would be denormal, infinite or not a number.
  for (int i = 0; i < 4096; ++i) {
    const float id = cryptomatte_id("thing" + std::to_string(i));
    EXPECT_TRUE(std::isnormal(id)) << i;
    // The specification changes the lowest bit of the exponent, and nothing else.
    const uint32_t change = std::bit_cast<uint32_t>(id) ^ murmur_hash("thing" + std::to_string(i));
    EXPECT_TRUE(change == 0 || change == 1u << 23);
  }
}

TEST(Cryptomatte, RanksThingsByCoverageAndNamesThem) {
  Cryptomatte matte("CryptoObject", {"a", "b\"c", "d"}, 2, 1);
  Coverage coverage;
  coverage.add(2, 0.25f);
  coverage.add(0, 0.125f);
  coverage.add(2, 0.125f);
  coverage.add(1, 0.5f);
  matte.set(1, 0, coverage);
  LayeredImage image{2, 1, {}, {}};
  matte.finish(&image);
  ASSERT_EQ(image.layers.size(), 3u);
  EXPECT_EQ(image.layers[0].name, "CryptoObject00");
  EXPECT_EQ(image.layers[0].channels, "RGBA");
  EXPECT_TRUE(image.layers[0].exact);
  EXPECT_EQ(image.layers[0].samples,
            (std::vector<float>{0, 0, 0, 0, cryptomatte_id("b\"c"), 0.5f, cryptomatte_id("d"), 0.375f}));
  EXPECT_EQ(image.layers[1].samples, (std::vector<float>{0, 0, 0, 0, cryptomatte_id("a"), 0.125f, 0, 0}));
  // The key is made of the first 7 digits of the hash of the name.
  ASSERT_EQ(image.texts.size(), 4u);
  char key[32];
  std::snprintf(key, sizeof key, "cryptomatte/%07x/", murmur_hash("CryptoObject") >> 4);
  EXPECT_EQ(image.texts[0], (std::pair{key + std::string("name"), std::string("CryptoObject")}));
  EXPECT_EQ(image.texts[1].second, "MurmurHash3_32");
  EXPECT_EQ(image.texts[2].second, "uint32_to_float32");
  char manifest[96];
  std::snprintf(manifest, sizeof manifest, R"({"a":"%08x","b\"c":"%08x","d":"%08x"})",
                std::bit_cast<uint32_t>(cryptomatte_id("a")), std::bit_cast<uint32_t>(cryptomatte_id("b\"c")),
                std::bit_cast<uint32_t>(cryptomatte_id("d")));
  EXPECT_EQ(image.texts[3], (std::pair{key + std::string("manifest"), std::string(manifest)}));
}

}  // namespace
}  // namespace strad
