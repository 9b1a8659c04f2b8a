#include "frame/tile.h"

#include <algorithm>
#include <optional>

#include "base/rng.h"
#include "frame/corners.h"
#include "frame/sobol.h"

namespace strad {
namespace {

// Limits of contrast, the difference of two radiances over their sum. If the corners of a pixel differ by
// less than the first (on textures the second), the pixel is the mean of its corners. Otherwise, if its
// middle differs from that mean by less than the third, radiance is taken to be a quadratic function.
constexpr float kEvenContrast = 0.03f, kTextureContrast = 0.05f, kSmoothBend = 0.06f;
// A pixel with edges begins with few samples. They are doubled, up to eight times the usual number, until
// they are enough for their deviation. kUsualDeviation, relative to the mean, is enough at the usual number.
// The error of n evenly spread points is about the deviation over n^(3/4) (Mitchell 1996), here 2 % with 16
// samples.
constexpr uint32_t kFewSamples = 4, kMostDoublings = 3;
constexpr float kUsualDeviation = 0.14f;
// Shadow rays to each emitter group from a sample, where a pixel has few, the usual number, or more of them.
constexpr uint32_t kRaysOfMiddle = 8;  // of the only sample of a pixel, at first
constexpr uint32_t kRaysOfFew = 4, kRaysOfUsual = 2, kRaysOfMany = 1;

uint64_t pixel_seed(int x, int y) { return hash_of(static_cast<uint32_t>(x), static_cast<uint32_t>(y)); }

// After so many equal samples of one side of a polygon in a pixel, further ones are taken to have their mean.
constexpr uint32_t kKnownAfter = 8;

// The samples of a pixel by side of a polygon. Where the first samples of a side agree, the light of further
// ones need not be computed: a camera ray finds that they lie there. So edges can be sampled finely at little
// cost.
class SeenSides {
 public:
  void clear() { sides_.clear(); }
  // `even`: the point has no texture and is not in the penumbra of an emitter group.
  void add(const Sample& sample, bool even) { noted(sample, even); }
  void add(const Sample& sample, bool even, const Light& light) {
    Side& side = noted(sample, even);
    side.sum = side.sum + light;
    ++side.count;
  }
  std::optional<Light> mean(uint32_t polygon, bool front) {
    const Side& side = side_of(polygon, front);
    if (!side.even || side.count < kKnownAfter) return std::nullopt;
    return (1 / static_cast<float>(side.count)) * side.sum;
  }

 private:
  struct Side {
    uint32_t polygon = kNone;
    bool front = true;
    bool known = false, even = false;
    uint64_t spots = 0;
    uint32_t count = 0;
    Light sum;
  };
  Side& noted(const Sample& sample, bool even) {
    Side& side = side_of(sample.point.polygon, sample.front);
    if (!side.known) side = {side.polygon, side.front, true, true, sample.spots, 0, {}};
    side.even &= even && side.spots == sample.spots;
    return side;
  }
  Side& side_of(uint32_t polygon, bool front) {
    for (Side& side : sides_)
      if (side.polygon == polygon && side.front == front) return side;
    sides_.emplace_back();
    sides_.back().polygon = polygon, sides_.back().front = front;
    return sides_.back();
  }
  std::vector<Side> sides_;
};

// The sum of a pixel's samples.
struct PixelSum {
  Light sum;
  float luminance_squares = 0;
  uint32_t count = 0;
  uint32_t shadow_points = 0;  // of each emitter group, used so far

  void add(const Light& light) {
    sum = sum + light;
    luminance_squares += luminance(light.all) * luminance(light.all);
    ++count;
  }
  Light mean() const { return (1 / static_cast<float>(count)) * sum; }
  // Standard deviation of luminance, relative to its mean.
  float deviation() const {
    const float middle = luminance(mean().all);
    const float variance = luminance_squares / static_cast<float>(count) - middle * middle;
    return middle > 0 ? std::sqrt(std::max(0.0f, variance)) / middle : 0;
  }
};

// Difference of two radiances over their sum, in the channel where it is largest.
float contrast(Rgb a, Rgb b) {
  float most = 0;
  for (int c = 0; c < 3; ++c) {
    if (a[c] != b[c]) most = std::max(most, std::abs(a[c] - b[c]) / (a[c] + b[c]));
  }
  return most;
}

// Renders one pixel after another. There are `corners` if the frame is a single instant and has more than one
// sample per pixel.
class PixelRenderer {
 public:
  PixelRenderer(const FrameView& view, int samples, const std::optional<Corners>& corners)
      : view_(view), samples_(static_cast<uint32_t>(samples)), corners_(corners), shares_(view.group_count) {}

  Light pixel(int x, int y) {
    if (samples_ == 1) return middle(x, y);
    if (corners_ && corners_->surround_one_surface(x, y) && !corners_->shadow_edge(x, y)) {
      if (std::optional<Light> light = smooth_base(x, y)) {
        light->all += corners_->emitted_light(x, y);
        return *light;
      }
    }
    return inside(x, y);
  }

 private:
  std::optional<Light> smooth_base(int x, int y);
  bool is_even(const Sample& sample, const GroupShare* shares) const {
    return evenly_lit(view_, shares) && !sample.varies;
  }
  void sample_inside(int x, int y, uint32_t count, uint32_t rays, PixelSum* sum);
  Light inside(int x, int y);
  Light middle(int x, int y);

  const FrameView& view_;
  const uint32_t samples_;
  const std::optional<Corners>& corners_;
  std::vector<GroupShare> shares_;  // of the sample at hand
  SeenSides seen_;                  // by the pixel at hand
};

// The mean radiance, without that from emitter groups, of a pixel whose corners see one smooth surface.
// Nothing if its corners and its middle are not enough to find it.
std::optional<Light> PixelRenderer::smooth_base(int x, int y) {
  Rgb low = corners_->sample(x, y).base.all, high = low;
  Light sum;
  for (int k = 0; k < 4; ++k) {
    const Light& base = corners_->sample(x + (k & 1), y + (k >> 1)).base;
    for (int c = 0; c < 3; ++c)
      low[c] = std::min(low[c], base.all[c]), high[c] = std::max(high[c], base.all[c]);
    sum = sum + base;
  }
  const Light of_corners = 0.25f * sum;
  const bool texture = corners_->sample(x, y).varies;
  const float change = contrast(low, high);
  if (change <= (texture ? kTextureContrast : kEvenContrast)) return of_corners;
  if (texture) return std::nullopt;
  const Sample middle = take_sample(view_, 0, x + 0.5, y + 0.5, {}, shares_.data());
  if (!alike(view_, corners_->sample(x, y), middle)) return std::nullopt;
  if (contrast(middle.base.all, of_corners.all) > kSmoothBend) return std::nullopt;
  return (1 / 3.0f) * (of_corners + 2.0f * middle.base);  // exact for quadratic functions
}

// Adds samples of a pixel until there are `count`, spread evenly over its area and the instants, each with
// `rays` shadow rays to each emitter group.
void PixelRenderer::sample_inside(int x, int y, uint32_t count, uint32_t rays, PixelSum* sum) {
  const uint64_t seed = pixel_seed(x, y);
  const size_t instants = view_.instants.size();
  const uint32_t first = sum->count;
  for (uint32_t i = first; i < count; ++i) {
    const Point2 at = sobol_point(i, seed);
    const double moment = (i - first + unit_from(hash_of(seed, i))) / (count - first);
    const size_t instant =
        std::min(instants - 1, static_cast<size_t>(moment * static_cast<double>(instants)));
    const Sight sight = look(view_, instant, x + at.u, y + at.v);
    if (corners_) {
      if (const std::optional<Light> known = seen_.mean(sight.point.polygon, sight.front)) {
        sum->add(*known);
        continue;
      }
    }
    const Sample sample = shade(view_, instant, sight, {sum->shadow_points, rays, seed}, shares_.data());
    sum->shadow_points += rays;
    const Light value = light_of(view_, sample, shares_.data());
    sum->add(value);
    if (corners_) seen_.add(sample, is_even(sample, shares_.data()), value);
  }
}

// The mean of samples within the pixel, as many as their deviation demands. The corners count for the
// deviation of few samples, which may miss an edge.
Light PixelRenderer::inside(int x, int y) {
  PixelSum sum;
  seen_.clear();
  for (int k = 0; k < 4 && corners_; ++k) {
    const int u = x + (k & 1), v = y + (k >> 1);
    const Sample& corner = corners_->sample(u, v);
    seen_.add(corner, is_even(corner, corners_->shares(u, v)));
  }
  uint32_t count = corners_ ? std::min(samples_, kFewSamples) : samples_;
  for (;;) {
    const uint32_t rays = count <= kFewSamples ? kRaysOfFew : count <= samples_ ? kRaysOfUsual : kRaysOfMany;
    sample_inside(x, y, count, rays, &sum);
    PixelSum seen = sum;
    if (corners_ && count < samples_) {
      for (int k = 0; k < 4; ++k) {
        const int u = x + (k & 1), v = y + (k >> 1);
        seen.add(light_of(view_, corners_->sample(u, v), corners_->shares(u, v)));
      }
    }
    const float usual = static_cast<float>(count) / static_cast<float>(samples_);
    if (seen.deviation() <= kUsualDeviation * std::pow(usual, 0.75f)) return sum.mean();
    if (count >= samples_ << kMostDoublings) return sum.mean();
    count *= 2;
  }
}

// A single sample in the middle, for previews.
Light PixelRenderer::middle(int x, int y) {
  const size_t instant = view_.instants.size() / 2;
  const ShadowPoints all = corner_points(x, y, view_.lamp_samples);
  const ShadowPoints few{all.first, std::min(all.count, kRaysOfMiddle), all.scramble};
  const ShadowPoints others{all.first + few.count, all.count - few.count, all.scramble};
  const Sample sample = take_sample(view_, instant, x + 0.5, y + 0.5, few, shares_.data());
  for (size_t l = 0; l < view_.group_count; ++l) {
    const ShadowRays& shadow = shares_[l].shadow;
    if (shadow.free > 0 && shadow.free < shadow.rays)
      add_shadow_rays(view_, instant, sample, l, others, &shares_[l]);
  }
  return light_of(view_, sample, shares_.data());
}

// Rounding may take more from light than there is.
Rgb without_negatives(Rgb light) {
  return {std::max(light.r, 0.0f), std::max(light.g, 0.0f), std::max(light.b, 0.0f)};
}

}  // namespace

void render_tile(const FrameView& view, int samples, TileRect rect, Image* image, LightLayers* layers) {
  std::optional<Corners> corners;
  if (samples > 1 && view.instants.size() == 1) corners.emplace(view, rect);
  PixelRenderer renderer(view, samples, corners);
  for (uint32_t y = rect.top; y < rect.bottom; ++y) {
    for (uint32_t x = rect.left; x < rect.right; ++x) {
      const Light light = renderer.pixel(static_cast<int>(x), static_cast<int>(y));
      image->at(x, y) = light.all;
      if (!layers) continue;
      layers->indirect.at(x, y) = light.indirect;
      layers->emission.at(x, y) = light.emission;
      layers->specular.at(x, y) = light.specular;
      layers->direct.at(x, y) =
          without_negatives(light.all - light.indirect - light.emission - light.specular);
    }
  }
}

}  // namespace strad
