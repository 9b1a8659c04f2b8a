#include "time/field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace strad {
namespace {

// Piece of `row` that covers `cell`, or kNoPiece.
constexpr uint32_t kNoPiece = 0xffffffffu;

uint32_t piece_at(const Field& field, uint32_t row, uint32_t cell) {
  const auto first = field.pieces.begin() + field.first_piece[row];
  const auto last = field.pieces.begin() + field.first_piece[row + 1];
  auto it =
      std::upper_bound(first, last, cell, [](uint32_t c, const Interval& piece) { return c < piece.cell; });
  if (it == first) return kNoPiece;
  --it;
  if (cell >= it->cell + it->cell_count()) return kNoPiece;
  return static_cast<uint32_t>(it - field.pieces.begin());
}

Rgb combine(const Field& field, uint32_t piece, const double* weights) {
  Rgb sum;
  for (int k = 0; k < field.order; ++k)
    sum += static_cast<float>(weights[k]) * field.coefficients[static_cast<size_t>(piece) * field.order + k];
  return sum;
}

// Value at the beginning (s = 0) or end (s = 1) of a piece.
Rgb end_value(const Field& field, uint32_t piece, double s) {
  if (piece == kNoPiece) return {};
  double weights[kMaxOrder];
  lagrange_weights(field.order, s, weights);
  return combine(field, piece, weights);
}

// Raw value of a row at the beginning (s = 0) or end (s = 1) of a cell.
Rgb cell_end_value(const Field& field, uint32_t row, uint32_t cell, double s) {
  const uint32_t piece = piece_at(field, row, cell);
  if (piece == kNoPiece) return {};
  const Interval interval = field.pieces[piece];
  double weights[kMaxOrder];
  lagrange_weights(field.order, (cell + s - interval.cell) / interval.cell_count(), weights);
  return combine(field, piece, weights);
}

// Half of the jumps at the two ends of a cell. Added there, and fading within the cell, they make the row
// continuous. They do not depend on the length of pieces, so the correction is linear: a sum of corrected
// rows is the corrected sum, and jumps of surpluses that cancel still cancel.
struct Ends {
  Rgb begin, end;
};
Ends corrections(const TimeGrid& grid, const Field& field, uint32_t row, uint32_t cell) {
  const Span& span = grid.spans[span_of_cell(grid, cell)];
  const auto jump = [&](uint32_t c) -> Rgb {  // at the beginning of cell c
    const uint32_t before = piece_at(field, row, c - 1), after = piece_at(field, row, c);
    if (before == after) return {};
    return cell_end_value(field, row, c, 0) - cell_end_value(field, row, c - 1, 1);
  };
  Ends ends;
  if (cell > span.first_cell) ends.begin = -0.5f * jump(cell);
  if (cell + 1 < span.first_cell + (1u << span.log2_cells)) ends.end = 0.5f * jump(cell + 1);
  return ends;
}

double fade(double s) { return (1 - s) * (1 - s); }
double fade_integral(double s) { return (1 - (1 - s) * (1 - s) * (1 - s)) / 3; }

double local_of(const TimeGrid& grid, Interval interval, double time) {
  const double begin = interval_begin(grid, interval), end = interval_end(grid, interval);
  return end > begin ? std::clamp((time - begin) / (end - begin), 0.0, 1.0) : 0.5;
}

}  // namespace

void add_values(const TimeGrid& grid, const Field& field, uint32_t row, uint32_t first, uint32_t count,
                Rgb* values) {
  const auto order = static_cast<uint32_t>(grid.order);
  for (uint32_t piece = field.first_piece[row]; piece < field.first_piece[row + 1]; ++piece) {
    const Interval interval = field.pieces[piece];
    if (interval.cell >= first + count) break;
    const uint32_t begin = std::max(first, interval.cell);
    const uint32_t end = std::min(first + count, interval.cell + interval.cell_count());
    for (uint32_t cell = begin; cell < end; ++cell)
      for (uint32_t k = 0; k < order; ++k) {
        double weights[kMaxOrder];
        lagrange_weights(
            grid.order, (cell - interval.cell + gauss_nodes(grid.order)[k]) / interval.cell_count(), weights);
        values[(cell - first) * order + k] += combine(field, piece, weights);
      }
  }
}

Rgb value_at(const TimeGrid& grid, const Field& field, uint32_t row, double time, bool continuous) {
  const uint32_t cell = cell_at(grid, time);
  const uint32_t piece = piece_at(field, row, cell);
  Rgb value;
  if (piece != kNoPiece) {
    double weights[kMaxOrder];
    lagrange_weights(field.order, local_of(grid, field.pieces[piece], time), weights);
    value = combine(field, piece, weights);
  }
  if (continuous) {
    const Ends ends = corrections(grid, field, row, cell);
    const double s = local_of(grid, {cell, 0}, time);
    value += static_cast<float>(fade(s)) * ends.begin + static_cast<float>(fade(1 - s)) * ends.end;
  }
  return value;
}

Rgb mean_over(const TimeGrid& grid, const Field& field, uint32_t row, double begin, double end,
              bool continuous) {
  if (!(end > begin)) return value_at(grid, field, row, begin, continuous);
  Rgb sum;
  const auto add = [&](Interval interval, auto mean_of) {
    const double from = std::max(begin, interval_begin(grid, interval));
    const double to = std::min(end, interval_end(grid, interval));
    if (!(to > from)) return;
    const double s0 = local_of(grid, interval, from), s1 = local_of(grid, interval, to);
    sum += static_cast<float>((to - from) / (end - begin)) * mean_of(s0, s1);
  };
  for (uint32_t p = field.first_piece[row]; p < field.first_piece[row + 1]; ++p)
    add(field.pieces[p], [&](double s0, double s1) {
      double weights[kMaxOrder];
      lagrange_means(field.order, s0, s1, weights);
      return combine(field, p, weights);
    });
  if (!continuous) return sum;
  for (uint32_t cell = cell_at(grid, begin); cell <= cell_at(grid, end); ++cell)
    add({cell, 0}, [&](double s0, double s1) {
      const Ends ends = corrections(grid, field, row, cell);
      const double of_begin = (fade_integral(s1) - fade_integral(s0)) / (s1 - s0);
      const double of_end = (fade_integral(1 - s0) - fade_integral(1 - s1)) / (s1 - s0);
      return static_cast<float>(of_begin) * ends.begin + static_cast<float>(of_end) * ends.end;
    });
  return sum;
}

Rgb jump_at(const TimeGrid&, const Field& field, uint32_t row, uint32_t cell) {
  if (cell == 0) return {};
  const uint32_t before = piece_at(field, row, cell - 1), after = piece_at(field, row, cell);
  if (before == after) return {};
  return end_value(field, after, 0) - end_value(field, before, 1);
}

}  // namespace strad
