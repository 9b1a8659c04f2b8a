// Functions of time read at an instant and over a stretch: continuity, steps, means.
#include "time/field.h"

#include <gtest/gtest.h>

#include "field_samples.h"

namespace strad {
namespace {

class FieldOfOrder : public testing::TestWithParam<int> {
 protected:
  // Smooth but for a step at 7, where the grid has a new span; coarse, so that pieces do not meet by
  // themselves.
  static double curve(double t) { return t < 7 ? std::sin(t) + 2 : std::cos(3 * t) - 1; }
  const TimeGrid grid = make_time_grid(0, 20, {7}, GetParam(), 300);
  const Field field = field_of(grid, curve, 0.05f);

  double at(double t, bool continuous) const { return value_at(grid, field, 0, t, continuous).r; }
  // value(t+) - value(t-)
  double jump(double t, bool continuous) const { return at(t, continuous) - at(t - 1e-9, continuous); }
};
INSTANTIATE_TEST_SUITE_P(AllOrders, FieldOfOrder, testing::Values(1, 2, 3));

TEST_P(FieldOfOrder, IsContinuousInsideSpans) {
  double worst = 0, worst_before = 0;
  for (uint32_t c = 1; c < grid.cell_count(); ++c) {
    if (c == grid.spans[1].first_cell) continue;
    const double t = interval_begin(grid, {c, 0});
    worst = std::max(worst, std::abs(jump(t, true)));
    worst_before = std::max(worst_before, std::abs(jump(t, false)));
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GT(worst_before, 1e-3);  // else this tests nothing
}

TEST_P(FieldOfOrder, StepsStaySharp) {
  const double step = curve(7) - curve(7 - 1e-9);
  EXPECT_NEAR(jump(7, true), step, 0.3);
  EXPECT_NEAR(at(7 - 1e-9, true), curve(7 - 1e-9), 0.15);
  EXPECT_NEAR(at(7, true), curve(7), 0.15);
}

TEST_P(FieldOfOrder, JumpIsThatOfTheRawFunction) {
  double largest = 0;
  for (uint32_t c = 1; c < grid.cell_count(); ++c) {
    const double raw = jump_at(grid, field, 0, c).r;
    EXPECT_NEAR(raw, jump(interval_begin(grid, {c, 0}), false), 1e-4);
    largest = std::max(largest, std::abs(raw));
  }
  EXPECT_GT(largest, 0.5);  // the step
  EXPECT_EQ(jump_at(grid, field, 0, 0), Rgb{});
}

TEST_P(FieldOfOrder, MeanIsTheIntegral) {
  const double stretches[][2] = {{0, 20}, {1.3, 1.34}, {2, 6.5}, {6.9, 7.1}, {6.5, 19.9}, {7, 8}};
  for (const bool continuous : {false, true})
    for (const auto& [begin, end] : stretches) {
      double sum = 0;
      constexpr int kSteps = 40000;
      for (int i = 0; i < kSteps; ++i) sum += at(begin + (i + 0.5) * (end - begin) / kSteps, continuous);
      EXPECT_NEAR(mean_over(grid, field, 0, begin, end, continuous).r, sum / kSteps, 2e-4)
          << begin << " to " << end;
    }
}

TEST_P(FieldOfOrder, TheMeanOfNoTimeIsTheValue) {
  EXPECT_EQ(mean_over(grid, field, 0, 3, 3, true), value_at(grid, field, 0, 3, true));
}

TEST_P(FieldOfOrder, TimesOutsideHoldTheEnds) {
  EXPECT_EQ(at(-5, true), at(0, true));
  EXPECT_EQ(at(25, true), at(20, true));
}

// Surpluses of parents and children jump where their sum does not; what is added for continuity must cancel
// like the jumps, however long the pieces are, and must not reach farther than a cell.
TEST_P(FieldOfOrder, CorrectionsCancelLikeJumps) {
  const TimeGrid even = make_time_grid(0, 16, {}, GetParam(), 16 * GetParam());
  const auto early = [](double t) { return t < 8 ? 1.0 : 0.0; };
  const auto late = [](double t) { return t < 8 ? 0.0 : t < 10 ? 1.0 : 1.3; };
  const Field a = field_of(even, early, 1e-3f), b = field_of(even, late, 1e-3f);
  for (double t = 0.05; t < 16; t += 0.1) {
    const double sum = value_at(even, a, 0, t, true).r + value_at(even, b, 0, t, true).r;
    if (std::abs(t - 10) > 1) {
      EXPECT_NEAR(sum, t < 10 ? 1 : 1.3, 1e-5) << t;
    }
  }
}

// Beside a gap, too, where the function is zero.
TEST_P(FieldOfOrder, MeetsAGap) {
  const TimeGrid even = make_time_grid(0, 16, {}, GetParam(), 16 * GetParam());
  std::vector<bool> active(16, false);
  active[5] = active[6] = true;
  Field island;
  island.order = GetParam();
  append_row(even, samples_of(even, [](double) { return 7; }), active, 1e-3f, &island);
  const auto at = [&](double t) { return value_at(even, island, 0, t, true).r; };
  EXPECT_NEAR(at(5), at(5 - 1e-9), 1e-5);
  EXPECT_NEAR(at(7), at(7 - 1e-9), 1e-5);
  EXPECT_GT(at(6), 1);
  EXPECT_NEAR(at(3.9), 0, 1e-6);
  EXPECT_NEAR(at(8.1), 0, 1e-6);
}

// The values at nodes, of some cells, added to what is there.
TEST_P(FieldOfOrder, ValuesAtNodesAreThoseOfTheRawFunction) {
  const auto order = static_cast<uint32_t>(grid.order);
  Field rows = field;
  append_row(grid, samples_of(grid, [](double t) { return t; }), {}, 1e-3f, &rows);
  for (const auto& [first, count] : {std::pair<uint32_t, uint32_t>{0, grid.cell_count()}, {3, 1}, {17, 29}}) {
    std::vector<Rgb> values(count * order, Rgb{5, 0, 0});
    add_values(grid, rows, 0, first, count, values.data());
    for (uint32_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(values[i].r - 5, at(sample_time(grid, first * order + i), false), 1e-5) << i;
    add_values(grid, rows, 1, first, count, values.data());
    EXPECT_NEAR(values[0].r - 5,
                at(sample_time(grid, first * order), false) + sample_time(grid, first * order), 0.1);
  }
}

// Cells where a row has no piece are left as they are.
TEST(Field, GapsAddNothing) {
  const TimeGrid grid = make_time_grid(0, 16, {}, 2, 32);
  std::vector<bool> active(16, false);
  active[5] = active[6] = true;
  Field island;
  island.order = 2;
  append_row(grid, samples_of(grid, [](double) { return 7; }), active, 1e-3f, &island);
  std::vector<Rgb> values(8);
  add_values(grid, island, 0, 4, 4, values.data());
  for (size_t i = 0; i < 8; ++i) EXPECT_NEAR(values[i].r, i >= 2 && i < 6 ? 7 : 0, 1e-5) << i;
}

TEST(Field, RowsAreApart) {
  const TimeGrid grid = make_time_grid(0, 10, {}, 2, 40);
  Field field;
  field.order = 2;
  for (const double level : {1.0, 0.0, 3.0})
    append_row(grid, samples_of(grid, [&](double) { return level; }), {}, 1e-3f, &field);
  EXPECT_NEAR(value_at(grid, field, 0, 4, true).r, 1, 1e-6);
  EXPECT_NEAR(value_at(grid, field, 1, 4, true).r, 0, 1e-6);
  EXPECT_NEAR(value_at(grid, field, 2, 4, true).r, 3, 1e-6);
  EXPECT_NEAR(value_at(grid, field, 2, 4, true).g, 1.5, 1e-6);
}

TEST(Field, OfAnInstantHasItsValue) {
  const TimeGrid grid = instant_grid(3);
  Field field;
  append_row(grid, {{2, 1, 0}}, {}, 1e-3f, &field);
  EXPECT_EQ(value_at(grid, field, 0, 3, true), (Rgb{2, 1, 0}));
  EXPECT_EQ(value_at(grid, field, 0, 0, true), (Rgb{2, 1, 0}));
}

}  // namespace
}  // namespace strad
