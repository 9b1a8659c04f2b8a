// Samples at the corners of pixels, which neighbouring pixels share, and what follows from them for a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/shading.h"

namespace strad {

struct TileRect {
  uint32_t left, top, right, bottom;  // pixels, right and bottom beyond the last
};

// The points on emitter groups to which a corner sends `count` shadow rays. Those of any block of 2^k x 2^k
// corners at a multiple of 2^k, up to 32 x 32, are one stretch of a sequence, in an order of blocks within
// blocks that is shuffled (Ahmed & Wonka 2020): neighbours' errors differ as much as they can, and most of
// them cancel in a mean over a few corners.
ShadowPoints corner_points(int x, int y, uint32_t count);

// Corner (x, y) is the upper left one of pixel (x, y).
class Corners {
 public:
  // Of all pixels of `rect` and as far around them as their shadows ask for, at the first instant.
  Corners(const FrameView& view, TileRect rect);

  const Sample& sample(int x, int y) const { return corners_[index(x, y)].sample; }
  const GroupShare* shares(int x, int y) const { return shares_.data() + index(x, y) * groups_; }

  // Of pixel (x, y): do its corners see one smooth surface under the same spots?
  bool surround_one_surface(int x, int y) const;
  // Does a shadow of an emitter group begin and end within it?
  bool shadow_edge(int x, int y) const;
  // What emitter groups bring to it, the mean of its corners.
  Rgb emitted_light(int x, int y) const;

 private:
  struct Corner {
    Sample sample;
    bool even = true;  // each emitter group is free, or each ray to it is blocked
  };

  size_t index(int x, int y) const {
    return static_cast<size_t>(y - top_) * columns_ + static_cast<size_t>(x - left_);
  }
  GroupShare* shares(int x, int y) { return shares_.data() + index(x, y) * groups_; }
  void take_samples();
  void refine_shadows();
  bool neighbours_agree(int x, int y, size_t light) const;
  bool all_even_around(int x, int y) const;

  const FrameView& view_;
  const size_t groups_;
  int left_, top_, right_, bottom_;  // right and bottom beyond the last
  size_t columns_;
  std::vector<Corner> corners_;
  std::vector<GroupShare> shares_;  // groups_ per corner
};

}  // namespace strad
