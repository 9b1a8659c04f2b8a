#include "frame/tile.h"

#include <algorithm>

#include "base/rng.h"
#include "frame/sobol.h"

namespace strad {
namespace {

constexpr uint32_t kFirstRays =
    4;  // shadow rays of a corner to each area light at first: with those of its
        // neighbours 36, few enough to pay and enough to miss no shadow that matters
constexpr uint32_t kPenumbraRays =
    16;                             // and where they disagree: 256 with those of the corners around a pixel
constexpr uint32_t kInnerRays = 4;  // to each area light from each sample of a pixel with many
constexpr float kSmoothShadow = 0.04f;  // twice the noise of 64 rays: a smaller difference is none
constexpr float kMuchContrast = 0.25f;   // deviation of a pixel's samples over their mean that asks for more
constexpr float kSharpShadow = 0.5f;    // free fractions so far apart within a pixel mean an edge

// Which of the 16 sets of points on the lights a corner uses: neighbours that share a pixel use different
// ones.
uint32_t interleaved(int x, int y) {
  const uint32_t u = static_cast<uint32_t>(x) & 3, v = static_cast<uint32_t>(y) & 3;
  return (u & 1) | (v & 1) << 1 | (u & 2) << 1 | (v & 2) << 2;
}

uint64_t pixel_seed(int x, int y) { return hash_of(static_cast<uint32_t>(x), static_cast<uint32_t>(y)); }

// Samples of a pixel, summed.
struct PixelSum {
  Rgb sum;
  float luminance_squares = 0;
  int count = 0;

  void add(Rgb radiance) {
    sum += radiance;
    luminance_squares += luminance(radiance) * luminance(radiance);
    ++count;
  }
  Rgb mean() const { return (1 / static_cast<float>(count)) * sum; }
  // Standard deviation of luminance over its mean.
  float deviation() const {
    const float middle = luminance(mean());
    const float variance = luminance_squares / static_cast<float>(count) - middle * middle;
    return middle > 0 ? std::sqrt(std::max(0.0f, variance)) / middle : 0;
  }
};

class Tile {
 public:
  Tile(const FrameView& view, int samples, TileRect rect);
  void render(Image* image);

 private:
  struct Corner {
    Sample sample;
    bool even = true;  // each area light is free, or each ray to it is blocked
  };

  size_t index(int x, int y) const {
    return static_cast<size_t>(y - top_) * columns_ + static_cast<size_t>(x - left_);
  }
  const Corner& corner(int x, int y) const { return corners_[index(x, y)]; }
  AreaShare* shares(int x, int y) { return shares_.data() + index(x, y) * lights_; }
  const AreaShare* shares(int x, int y) const { return shares_.data() + index(x, y) * lights_; }

  void sample_corners();
  void refine_shadows();
  bool neighbours_agree(int x, int y, size_t light) const;
  bool all_even_around(int x, int y) const;
  bool corners_alike(int x, int y) const;
  bool shadow_edge(int x, int y) const;
  float visible(int x, int y, size_t light) const;
  Rgb corner_mean(int x, int y) const;
  void sample_inside(int x, int y, uint32_t first, uint32_t last, PixelSum* sum) const;
  Rgb inside(int x, int y) const;

  const FrameView& view_;
  const int samples_;
  const TileRect rect_;
  const size_t lights_;
  int left_, top_, right_, bottom_;  // corners, right and bottom beyond the last
  size_t columns_;
  std::vector<Corner> corners_;
  std::vector<AreaShare> shares_;  // lights_ a corner
};

Tile::Tile(const FrameView& view, int samples, TileRect rect)
    : view_(view), samples_(samples), rect_(rect), lights_(view.area_light_count) {
  // Shadows of area lights look at one corner more around each pixel, whose own refinement looks at one more.
  const int margin = lights_ > 0 ? 2 : 0;
  left_ = static_cast<int>(rect.left) - margin;
  top_ = static_cast<int>(rect.top) - margin;
  right_ = static_cast<int>(rect.right) + 1 + margin;
  bottom_ = static_cast<int>(rect.bottom) + 1 + margin;
  columns_ = static_cast<size_t>(right_ - left_);
}

void Tile::sample_corners() {
  const size_t count = columns_ * static_cast<size_t>(bottom_ - top_);
  corners_.resize(count);
  shares_.resize(count * lights_);
  for (int y = top_; y < bottom_; ++y) {
    for (int x = left_; x < right_; ++x) {
      const ShadowPoints points{kPenumbraRays * interleaved(x, y), kFirstRays};
      corners_[index(x, y)].sample = take_sample(view_, 0, x, y, points, shares(x, y));
    }
  }
}

// Have all rays to the light from the corner and those around it the same fate?
bool Tile::neighbours_agree(int x, int y, size_t light) const {
  bool any_free = false, any_blocked = false;
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      const Shadow& shadow = shares(u, v)[light].shadow;
      any_free |= shadow.free > 0;
      any_blocked |= shadow.free < shadow.rays;
    }
  }
  return !(any_free && any_blocked);
}

// Decides for all corners from their first rays, then adds rays, so that no order matters.
void Tile::refine_shadows() {
  struct Uneven {
    int x, y;
    size_t light;
  };
  std::vector<Uneven> uneven;
  for (int y = top_ + 1; y + 1 < bottom_; ++y) {
    for (int x = left_ + 1; x + 1 < right_; ++x) {
      for (size_t l = 0; l < lights_; ++l) {
        if (!neighbours_agree(x, y, l)) uneven.push_back({x, y, l});
      }
    }
  }
  for (const auto& [x, y, light] : uneven) {
    Corner& c = corners_[index(x, y)];
    c.even = false;
    const ShadowPoints more{kPenumbraRays * interleaved(x, y) + kFirstRays, kPenumbraRays - kFirstRays};
    add_shadow_rays(view_, 0, c.sample, light, more, &shares(x, y)[light]);
  }
}

bool Tile::corners_alike(int x, int y) const {
  const Sample& first = corner(x, y).sample;
  return alike(view_, first, corner(x + 1, y).sample) && alike(view_, first, corner(x, y + 1).sample) &&
         alike(view_, first, corner(x + 1, y + 1).sample);
}

bool Tile::all_even_around(int x, int y) const {
  for (int v = y - 1; v <= y + 2; ++v) {
    for (int u = x - 1; u <= x + 2; ++u) {
      if (!corner(u, v).even) return false;
    }
  }
  return true;
}

// Does a shadow of an area light begin and end within the pixel?
bool Tile::shadow_edge(int x, int y) const {
  for (size_t l = 0; l < lights_; ++l) {
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
float Tile::visible(int x, int y, size_t light) const {
  Shadow near, wide;
  const auto add = [](const Shadow& from, Shadow* to) { to->seen += from.seen, to->all += from.all; };
  for (int v = y - 1; v <= y + 2; ++v) {
    for (int u = x - 1; u <= x + 2; ++u) {
      const Shadow& shadow = shares(u, v)[light].shadow;
      // Each corner counts the same, however many rays it sent.
      const Shadow one{free_fraction(shadow), shadow.all > 0 ? 1.0f : 0.0f, 0, 0};
      const bool inner = u >= x && u <= x + 1 && v >= y && v <= y + 1;
      if (inner) add(one, &near);
      if (inner || on_one_surface(view_, corner(x, y).sample, corner(u, v).sample)) add(one, &wide);
    }
  }
  const float own = free_fraction(near), around = free_fraction(wide);
  const float blend = std::clamp((std::abs(own - around) - kSmoothShadow) / kSmoothShadow, 0.0f, 1.0f);
  return around + blend * (own - around);
}

// The pixel as the mean of its corners.
Rgb Tile::corner_mean(int x, int y) const {
  const bool even = lights_ == 0 || all_even_around(x, y);
  Rgb sum;
  for (int k = 0; k < 4; ++k) {
    const int u = x + (k & 1), v = y + (k >> 1);
    sum += even ? radiance(view_, corner(u, v).sample, shares(u, v)) : corner(u, v).sample.base;
  }
  for (size_t l = 0; !even && l < lights_; ++l) {
    Rgb unshadowed;
    for (int k = 0; k < 4; ++k) unshadowed += shares(x + (k & 1), y + (k >> 1))[l].radiance;
    sum += visible(x, y, l) * unshadowed;
  }
  return 0.25f * sum;
}

// Adds samples [first, last) of a pixel, spread evenly over its area and the instants.
void Tile::sample_inside(int x, int y, uint32_t first, uint32_t last, PixelSum* sum) const {
  const uint64_t seed = pixel_seed(x, y);
  const size_t instants = view_.instants.size();
  thread_local std::vector<AreaShare> light_shares;
  light_shares.resize(lights_);
  for (uint32_t i = first; i < last; ++i) {
    const Point2 at = sobol_point(i, seed);
    const double moment = (i - first + unit_from(hash_of(seed, i))) / (last - first);
    const size_t instant = std::min(instants - 1, static_cast<size_t>(moment * static_cast<double>(instants)));
    const Sample sample =
        take_sample(view_, instant, x + at.u, y + at.v, {kInnerRays * i, kInnerRays}, light_shares.data());
    sum->add(radiance(view_, sample, light_shares.data()));
  }
}

// The mean of many samples within the pixel, and of four times as many where they differ much.
Rgb Tile::inside(int x, int y) const {
  const uint32_t count = static_cast<uint32_t>(samples_);
  PixelSum sum;
  sample_inside(x, y, 0, count, &sum);
  if (sum.deviation() > kMuchContrast) sample_inside(x, y, count, 4 * count, &sum);
  return sum.mean();
}

// A single sample in the middle, for quick looks.
Rgb middle(const FrameView& view, int x, int y) {
  thread_local std::vector<AreaShare> light_shares;
  light_shares.resize(view.area_light_count);
  const size_t instant = view.instants.size() / 2;
  const ShadowPoints points{kPenumbraRays * interleaved(x, y), kPenumbraRays};
  const Sample sample = take_sample(view, instant, x + 0.5, y + 0.5, points, light_shares.data());
  return radiance(view, sample, light_shares.data());
}

void Tile::render(Image* image) {
  const bool adaptive = samples_ > 1 && view_.instants.size() == 1;
  if (adaptive) sample_corners();
  if (adaptive && lights_ > 0) refine_shadows();
  for (int y = static_cast<int>(rect_.top); y < static_cast<int>(rect_.bottom); ++y) {
    for (int x = static_cast<int>(rect_.left); x < static_cast<int>(rect_.right); ++x) {
      Rgb& pixel = image->at(static_cast<uint32_t>(x), static_cast<uint32_t>(y));
      if (samples_ == 1) {
        pixel = middle(view_, x, y);
      } else {
        pixel = adaptive && corners_alike(x, y) && !shadow_edge(x, y) ? corner_mean(x, y) : inside(x, y);
      }
    }
  }
}

}  // namespace

void render_tile(const FrameView& view, int samples, TileRect rect, Image* image) {
  Tile(view, samples, rect).render(image);
}

}  // namespace strad
