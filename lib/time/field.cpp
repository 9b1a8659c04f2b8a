#include "time/field.h"

#include <algorithm>
#include <array>
#include <cmath>

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

struct Ends {
  Rgb begin, end;
};

// What must be added at the two ends of a piece to make the row continuous.
Ends corrections(const TimeGrid& grid, const Field& field, uint32_t row, uint32_t piece) {
  const Interval interval = field.pieces[piece];
  const Span& span = grid.spans[span_of_cell(grid, interval.cell)];
  const uint32_t after = interval.cell + interval.cell_count();
  Ends ends;
  if (interval.cell > span.first_cell) {
    const uint32_t neighbour = piece_at(field, row, interval.cell - 1);
    const float share = neighbour == kNoPiece ? 1.0f : 0.5f;
    ends.begin = share * (end_value(field, neighbour, 1) - end_value(field, piece, 0));
  }
  if (after < span.first_cell + (1u << span.log2_cells)) {
    const uint32_t neighbour = piece_at(field, row, after);
    const float share = neighbour == kNoPiece ? 1.0f : 0.5f;
    ends.end = share * (end_value(field, neighbour, 0) - end_value(field, piece, 1));
  }
  return ends;
}

double local_of(const TimeGrid& grid, Interval interval, double time) {
  const double begin = interval_begin(grid, interval), end = interval_end(grid, interval);
  return end > begin ? std::clamp((time - begin) / (end - begin), 0.0, 1.0) : 0.5;
}

}  // namespace

Rgb value_at(const TimeGrid& grid, const Field& field, uint32_t row, double time, bool continuous) {
  const uint32_t piece = piece_at(field, row, cell_at(grid, time));
  if (piece == kNoPiece) return {};
  const double s = local_of(grid, field.pieces[piece], time);
  double weights[kMaxOrder];
  lagrange_weights(field.order, s, weights);
  Rgb value = combine(field, piece, weights);
  if (continuous) {
    const Ends ends = corrections(grid, field, row, piece);
    value += static_cast<float>(1 - s) * ends.begin + static_cast<float>(s) * ends.end;
  }
  return value;
}

Rgb mean_over(const TimeGrid& grid, const Field& field, uint32_t row, double begin, double end,
              bool continuous) {
  if (!(end > begin)) return value_at(grid, field, row, begin, continuous);
  Rgb sum;
  for (uint32_t p = field.first_piece[row]; p < field.first_piece[row + 1]; ++p) {
    const Interval interval = field.pieces[p];
    const double from = std::max(begin, interval_begin(grid, interval));
    const double to = std::min(end, interval_end(grid, interval));
    if (!(to > from)) continue;
    const double s0 = local_of(grid, interval, from), s1 = local_of(grid, interval, to);
    double weights[kMaxOrder];
    lagrange_means(field.order, s0, s1, weights);
    Rgb mean = combine(field, p, weights);
    if (continuous) {
      const Ends ends = corrections(grid, field, row, p);
      const double s = 0.5 * (s0 + s1);
      mean += static_cast<float>(1 - s) * ends.begin + static_cast<float>(s) * ends.end;
    }
    sum += static_cast<float>((to - from) / (end - begin)) * mean;
  }
  return sum;
}

Rgb jump_at(const TimeGrid&, const Field& field, uint32_t row, uint32_t cell) {
  if (cell == 0) return {};
  const uint32_t before = piece_at(field, row, cell - 1), after = piece_at(field, row, cell);
  if (before == after) return {};
  return end_value(field, after, 0) - end_value(field, before, 1);
}

}  // namespace strad
