#include "time/time_grid.h"

#include <algorithm>
#include <cmath>

namespace strad {

uint32_t TimeGrid::cell_count() const {
  return spans.empty() ? 0 : spans.back().first_cell + (1u << spans.back().log2_cells);
}

TimeGrid make_time_grid(double start, double end, const std::vector<double>& steps, int order, int samples) {
  if (!(end > start)) return instant_grid(start);
  TimeGrid grid;
  grid.order = order;
  const double cells = std::max(1.0, static_cast<double>(samples) / order);
  double begin = start;
  uint32_t first_cell = 0;
  for (size_t i = 0; i <= steps.size(); ++i) {
    const double stop = i < steps.size() ? steps[i] : end;
    const double share = cells * (stop - begin) / (end - start);
    const auto log2_cells = static_cast<uint32_t>(std::clamp(std::lround(std::log2(share)), 0L, 20L));
    grid.spans.push_back({begin, stop, first_cell, log2_cells});
    first_cell += 1u << log2_cells;
    begin = stop;
  }
  return grid;
}

TimeGrid instant_grid(double time) {
  TimeGrid grid;
  grid.spans.push_back({time, time, 0, 0});
  return grid;
}

bool is_instant(const TimeGrid& grid) {
  return grid.sample_count() == 1 && !(grid.spans[0].end > grid.spans[0].begin);
}

uint32_t span_of_cell(const TimeGrid& grid, uint32_t cell) {
  uint32_t span = 0;
  while (span + 1 < grid.spans.size() && grid.spans[span + 1].first_cell <= cell) ++span;
  return span;
}

double cell_time(const TimeGrid& grid, double cell_coordinate, uint32_t span) {
  const Span& s = grid.spans[span];
  const double fraction = (cell_coordinate - s.first_cell) / static_cast<double>(1u << s.log2_cells);
  return s.begin + fraction * (s.end - s.begin);
}

double sample_time(const TimeGrid& grid, uint32_t time_sample) {
  const uint32_t cell = time_sample / static_cast<uint32_t>(grid.order);
  const int k = static_cast<int>(time_sample % static_cast<uint32_t>(grid.order));
  return cell_time(grid, cell + gauss_nodes(grid.order)[k], span_of_cell(grid, cell));
}

double interval_begin(const TimeGrid& grid, Interval interval) {
  return cell_time(grid, interval.cell, span_of_cell(grid, interval.cell));
}

double interval_end(const TimeGrid& grid, Interval interval) {
  return cell_time(grid, interval.cell + interval.cell_count(), span_of_cell(grid, interval.cell));
}

uint32_t cell_at(const TimeGrid& grid, double time) {
  uint32_t span = 0;
  while (span + 1 < grid.spans.size() && grid.spans[span + 1].begin <= time) ++span;
  const Span& s = grid.spans[span];
  const double length = s.end - s.begin;
  const uint32_t cells = 1u << s.log2_cells;
  if (!(length > 0) || !(time > s.begin)) return s.first_cell;
  const double cell = std::floor((time - s.begin) / length * cells);
  return s.first_cell + static_cast<uint32_t>(std::min(cell, cells - 1.0));
}

const double* gauss_nodes(int order) {
  // Gauss-Legendre on [0, 1] (Abramowitz & Stegun 1964, table 25.4): 1/2; (1 -+ 1/sqrt 3) / 2; (1 -+
  // sqrt(3/5)) / 2 and 1/2.
  static constexpr double kNodes[3][3] = {{0.5, 0, 0},
                                          {0.21132486540518712, 0.78867513459481288, 0},
                                          {0.11270166537925831, 0.5, 0.88729833462074169}};
  return kNodes[order - 1];
}

void lagrange_weights(int order, double s, double* weights) {
  const double* x = gauss_nodes(order);
  for (int i = 0; i < order; ++i) {
    weights[i] = 1;
    for (int j = 0; j < order; ++j)
      if (j != i) weights[i] *= (s - x[j]) / (x[i] - x[j]);
  }
}

void lagrange_means(int order, double s0, double s1, double* weights) {
  // Two Gauss nodes integrate the polynomials, of degree 2 at most, exactly.
  for (int i = 0; i < order; ++i) weights[i] = 0;
  for (int g = 0; g < 2; ++g) {
    double at[kMaxOrder];
    lagrange_weights(order, s0 + gauss_nodes(2)[g] * (s1 - s0), at);
    for (int i = 0; i < order; ++i) weights[i] += 0.5 * at[i];
  }
}

}  // namespace strad
