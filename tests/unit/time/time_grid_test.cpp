// The dyadic structure of time.
#include "time/time_grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace strad {
namespace {

TEST(TimeGrid, SpansBeginAndEndAtSteps) {
  const TimeGrid grid = make_time_grid(1, 11, {3, 3.5}, 2, 256);
  ASSERT_EQ(grid.spans.size(), 3u);
  EXPECT_EQ(grid.spans[0].begin, 1);
  EXPECT_EQ(grid.spans[0].end, 3);
  EXPECT_EQ(grid.spans[1].begin, 3);
  EXPECT_EQ(grid.spans[1].end, 3.5);
  EXPECT_EQ(grid.spans[2].end, 11);
  uint32_t next = 0;
  for (const Span& span : grid.spans) {
    EXPECT_EQ(span.first_cell, next);
    next += 1u << span.log2_cells;
  }
  EXPECT_EQ(grid.cell_count(), next);
  EXPECT_EQ(grid.sample_count(), 2 * next);
}

TEST(TimeGrid, HasAboutAsManyNodesAsAskedFor) {
  for (const int order : {1, 2, 3})
    for (const int samples : {24, 100, 375, 1000}) {
      const double nodes = make_time_grid(0, 24, {}, order, samples).sample_count();
      EXPECT_GE(nodes, samples / 1.5);
      EXPECT_LE(nodes, samples * 1.5);
    }
  // A short span has a cell, too.
  EXPECT_EQ(make_time_grid(0, 10, {1e-6}, 3, 24).spans[0].log2_cells, 0u);
}

TEST(TimeGrid, NodesAscendWithinTheirCells) {
  for (const int order : {1, 2, 3}) {
    const TimeGrid grid = make_time_grid(-2, 9, {1, 4.25}, order, 100);
    double last = -2;
    for (uint32_t n = 0; n < grid.sample_count(); ++n) {
      const double t = sample_time(grid, n);
      EXPECT_GT(t, last);
      EXPECT_EQ(cell_at(grid, t), n / static_cast<uint32_t>(order));
      last = t;
    }
    EXPECT_LT(last, 9);
  }
}

TEST(TimeGrid, ABoundaryBelongsToTheLaterCell) {
  const TimeGrid grid = make_time_grid(0, 8, {2}, 1, 8);
  for (uint32_t c = 0; c < grid.cell_count(); ++c) EXPECT_EQ(cell_at(grid, interval_begin(grid, {c, 0})), c);
  EXPECT_EQ(cell_at(grid, 2), grid.spans[1].first_cell);
  EXPECT_EQ(cell_at(grid, std::nextafter(2.0, 0.0)), grid.spans[1].first_cell - 1);
}

TEST(TimeGrid, TimesOutsideAreClamped) {
  const TimeGrid grid = make_time_grid(0, 8, {2}, 1, 8);
  EXPECT_EQ(cell_at(grid, -5), 0u);
  EXPECT_EQ(cell_at(grid, 8), grid.cell_count() - 1);
  EXPECT_EQ(cell_at(grid, 1e9), grid.cell_count() - 1);
}

TEST(TimeGrid, IntervalsCoverTheirCells) {
  const TimeGrid grid = make_time_grid(0, 6, {2}, 3, 60);
  for (uint32_t s = 0; s < 2; ++s) {
    const Span& span = grid.spans[s];
    EXPECT_DOUBLE_EQ(interval_begin(grid, {span.first_cell, span.log2_cells}), span.begin);
    EXPECT_DOUBLE_EQ(interval_end(grid, {span.first_cell, span.log2_cells}), span.end);
    for (uint32_t c = span.first_cell; c + 1 < span.first_cell + (1u << span.log2_cells); ++c)
      EXPECT_DOUBLE_EQ(interval_end(grid, {c, 0}), interval_begin(grid, {c + 1, 0}));
  }
}

TEST(TimeGrid, AnInstantIsASingleNode) {
  for (const TimeGrid& grid : {instant_grid(7.5), make_time_grid(7.5, 7.5, {}, 3, 100)}) {
    EXPECT_EQ(grid.sample_count(), 1u);
    EXPECT_EQ(sample_time(grid, 0), 7.5);
    EXPECT_EQ(cell_at(grid, 7.5), 0u);
  }
}

// k nodes integrate polynomials of degree 2 k - 1 exactly; the weights are the means of the Lagrange
// polynomials.
TEST(GaussNodes, IntegrateExactly) {
  for (const int order : {1, 2, 3}) {
    double weights[kMaxOrder];
    lagrange_means(order, 0, 1, weights);
    for (int degree = 0; degree < 2 * order; ++degree) {
      double sum = 0;
      for (int k = 0; k < order; ++k) sum += weights[k] * std::pow(gauss_nodes(order)[k], degree);
      EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14);
    }
    double sum = 0;  // and not one degree more
    for (int k = 0; k < order; ++k) sum += weights[k] * std::pow(gauss_nodes(order)[k], 2 * order);
    EXPECT_GT(std::abs(sum - 1.0 / (2 * order + 1)), 1e-4);
  }
}

TEST(Lagrange, ReproducesPolynomials) {
  for (const int order : {1, 2, 3})
    for (int degree = 0; degree < order; ++degree)
      for (const double s : {-0.5, 0.0, 0.3, 1.0}) {
        double weights[kMaxOrder], sum = 0;
        lagrange_weights(order, s, weights);
        for (int k = 0; k < order; ++k) sum += weights[k] * std::pow(gauss_nodes(order)[k], degree);
        EXPECT_NEAR(sum, std::pow(s, degree), 1e-13);
      }
}

TEST(Lagrange, MeansAreThoseOfThePolynomials) {
  for (const int order : {1, 2, 3})
    for (int degree = 0; degree < order; ++degree) {
      const double s0 = 0.2, s1 = 0.9;
      double weights[kMaxOrder], sum = 0;
      lagrange_means(order, s0, s1, weights);
      for (int k = 0; k < order; ++k) sum += weights[k] * std::pow(gauss_nodes(order)[k], degree);
      const double mean = (std::pow(s1, degree + 1) - std::pow(s0, degree + 1)) / (degree + 1) / (s1 - s0);
      EXPECT_NEAR(sum, mean, 1e-13);
    }
}

}  // namespace
}  // namespace strad
