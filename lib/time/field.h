// Functions of time, one RGB function per vertex: sparse piecewise polynomials on dyadic intervals.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "time/time_grid.h"

namespace strad {

// Row v holds the pieces of vertex v, ascending in time; where there is no piece the function is zero.
// A piece's coefficients are its values at the `order` Gauss nodes of its interval.
struct Field {
  int order = 1;
  std::vector<uint32_t> first_piece{0};  // rows + 1
  std::vector<Interval> pieces;
  std::vector<Rgb> coefficients;  // pieces * order

  // Reserves memory, which the system provides only as it is filled. Without it, growing would hold two
  // copies.
  void expect_rows(size_t rows) {
    constexpr size_t kPieces = 32;  // of a row: more than most have
    first_piece.reserve(rows + 1);
    pieces.reserve(kPieces * rows);
    coefficients.reserve(kPieces * rows * static_cast<size_t>(order));
  }
  uint32_t row_count() const { return static_cast<uint32_t>(first_piece.size() - 1); }
};

// The value at `time`, of the later piece at a boundary.
//
// With `continuous`, half of the jump between two cells of a span is added on either side, fading within the
// cell, so that both sides meet at their mean (the paper asks for continuity across interval boundaries).
// This is linear in the functions: jumps of surpluses that cancel still cancel. Boundaries of spans, where
// light may step, stay sharp. It needs the pieces of the cells before and after that of `time`.
Rgb value_at(const TimeGrid& grid, const Field& field, uint32_t row, double time, bool continuous);

// The mean over [begin, end], in closed form.
Rgb mean_over(const TimeGrid& grid, const Field& field, uint32_t row, double begin, double end,
              bool continuous);

// The jump value(cell boundary +) - value(cell boundary -) at the beginning of `cell`, before any correction.
Rgb jump_at(const TimeGrid& grid, const Field& field, uint32_t row, uint32_t cell);

// Adds the values of a row, before any correction, at the time samples of the cells first .. first + count -
// 1 to values[0 ..].
void add_values(const TimeGrid& grid, const Field& field, uint32_t row, uint32_t first, uint32_t count,
                Rgb* values);

// Appends a row from values at all time samples (sample_count of them). Dyadic halves are merged bottom-up
// while the root mean square error of the merged polynomial over its interval, in its largest channel, is at
// most `tolerance`. Pieces whose root mean square is below it are dropped. So the error of the row is about
// `tolerance`. `active`: one flag per cell; inactive cells are zero. Empty: all cells are active.
void append_row(const TimeGrid& grid, const std::vector<Rgb>& sample_values, const std::vector<bool>& active,
                float tolerance, Field* field);

}  // namespace strad
