#include "frame/corners.h"

#include <algorithm>

#include "base/rng.h"
#include "frame/penumbra.h"

namespace strad {
namespace {

// Shadow rays that a corner sends to each emitter group at first. With those of the corners around it they
// are about 100, enough to find every shadow that matters.
constexpr uint32_t kFirstRays = 2;
constexpr int kDetect = 3;  // corners around one among which its first rays must agree
// If the free fractions at the corners of a pixel differ by more than this, the edge of a shadow passes
// there.
constexpr float kSharpShadow = 0.5f;

constexpr int kBlockLevels = 5;  // of blocks of corners that share a sequence: 32 x 32
constexpr uint64_t kKeyOfFirst = 1;

uint64_t block_key(int x, int y, int level) {
  return hash_of(static_cast<uint32_t>(x >> level), static_cast<uint32_t>(y >> level),
                 static_cast<uint64_t>(level));
}

}  // namespace

ShadowPoints corner_points(int x, int y, uint32_t count) {
  uint32_t place = 0;
  for (int level = 0; level < kBlockLevels; ++level) {
    const uint32_t quarter = (static_cast<uint32_t>(x >> level) & 1) | (static_cast<uint32_t>(y >> level) & 1)
                                                                           << 1;
    place |= (quarter ^ (block_key(x, y, level + 1) & 3)) << (2 * level);
  }
  return {place * count, count, block_key(x, y, kBlockLevels)};
}

Corners::Corners(const FrameView& view, TileRect rect) : view_(view), groups_(view.group_count) {
  // The shadow of an emitter group is averaged over the corners around a pixel. Whether these get more rays
  // depends on their own neighbours.
  const int margin = groups_ > 0 ? kReach + kDetect : 0;
  left_ = static_cast<int>(rect.left) - margin;
  top_ = static_cast<int>(rect.top) - margin;
  right_ = static_cast<int>(rect.right) + 1 + margin;
  bottom_ = static_cast<int>(rect.bottom) + 1 + margin;
  columns_ = static_cast<size_t>(right_ - left_);
  take_samples();
  if (groups_ > 0) refine_shadows();
}

void Corners::take_samples() {
  const size_t count = columns_ * static_cast<size_t>(bottom_ - top_);
  corners_.resize(count);
  shares_.resize(count * groups_);
  for (int y = top_; y < bottom_; ++y) {
    for (int x = left_; x < right_; ++x) {
      ShadowPoints points = corner_points(x, y, kFirstRays);
      points.scramble = hash_of(points.scramble, kKeyOfFirst);
      corners_[index(x, y)].sample = take_sample(view_, 0, x, y, points, shares(x, y));
    }
  }
}

// Are all rays to the emitter group from the corner and those around it free, or all blocked?
bool Corners::neighbours_agree(int x, int y, size_t group) const {
  bool any_free = false, any_blocked = false, any_clear = false, any_glass = false;
  for (int v = y - kDetect; v <= y + kDetect; ++v) {
    for (int u = x - kDetect; u <= x + kDetect; ++u) {
      const GroupShare& share = shares(u, v)[group];
      const ShadowRays& shadow = share.shadow;
      if (shadow.rays == 0 && share.irradiance > 0) return false;  // nothing is known of it
      any_free |= shadow.free > 0;
      any_blocked |= shadow.free < shadow.rays;
      any_glass |= shadow.through_glass > 0;
      any_clear |= shadow.through_glass < shadow.free;
    }
  }
  return !(any_free && any_blocked) && !(any_clear && any_glass);
}

// First finds the corners that need more rays, from the first rays of all, and only then adds rays. So the
// order of the corners does not matter.
void Corners::refine_shadows() {
  struct Uneven {
    int x, y;
    size_t group;
  };
  std::vector<Uneven> uneven;
  for (int y = top_ + kDetect; y + kDetect < bottom_; ++y) {
    for (int x = left_ + kDetect; x + kDetect < right_; ++x) {
      for (size_t l = 0; l < groups_; ++l) {
        if (!neighbours_agree(x, y, l)) uneven.push_back({x, y, l});
      }
    }
  }
  for (const auto& [x, y, group] : uneven) {
    Corner& c = corners_[index(x, y)];
    c.even = false;
    add_shadow_rays(view_, 0, c.sample, group, corner_points(x, y, view_.lamp_samples), &shares(x, y)[group]);
  }
}

bool Corners::surround_one_surface(int x, int y) const {
  const Sample& first = sample(x, y);
  return alike(view_, first, sample(x + 1, y)) && alike(view_, first, sample(x, y + 1)) &&
         alike(view_, first, sample(x + 1, y + 1));
}

bool Corners::all_even_around(int x, int y) const {
  for (int v = y - 1; v <= y + 2; ++v) {
    for (int u = x - 1; u <= x + 2; ++u) {
      if (!corners_[index(u, v)].even) return false;
    }
  }
  return true;
}

// Does the edge of an emitter group's shadow cross the pixel, from light to shadow within it?
bool Corners::shadow_edge(int x, int y) const {
  for (size_t l = 0; l < groups_; ++l) {
    float low = 1, high = 0;
    for (int k = 0; k < 4; ++k) {
      const float fraction = free_fraction(shares(x + (k & 1), y + (k >> 1))[l].shadow);
      low = std::min(low, fraction), high = std::max(high, fraction);
    }
    if (high - low > kSharpShadow) return true;
  }
  return false;
}

// The visible fraction of a group of which some is seen through glass, channel by channel. `window`: of the
// fractions that are not blocked.
Rgb Corners::smooth_colour(int x, int y, size_t group, PenumbraWindow window) const {
  Rgb colour;
  for (int c = 0; c < 3; ++c) {
    for (int v = 0; v < kWindow; ++v)
      for (int u = 0; u < kWindow; ++u)
        window.fraction[static_cast<size_t>(v * kWindow + u)] =
            free_colour(shares(x + u - kReach, y + v - kReach)[group].shadow)[c];
    colour[c] = smooth_fraction(window, view_.lamp_samples);
  }
  return colour;
}

// Radiance of a pixel from emitter groups: the mean over its corners.
Rgb Corners::emitted_light(int x, int y) const {
  if (groups_ == 0) return {};
  const bool even = all_even_around(x, y);
  Rgb sum;
  PenumbraWindow window;
  for (size_t l = 0; l < groups_; ++l) {
    bool glass = false;  // between
    if (!even) {
      for (int v = 0; v < kWindow; ++v) {
        for (int u = 0; u < kWindow; ++u) {
          const int cx = x + u - kReach, cy = y + v - kReach;
          const ShadowRays& shadow = shares(cx, cy)[l].shadow;
          const size_t at = static_cast<size_t>(v * kWindow + u);
          window.fraction[at] = free_fraction(shadow);
          glass |= shadow.through_glass > 0;
          window.known[at] = shadow.all > 0 && on_one_surface(view_, sample(x, y), sample(cx, cy));
        }
      }
    }
    const float shared = even ? 1 : smooth_fraction(window, view_.lamp_samples);
    Rgb colour{shared, shared, shared};
    if (!even && glass) colour = smooth_colour(x, y, l, window);
    for (int k = 0; k < 4; ++k) {
      const GroupShare& share = shares(x + (k & 1), y + (k >> 1))[l];
      sum += (even ? free_colour(share.shadow) : colour) * share.radiance;
    }
  }
  return 0.25f * sum;
}

}  // namespace strad
