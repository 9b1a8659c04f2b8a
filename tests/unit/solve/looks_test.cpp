// When to look at what moves, and what comes in between.
#include "solve/gather/looks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace strad {
namespace {

// One ray over 10 s in 32 cells. Before `change`, in cells, it sees leaf 1, from then on leaf 2.
Looker looker_at_step(uint32_t change) {
  Looker looker;
  looker.see = [=](uint32_t, uint32_t cell) { return std::vector<Seen>{{cell < change ? 1u : 2u, 1.0f}}; };
  looker.differs = [](const Look& a, const Look& b, const Look& c) {
    return a.seen != b.seen || b.seen != c.seen;
  };
  looker.may_happen = [](uint32_t, uint32_t) { return false; };
  return looker;
}
std::vector<uint32_t> cells_of(const std::vector<Look>& looks) {
  std::vector<uint32_t> cells;
  for (const Look& look : looks) cells.push_back(look.cell);
  return cells;
}
TimeGrid grid() { return make_time_grid(0, 10, {}, 3, 96); }

TEST(Looks, AreFewWhereNothingChanges) {
  const std::vector<Look> looks = looks_over(grid(), looker_at_step(100));
  EXPECT_EQ(cells_of(looks), (std::vector<uint32_t>{0, 8, 16, 24, 32}));
}

// The change is between the cells' ends 12 and 13. Halving [8, 16] leads to 12, [12, 16] to 14 and to 13; the
// halves beside these are looked at once too, for their look in the middle is the proof that nothing changes.
TEST(Looks, CloseInOnAChange) {
  const std::vector<Look> looks = looks_over(grid(), looker_at_step(13));
  const std::vector<uint32_t> cells = cells_of(looks);
  const auto has = [&](uint32_t cell) { return std::find(cells.begin(), cells.end(), cell) != cells.end(); };
  EXPECT_TRUE(has(12) && has(13));
  EXPECT_FALSE(has(29));
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  EXPECT_LT(cells.size(), 17u);
}

// All looks show the same, but something may happen in cell 21: an end of that cell is looked at.
TEST(Looks, GoWhereSomethingMayHappen) {
  Looker looker = looker_at_step(100);
  looker.may_happen = [](uint32_t first, uint32_t end) { return first <= 21 && 21 < end; };
  const std::vector<uint32_t> cells = cells_of(looks_over(grid(), looker));
  EXPECT_EQ(cells, (std::vector<uint32_t>{0, 8, 16, 20, 21, 22, 24, 32}));
}

TEST(Looks, AreApartOnBothSidesOfAStep) {
  const TimeGrid stepped = make_time_grid(0, 10, {5}, 3, 96);
  std::vector<uint32_t> spans;
  for (const Look& look : looks_over(stepped, looker_at_step(100)))
    if (look.cell == 0 || look.cell == 16) spans.push_back(look.span);
  EXPECT_EQ(spans, (std::vector<uint32_t>{0, 0, 1, 1}));
}

TEST(Looks, AreOneAtAnInstant) { EXPECT_EQ(looks_over(instant_grid(3), looker_at_step(1)).size(), 1u); }

// Values at the looks are samples of 5 + 2 t and of its part after 7.5 s, which linear blending gives back.
TEST(Looks, BlendLinearly) {
  const TimeGrid g = grid();
  const std::vector<Look> looks = looks_over(g, looker_at_step(100));
  const LookBlends blends(g, looks);
  std::vector<float> line, late(looks.size(), 0.0f), weights(g.sample_count(), -1.0f);
  for (const Look& look : looks) line.push_back(static_cast<float>(5 + 2 * cell_time(g, look.cell, 0)));
  SampleRange range = blends.weights(line.data(), 0.5f, weights.data());
  EXPECT_EQ(range.first, 0u);
  EXPECT_EQ(range.end, g.sample_count());
  for (uint32_t i = 0; i < g.sample_count(); ++i)
    EXPECT_NEAR(weights[i], 0.5 * (5 + 2 * sample_time(g, i)), 1e-5);
  late.back() = 1;
  range = blends.weights(late.data(), 1, weights.data());
  EXPECT_EQ(range.first, 3 * g.sample_count() / 4);
  EXPECT_EQ(range.end, g.sample_count());
}

}  // namespace
}  // namespace strad
