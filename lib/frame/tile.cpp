#include "frame/tile.h"

#include <algorithm>
#include <optional>

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
// Differences of radiance over their sum. Below the first, a pixel is the mean of its corners, as for
// textures below the second; up to the third, how far the middle may lie off that mean, it is taken for a
// quadratic function.
constexpr float kEvenContrast = 0.03f, kTextureContrast = 0.05f, kSmoothBend = 0.06f;
constexpr float kMuchContrast = 0.25f;  // deviation of a pixel's samples over their mean that asks for more
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
  std::optional<Rgb> smooth_base(int x, int y) const;
  Rgb area_light(int x, int y) const;
  Rgb pixel(int x, int y) const;
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

// Difference of two radiances over their sum, in the channel where it is largest.
float contrast(Rgb a, Rgb b) {
  float most = 0;
  for (int c = 0; c < 3; ++c) {
    if (a[c] != b[c]) most = std::max(most, std::abs(a[c] - b[c]) / (a[c] + b[c]));
  }
  return most;
}

// The mean over a pixel whose corners are alike of all but area lights, if few samples tell it.
std::optional<Rgb> Tile::smooth_base(int x, int y) const {
  Rgb low = corner(x, y).sample.base, high = low, sum;
  for (int k = 0; k < 4; ++k) {
    const Rgb base = corner(x + (k & 1), y + (k >> 1)).sample.base;
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], base[c]), high[c] = std::max(high[c], base[c]);
    sum += base;
  }
  const Rgb of_corners = 0.25f * sum;
  const bool texture = textured(view_, corner(x, y).sample);
  const float change = contrast(low, high);
  if (change <= (texture ? kTextureContrast : kEvenContrast)) return of_corners;
  if (texture) return std::nullopt;
  thread_local std::vector<AreaShare> unused;
  unused.resize(lights_);
  const Sample middle = take_sample(view_, 0, x + 0.5, y + 0.5, {}, unused.data());
  if (!alike(view_, corner(x, y).sample, middle)) return std::nullopt;
  if (contrast(middle.base, of_corners) > kSmoothBend) return std::nullopt;
  return (1 / 3.0f) * (of_corners + 2 * middle.base);  // exact for quadratic functions
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

// What area lights bring to a pixel, the mean of its corners.
Rgb Tile::area_light(int x, int y) const {
  if (lights_ == 0) return {};
  const bool even = all_even_around(x, y);
  Rgb sum;
  for (size_t l = 0; l < lights_; ++l) {
    const float shared = even ? 1 : visible(x, y, l);
    for (int k = 0; k < 4; ++k) {
      const AreaShare& share = shares(x + (k & 1), y + (k >> 1))[l];
      sum += (even ? free_fraction(share.shadow) : shared) * share.radiance;
    }
  }
  return 0.25f * sum;
}

Rgb Tile::pixel(int x, int y) const {
  if (corners_alike(x, y) && !shadow_edge(x, y)) {
    if (const std::optional<Rgb> base = smooth_base(x, y)) return *base + area_light(x, y);
  }
  return inside(x, y);
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
    const size_t instant =
        std::min(instants - 1, static_cast<size_t>(moment * static_cast<double>(instants)));
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
      const Rgb radiance = samples_ == 1 ? middle(view_, x, y) : adaptive ? pixel(x, y) : inside(x, y);
      image->at(static_cast<uint32_t>(x), static_cast<uint32_t>(y)) = radiance;
    }
  }
}

}  // namespace

void render_tile(const FrameView& view, int samples, TileRect rect, Image* image) {
  Tile(view, samples, rect).render(image);
}

}  // namespace strad
