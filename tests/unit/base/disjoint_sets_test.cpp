// Disjoint sets, and loops shared among threads.
#include "base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <atomic>

#include "base/parallel.h"

namespace strad {
namespace {

TEST(DisjointSets, EveryMemberFindsTheLowestOfItsSet) {
  DisjointSets sets(6);
  sets.join(5, 3);
  sets.join(3, 1);
  sets.join(4, 2);
  EXPECT_EQ(sets.find(5), 1u);
  EXPECT_EQ(sets.find(3), 1u);
  EXPECT_EQ(sets.find(4), 2u);
  EXPECT_EQ(sets.find(0), 0u);
}

TEST(Parallel, RangesCoverEverythingOnceAndKeepToTheGrain) {
  std::vector<std::atomic<int>> visits(1000);
  std::atomic<bool> too_long = false;
  parallel_for(visits.size(), 7, [&](size_t begin, size_t end) {
    if (end - begin > 7) too_long = true;
    for (size_t i = begin; i < end; ++i) ++visits[i];
  });
  EXPECT_FALSE(too_long);
  for (const auto& count : visits) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace strad
