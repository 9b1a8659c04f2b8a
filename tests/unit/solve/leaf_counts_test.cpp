// Counts of rays by leaf.
#include "solve/gather/leaf_counts.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

// Leaf l is seen l % 7 times at the second of three looks, and once at the third: more leaves than the table
// has room for at first.
TEST(LeafCounts, AreThoseOfEachLeafAndLook) {
  LeafCounts counts(3);
  constexpr uint32_t kLeaves = 1000;
  for (int round = 0; round < 7; ++round)
    for (uint32_t leaf = 0; leaf < kLeaves; ++leaf)
      if (round < static_cast<int>(leaf % 7)) counts.add(5000 - leaf, 1, 1);
  for (uint32_t leaf = 0; leaf < kLeaves; ++leaf) counts.add(5000 - leaf, 2, 1);
  ASSERT_EQ(counts.leaves().size(), kLeaves);
  for (size_t row = 0; row < kLeaves; ++row) {
    const uint32_t leaf = 5000 - counts.leaves()[row];
    EXPECT_EQ(counts.counts(row)[0], 0);
    EXPECT_EQ(counts.counts(row)[1], static_cast<float>(leaf % 7));
    EXPECT_EQ(counts.counts(row)[2], 1);
  }
  EXPECT_EQ(counts.leaves()[0], 4999u);  // leaf 0 of 7 has no rays in the first rounds
}

}  // namespace
}  // namespace strad
