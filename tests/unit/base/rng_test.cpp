// Counter-based random numbers: known values, range, evenness.
#include "base/rng.h"

#include <gtest/gtest.h>

#include <array>

namespace strad {
namespace {

// The first outputs of SplitMix64 seeded with 0, whose state grows by this step at each call.
TEST(Rng, MixIsSplitMix64) {
  EXPECT_EQ(mix64(0), 0xe220a8397b1dcdafu);
  EXPECT_EQ(mix64(0x9e3779b97f4a7c15u), 0x6e789e6aa1b965f4u);
}

TEST(Rng, HashDependsOnTheOrderOfItsParts) {
  EXPECT_NE(hash_of(1, 2, 3), hash_of(3, 2, 1));
  EXPECT_NE(hash_of(1, 2), hash_of(2, 1));
}

TEST(Rng, UnitCoversZeroToBelowOne) {
  EXPECT_EQ(unit_from(0), 0);
  EXPECT_EQ(unit_from(uint64_t{1} << 63), 0.5);
  EXPECT_LT(unit_from(~uint64_t{0}), 1);
}

// 256 points in 64 cells, 4 per cell on average: a low-discrepancy sequence leaves no cell empty.
TEST(Rng, R2PointsFillEveryCell) {
  std::array<int, 64> cells{};
  for (uint32_t i = 0; i < 256; ++i) {
    const Point2 p = r2_point(i, 0.3, 0.8);
    ASSERT_TRUE(p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1);
    ++cells[static_cast<size_t>(p.u * 8) * 8 + static_cast<size_t>(p.v * 8)];
  }
  for (const int count : cells) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace strad
