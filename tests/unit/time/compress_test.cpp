// Functions of time as few pieces: what is exact, how far off the rest may be, what must not get lost.
#include <gtest/gtest.h>

#include "base/rng.h"
#include "field_samples.h"

namespace strad {
namespace {

class Compress : public testing::TestWithParam<int> {
 protected:
  const int order = GetParam();
};
INSTANTIATE_TEST_SUITE_P(AllOrders, Compress, testing::Values(1, 2, 3));

// Root of the mean square of the red channel's error over the nodes of [first, first + count) cells.
double rms_error(const TimeGrid& grid, const Field& field, const std::vector<Rgb>& values) {
  static constexpr double kWeights[3][3] = {{1, 0, 0}, {0.5, 0.5, 0}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
  double sum = 0;
  for (uint32_t n = 0; n < grid.sample_count(); ++n) {
    const double d = value_at(grid, field, 0, sample_time(grid, n), false).r - values[n].r;
    sum += kWeights[grid.order - 1][n % static_cast<uint32_t>(grid.order)] * d * d;
  }
  return std::sqrt(sum / grid.cell_count());
}

TEST_P(Compress, APolynomialIsOnePieceAndExact) {
  const TimeGrid grid = make_time_grid(0, 24, {}, order, 400);
  const TimeFunction f = [&](double t) {
    return order == 1 ? 3 : order == 2 ? 3 - 0.2 * t : 3 - 0.2 * t + 0.01 * t * t;
  };
  const Field field = field_of(grid, f, 1e-4f);
  ASSERT_EQ(field.pieces.size(), 1u);
  EXPECT_EQ(field.pieces[0], (Interval{0, grid.spans[0].log2_cells}));
  for (double t = 0; t <= 24; t += 0.37) EXPECT_NEAR(value_at(grid, field, 0, t, false).r, f(t), 2e-5);
}

TEST_P(Compress, OneDegreeMoreNeedsMorePieces) {
  const TimeGrid grid = make_time_grid(0, 24, {}, order, 400);
  const Field field = field_of(
      grid, [&](double t) { return std::pow(t / 12 - 1, order); }, 1e-3f);
  EXPECT_GT(field.pieces.size(), 1u);
}

TEST_P(Compress, ErrorIsBelowTheTolerance) {
  const TimeGrid grid = make_time_grid(0, 24, {7.5}, order, 600);
  const TimeFunction functions[] = {
      [](double t) { return std::sin(t) + (t >= 7.5 ? 2 : 0); },
      [](double t) { return std::exp(-20 * (t - 11) * (t - 11)); },
      [](double t) { return t > 13 && t < 16.3 ? 1.0 : 0.0; },
      [](double t) { return unit_from(hash_of(static_cast<uint64_t>(t * 1e6))) - 0.5; },
  };
  for (const TimeFunction& f : functions) {
    size_t last = ~size_t{0};
    for (const float tolerance : {1e-4f, 1e-3f, 1e-2f, 1e-1f}) {
      const Field field = field_of(grid, f, tolerance);
      EXPECT_LE(rms_error(grid, field, samples_of(grid, f)), 1.01 * tolerance + 1e-6);
      EXPECT_LE(field.pieces.size(), last);  // never more pieces for less
      last = field.pieces.size();
    }
  }
}

// An event of one cell in 256. Its root mean square is far below the tolerance over the animation, but not
// over its own cell.
TEST_P(Compress, AShortEventSurvives) {
  const TimeGrid grid = make_time_grid(0, 256, {}, order, 256 * order);
  ASSERT_EQ(grid.cell_count(), 256u);
  const TimeFunction f = [](double t) { return t > 100 && t < 101 ? 1.0 : 0.0; };
  const Field field = field_of(grid, f, 0.2f);
  ASSERT_GT(1.0 / 16, 0.02);  // rms over the animation is 1/16
  EXPECT_NEAR(value_at(grid, field, 0, 100.5, false).r, 1, 1e-5);
  EXPECT_NEAR(mean_over(grid, field, 0, 0, 256, false).r, 1.0 / 256, 1e-6);
}

TEST_P(Compress, ZeroTakesNoRoom) {
  const TimeGrid grid = make_time_grid(0, 24, {5}, order, 200);
  Field field = field_of(
      grid, [](double) { return 0.5e-3; }, 1e-3f);
  EXPECT_TRUE(field.pieces.empty());
  EXPECT_EQ(field.row_count(), 1u);
  append_row(grid, samples_of(grid, [](double) { return 1; }), {}, 1e-3f, &field);
  EXPECT_EQ(field.row_count(), 2u);
  EXPECT_EQ(field.pieces.size(), 2u);  // one per span
  EXPECT_NEAR(value_at(grid, field, 1, 3, true).r, 1, 1e-6);
  EXPECT_EQ(value_at(grid, field, 0, 3, true), Rgb{});
}

TEST_P(Compress, InactiveCellsAreZero) {
  const TimeGrid grid = make_time_grid(0, 16, {}, order, 16 * order);
  ASSERT_EQ(grid.cell_count(), 16u);
  std::vector<bool> active(16, false);
  active[5] = active[6] = true;
  Field field;
  field.order = order;
  append_row(grid, samples_of(grid, [](double) { return 7; }), active, 1e-3f, &field);
  EXPECT_EQ(value_at(grid, field, 0, 4.9, false), Rgb{});
  EXPECT_NEAR(value_at(grid, field, 0, 5.1, false).r, 7, 1e-5);
  EXPECT_NEAR(value_at(grid, field, 0, 6.9, false).r, 7, 1e-5);
  EXPECT_EQ(value_at(grid, field, 0, 7.1, false), Rgb{});
}

// The tolerance is for the channel that is farthest off, whichever it is.
TEST_P(Compress, EveryChannelCounts) {
  const TimeGrid grid = make_time_grid(0, 64, {}, order, 64 * order);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<Rgb> values(grid.sample_count());
    for (uint32_t n = 0; n < grid.sample_count(); ++n)
      values[n][channel] = static_cast<float>(std::sin(sample_time(grid, n)));
    Field field;
    field.order = order;
    append_row(grid, values, {}, 1e-3f, &field);
    double worst = 0;
    for (uint32_t n = 0; n < grid.sample_count(); ++n)
      worst = std::max<double>(
          worst,
          std::abs(value_at(grid, field, 0, sample_time(grid, n), false)[channel] - values[n][channel]));
    EXPECT_LT(worst, 0.01);
    EXPECT_GT(field.pieces.size(), 4u);
  }
}

}  // namespace
}  // namespace strad
