// A tree of boxes: which of many things are near, without a look at each.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace strad {

class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);

  // Calls `visit(index)` for each box that `reaches(box)` is true of, with perhaps a few more; and stops when
  // `visit` returns true.
  template <typename Reaches, typename Visit>
  void visit(Reaches reaches, Visit visit) const {
    std::vector<uint32_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!reaches(node.box)) continue;
      if (node.second) {
        open.push_back(node.second);
        open.push_back(static_cast<uint32_t>(&node - nodes_.data()) + 1);
        continue;
      }
      for (uint32_t i = node.begin; i < node.end; ++i)
        if (visit(order_[i])) return;
    }
  }

 private:
  struct Node {
    Box box;
    uint32_t begin = 0, end = 0;  // of order_
    uint32_t second = 0;          // the first child follows its parent; 0: a leaf
  };
  void build(const std::vector<Box>& boxes, uint32_t begin, uint32_t end);

  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;
};

}  // namespace strad
