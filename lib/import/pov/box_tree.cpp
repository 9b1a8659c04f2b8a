#include "import/pov/box_tree.h"

#include <algorithm>
#include <numeric>

namespace strad {

BoxTree::BoxTree(const std::vector<Box>& boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!boxes.empty()) build(boxes, 0, static_cast<uint32_t>(boxes.size()));
}

// Halves along the longest side, until few are left.
void BoxTree::build(const std::vector<Box>& boxes, uint32_t begin, uint32_t end) {
  constexpr uint32_t kFew = 4;
  const size_t at = nodes_.size();
  nodes_.emplace_back();
  Box box;
  for (uint32_t i = begin; i < end; ++i) box.add(boxes[order_[i]]);
  nodes_[at] = {box, begin, end, 0};
  if (end - begin <= kFew) return;
  const Vec3 size = box.upper - box.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto middle_of = [&](uint32_t i) { return boxes[i].lower[axis] + boxes[i].upper[axis]; };
  const uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](uint32_t a, uint32_t b) {
                     const double x = middle_of(a), y = middle_of(b);
                     return x != y ? x < y : a < b;
                   });
  build(boxes, begin, middle);
  nodes_[at].second = static_cast<uint32_t>(nodes_.size());
  build(boxes, middle, end);
}

}  // namespace strad
