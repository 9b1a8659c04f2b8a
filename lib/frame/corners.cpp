#include "frame/corners.h"

#include <algorithm>

namespace strad {
namespace {

// Shadow rays of a corner to each emitter group at first: with those of its neighbours 36, few enough to pay
// and enough to miss no shadow that matters.
constexpr uint32_t kFirstRays = 4;
// Free fractions of a pixel and around it differ by noise alone up to this, twice the noise of 64 rays.
constexpr float kSmoothShadow = 0.04f;
// Free fractions so far apart within a pixel mean an edge.
constexpr float kSharpShadow = 0.5f;

}  // namespace

uint32_t interleaved_set(int x, int y) {
  const uint32_t u = static_cast<uint32_t>(x) & 3, v = static_cast<uint32_t>(y) & 3;
  return (u & 1) | (v & 1) << 1 | (u & 2) << 1 | (v & 2) << 2;
}

Corners::Corners(const FrameView& view, TileRect rect) : view_(view), groups_(view.group_count) {
  // Shadows of emitter groups look at one corner more around each pixel, whose own refinement looks at one
  // more.
  const int margin = groups_ > 0 ? 2 : 0;
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
      const ShadowPoints points{kPenumbraRays * interleaved_set(x, y), kFirstRays};
      corners_[index(x, y)].sample = take_sample(view_, 0, x, y, points, shares(x, y));
    }
  }
}

// Have all rays to the light from the corner and those around it the same fate?
bool Corners::neighbours_agree(int x, int y, size_t light) const {
  bool any_free = false, any_blocked = false;
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      const ShadowRays& shadow = shares(u, v)[light].shadow;
      any_free |= shadow.free > 0;
      any_blocked |= shadow.free < shadow.rays;
    }
  }
  return !(any_free && any_blocked);
}

// Decides for all corners from their first rays, then adds rays, so that no order matters.
void Corners::refine_shadows() {
  struct Uneven {
    int x, y;
    size_t light;
  };
  std::vector<Uneven> uneven;
  for (int y = top_ + 1; y + 1 < bottom_; ++y) {
    for (int x = left_ + 1; x + 1 < right_; ++x) {
      for (size_t l = 0; l < groups_; ++l) {
        if (!neighbours_agree(x, y, l)) uneven.push_back({x, y, l});
      }
    }
  }
  for (const auto& [x, y, light] : uneven) {
    Corner& c = corners_[index(x, y)];
    c.even = false;
    const ShadowPoints more{kPenumbraRays * interleaved_set(x, y) + kFirstRays, kPenumbraRays - kFirstRays};
    add_shadow_rays(view_, 0, c.sample, light, more, &shares(x, y)[light]);
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

// Does a shadow of an emitter group begin and end within the pixel?
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

// Free fraction of a light over a pixel: from all 16 corners around it where that differs from the pixel's
// own four by no more than their noise, else from those four.
float Corners::visible(int x, int y, size_t light) const {
  ShadowRays near, wide;
  const auto add = [](const ShadowRays& from, ShadowRays* to) { to->seen += from.seen, to->all += from.all; };
  for (int v = y - 1; v <= y + 2; ++v) {
    for (int u = x - 1; u <= x + 2; ++u) {
      const ShadowRays& shadow = shares(u, v)[light].shadow;
      // Each corner counts the same, however many rays it sent.
      const ShadowRays one{free_fraction(shadow), shadow.all > 0 ? 1.0f : 0.0f, 0, 0};
      const bool inner = u >= x && u <= x + 1 && v >= y && v <= y + 1;
      if (inner) add(one, &near);
      if (inner || on_one_surface(view_, sample(x, y), sample(u, v))) add(one, &wide);
    }
  }
  const float own = free_fraction(near), around = free_fraction(wide);
  const float blend = std::clamp((std::abs(own - around) - kSmoothShadow) / kSmoothShadow, 0.0f, 1.0f);
  return around + blend * (own - around);
}

// What emitter groups bring to a pixel, the mean of its corners.
Rgb Corners::emitted_light(int x, int y) const {
  if (groups_ == 0) return {};
  const bool even = all_even_around(x, y);
  Rgb sum;
  for (size_t l = 0; l < groups_; ++l) {
    const float shared = even ? 1 : visible(x, y, l);
    for (int k = 0; k < 4; ++k) {
      const GroupShare& share = shares(x + (k & 1), y + (k >> 1))[l];
      sum += (even ? free_fraction(share.shadow) : shared) * share.radiance;
    }
  }
  return 0.25f * sum;
}

}  // namespace strad
