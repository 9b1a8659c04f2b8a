// Samples at the corners of pixels, which neighbouring pixels share.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/penumbra.h"
#include "frame/shading.h"

namespace strad {

struct TileRect {
  uint32_t left, top, right, bottom;  // pixels; right and bottom are one beyond the last
};

// The points on emitter groups to which a corner sends `count` shadow rays. Those of any block of 2^k x 2^k
// corners at a multiple of 2^k, up to 32 x 32, are one stretch of a sequence, in an order of blocks within
// blocks that is shuffled (Ahmed & Wonka 2020): neighbours' errors differ as much as they can, and most of
// them cancel in a mean over a few corners.
ShadowPoints corner_points(int x, int y, uint32_t count);

// Corner (x, y) is the upper left corner of pixel (x, y).
class Corners {
 public:
  // Takes samples at the corners of all pixels of `rect`, and around them as far as shadows need, at the
  // first instant of `view`.
  Corners(const FrameView& view, TileRect rect);

  const Sample& sample(int x, int y) const { return corners_[index(x, y)].sample; }
  const GroupShare* shares(int x, int y) const { return shares_.data() + index(x, y) * groups_; }

  // Do the corners of pixel (x, y) see one smooth surface under the same spotlights?
  bool surround_one_surface(int x, int y) const;
  // Does the edge of an emitter group's shadow cross it?
  bool shadow_edge(int x, int y) const;
  // Its radiance from emitter groups, W / (sr m^2): the mean over its corners.
  Rgb emitted_light(int x, int y) const;

 private:
  struct Corner {
    Sample sample;
    bool even = true;  // for each emitter group, all rays are free or all are blocked
  };

  size_t index(int x, int y) const {
    return static_cast<size_t>(y - top_) * columns_ + static_cast<size_t>(x - left_);
  }
  GroupShare* shares(int x, int y) { return shares_.data() + index(x, y) * groups_; }
  void take_samples();
  void refine_shadows();
  bool neighbours_agree(int x, int y, size_t group) const;
  bool all_even_around(int x, int y) const;
  Rgb smooth_colour(int x, int y, size_t group, PenumbraWindow window) const;

  const FrameView& view_;
  const size_t groups_;
  int left_, top_, right_, bottom_;  // right and bottom are one beyond the last
  size_t columns_;
  std::vector<Corner> corners_;
  std::vector<GroupShare> shares_;  // groups_ per corner
};

}  // namespace strad
