#include "frame/corners.h"

#include <algorithm>

namespace strad {
namespace {

// Shadow rays that a corner sends to each emitter group at first. With those of its eight neighbours they are
// 36, enough to find every shadow that matters.
constexpr uint32_t kFirstRays = 4;
// Up to this difference, the free fractions in a pixel and around it are taken to differ by noise alone:
// twice the noise of 64 rays.
constexpr float kSmoothShadow = 0.04f;
// If the free fractions at the corners of a pixel differ by more than this, the edge of a shadow passes
// there.
constexpr float kSharpShadow = 0.5f;

}  // namespace

uint32_t interleaved_set(int x, int y) {
  const uint32_t u = static_cast<uint32_t>(x) & 3, v = static_cast<uint32_t>(y) & 3;
  return (u & 1) | (v & 1) << 1 | (u & 2) << 1 | (v & 2) << 2;
}

Corners::Corners(const FrameView& view, TileRect rect) : view_(view), groups_(view.group_count) {
  // The shadow of an emitter group is averaged over the corners of a pixel and those next to them. Whether
  // these get more rays depends on their own neighbours.
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

// Are all rays to the emitter group from the corner and its eight neighbours free, or all blocked?
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

// First finds the corners that need more rays, from the first rays of all, and only then adds rays. So the
// order of the corners does not matter.
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

// Visible fraction of an emitter group in a pixel: the mean over the 16 corners around it if that differs
// from the mean over its own four corners by no more than noise, else the latter.
float Corners::visible(int x, int y, size_t light) const {
  ShadowRays near, wide;
  const auto add = [](const ShadowRays& from, ShadowRays* to) { to->seen += from.seen, to->all += from.all; };
  for (int v = y - 1; v <= y + 2; ++v) {
    for (int u = x - 1; u <= x + 2; ++u) {
      const ShadowRays& shadow = shares(u, v)[light].shadow;
      // Each corner has the same weight, however many rays it sent.
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

// Radiance of a pixel from emitter groups: the mean over its corners.
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
