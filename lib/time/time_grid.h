// The dyadic structure of time that all functions of time share.
//
// The interval of the animation is cut at its steps (where something jumps) into spans, so that real events
// stay sharp; a span is cut into 2^n equal cells, the finest pieces that a function may have; a cell has
// `order` Gauss-Legendre nodes, the time samples at which the solver works. A dyadic interval is 2^l cells of
// one span, aligned.
#pragma once

#include <cstdint>
#include <vector>

namespace strad {

constexpr int kMaxOrder = 3;

struct Span {
  double begin = 0, end = 0;  // s
  uint32_t first_cell = 0;
  uint32_t log2_cells = 0;
};

struct TimeGrid {
  int order = 1;  // 1: constant (Haar, M1), 2: linear (M2), 3: quadratic (M3)
  std::vector<Span> spans;

  uint32_t cell_count() const;
  uint32_t sample_count() const { return cell_count() * static_cast<uint32_t>(order); }
};

// A dyadic interval: cells [cell, cell + 2^log2_cells) of one span.
struct Interval {
  uint32_t cell = 0;
  uint32_t log2_cells = 0;
  uint32_t cell_count() const { return 1u << log2_cells; }
  bool operator==(const Interval&) const = default;
};

// Spans between `steps` (ascending, strictly inside), with about `samples` time samples in all, at least one
// cell per span.
TimeGrid make_time_grid(double start, double end, const std::vector<double>& steps, int order, int samples);

// One instant: a single cell with one time sample, `time`.
TimeGrid instant_grid(double time);
bool is_instant(const TimeGrid& grid);

uint32_t span_of_cell(const TimeGrid& grid, uint32_t cell);
// The time, s, of a place within a span. `cell_coordinate` counts cells, with fractions: it is
// span.first_cell at the beginning of the span.
double cell_time(const TimeGrid& grid, double cell_coordinate, uint32_t span);
double sample_time(const TimeGrid& grid, uint32_t time_sample);
double interval_begin(const TimeGrid& grid, Interval interval);
double interval_end(const TimeGrid& grid, Interval interval);

// The cell that holds `time`, clamped into the grid; at a boundary the later one (the value after a step
// holds).
uint32_t cell_at(const TimeGrid& grid, double time);

// Gauss-Legendre nodes of [0, 1] for `order` 1..3, ascending.
const double* gauss_nodes(int order);
// Values at s of the Lagrange polynomials of those nodes.
void lagrange_weights(int order, double s, double* weights);
// Integrals from s0 to s1 of the Lagrange polynomials, divided by (s1 - s0).
void lagrange_means(int order, double s0, double s1, double* weights);

}  // namespace strad
