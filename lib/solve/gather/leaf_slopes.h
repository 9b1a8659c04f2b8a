// How radiance changes across leaves: linear functions in space, relative to the mean of each leaf.
//
// A leaf that has the same radiance everywhere sends too much light down the slope of its light. Where light
// gets to a place only from leaf to leaf, as along a corridor, this happens at each of them, and adds up.
// Slopes take out the first order of the error (as linear elements do: Zatz 1993).
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "solve/links/nodes.h"
#include "time/function_block.h"

namespace strad {

class LeafSlopes {
 public:
  LeafSlopes() = default;  // no slopes
  // From the radiance of leaves, by its mean over time: a leaf goes on as those around it do. `noise`: [row
  // of `radiance`], standard error of its mean over time, relative; what does not stand out from it is left
  // out.
  LeafSlopes(const NodeTree& tree, const FunctionBlock& radiance, const std::vector<float>& noise);

  // What the mean radiance of a leaf is multiplied by at a point of it, in its own parametric coordinates
  // (NodeTree::leaf_at). Above 0; its mean over the leaf is 1.
  float factor(uint32_t leaf, Vec2 uv) const {
    if (leaf >= slopes_.size()) return 1;
    const Slope& s = slopes_[leaf];
    return 1 + s.u * (static_cast<float>(uv.x) - s.centre) + s.v * (static_cast<float>(uv.y) - s.centre);
  }

 private:
  struct Slope {
    float u = 0, v = 0;   // change from 0 to 1 of the coordinate, relative to the mean
    float centre = 0.5f;  // of the node, in both coordinates
  };
  std::vector<Slope> slopes_;  // [node]
};

}  // namespace strad
