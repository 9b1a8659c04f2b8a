// When to look at what moves: at few instants, and at more where what is seen changes.
//
// Looks are taken at the ends of cells. What is seen in between is blended linearly from the looks before and
// after, so looks are needed only where that would be wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "time/time_grid.h"

namespace strad {

// What a ray has met, and its radiance there relative to the mean of the leaf.
struct Seen {
  uint32_t leaf;
  float weight;
  bool operator==(const Seen&) const = default;
};

// What rays met at an end of a cell.
struct Look {
  uint32_t span = 0;
  uint32_t cell = 0;       // it begins then, or ends: cells of the span are numbered from 0 to 2^n
  std::vector<Seen> seen;  // [ray]
};

struct Looker {
  std::function<std::vector<Seen>(uint32_t span, uint32_t cell)> see;
  // Does the look in the middle differ from the blend of the others?
  std::function<bool(const Look& before, const Look& middle, const Look& after)> differs;
  // May something happen between two looks that neither of them shows? The cells are those of the grid.
  std::function<bool(uint32_t first_cell, uint32_t end_cell)> may_happen;
};

// In order of time, at the ends of each span, in its middle, and from there on where it is asked for. One
// look for a grid of one instant.
std::vector<Look> looks_over(const TimeGrid& grid, const Looker& looker);

struct SampleRange {
  size_t first = 0, end = 0;  // time samples
};

// How looks are blended at the time samples.
class LookBlends {
 public:
  explicit LookBlends(const TimeGrid& grid);  // one look, which holds at all times
  LookBlends(const TimeGrid& grid, const std::vector<Look>& looks);

  // `scale` times a number that has these values at the looks, at all time samples. Outside of the range that
  // comes back it is 0, and `weights` is not set.
  SampleRange weights(const float* at_looks, float scale, float* weights) const;

 private:
  // Time samples between a look and the next.
  struct Part {
    uint32_t look, next;
    SampleRange samples;
  };
  std::vector<Part> parts_;
  std::vector<float> of_next_;  // [time sample], share of the look after it, 0 to 1
};

}  // namespace strad
