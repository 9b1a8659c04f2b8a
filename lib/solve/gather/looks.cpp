#include "solve/gather/looks.h"

#include <algorithm>

namespace strad {
namespace {

// A span is looked at in so many parts at least.
constexpr uint32_t kLeastParts = 4;

class Search {
 public:
  Search(const TimeGrid& grid, const Looker& looker, std::vector<Look>* looks)
      : grid_(grid), looker_(looker), looks_(*looks) {}

  void over(uint32_t span) {
    const Span& s = grid_.spans[span];
    span_ = span;
    first_cell_ = s.first_cell;
    largest_part_ = (1u << s.log2_cells) / kLeastParts;
    const Look begin = look(0), end = look(1u << s.log2_cells);
    looks_.push_back(begin);
    between(begin, end, false);
    looks_.push_back(end);
  }

 private:
  Look look(uint32_t cell) const { return {span_, cell, looker_.see(span_, cell)}; }

  // Appends the looks that are needed between two.
  void between(const Look& before, const Look& after, bool changes) {
    const uint32_t cells = after.cell - before.cell;
    if (cells <= 1) return;
    if (cells <= largest_part_ && !changes &&
        !looker_.may_happen(first_cell_ + before.cell, first_cell_ + after.cell))
      return;
    const Look middle = look(before.cell + cells / 2);
    const bool again = looker_.differs(before, middle, after);
    between(before, middle, again);
    looks_.push_back(middle);
    between(middle, after, again);
  }

  const TimeGrid& grid_;
  const Looker& looker_;
  std::vector<Look>& looks_;
  uint32_t span_ = 0, first_cell_ = 0, largest_part_ = 0;
};

}  // namespace

std::vector<Look> looks_over(const TimeGrid& grid, const Looker& looker) {
  std::vector<Look> looks;
  if (is_instant(grid)) {
    looks.push_back({0, 0, looker.see(0, 0)});
    return looks;
  }
  Search search(grid, looker, &looks);
  for (uint32_t span = 0; span < grid.spans.size(); ++span) search.over(span);
  return looks;
}

LookBlends::LookBlends(const TimeGrid& grid)
    : parts_{{0, 0, {0, grid.sample_count()}}}, of_next_(grid.sample_count(), 0.0f) {}

LookBlends::LookBlends(const TimeGrid& grid, const std::vector<Look>& looks) : LookBlends(grid) {
  if (looks.size() == 1) return;
  parts_ = {};
  const auto order = static_cast<size_t>(grid.order);
  size_t first = 0;
  for (uint32_t i = 0; i + 1 < looks.size(); ++i) {
    if (looks[i].span != looks[i + 1].span) continue;
    const size_t cells = looks[i + 1].cell - looks[i].cell;
    parts_.push_back({i, i + 1, {first, first + cells * order}});
    for (size_t d = 0; d < cells * order; ++d)
      of_next_[first + d] = static_cast<float>(
          (static_cast<double>(d / order) + gauss_nodes(grid.order)[d % order]) / static_cast<double>(cells));
    first += cells * order;
  }
}

SampleRange LookBlends::weights(const float* at_looks, float scale, float* weights) const {
  SampleRange range;
  for (const Part& part : parts_) {
    const float at = scale * at_looks[part.look], change = scale * at_looks[part.next] - at;
    if (at == 0 && change == 0) {
      if (range.end > 0) std::fill(weights + part.samples.first, weights + part.samples.end, 0.0f);
      continue;
    }
    if (range.end == 0) range.first = part.samples.first;
    range.end = part.samples.end;
    for (size_t i = part.samples.first; i < part.samples.end; ++i) weights[i] = at + of_next_[i] * change;
  }
  return range;
}

}  // namespace strad
