#include "frame/tile.h"

#include <algorithm>
#include <optional>

#include "base/rng.h"
#include "frame/corners.h"
#include "frame/sobol.h"

namespace strad {
namespace {

// Differences of radiance over their sum. Below the first, a pixel is the mean of its corners, as for
// textures below the second; up to the third, how far the middle may lie off that mean, it is taken for a
// quadratic function.
constexpr float kEvenContrast = 0.03f, kTextureContrast = 0.05f, kSmoothBend = 0.06f;
// A pixel with edges begins with few samples. These are enough up to the first deviation (over the mean), the
// usual number is up to the second, four times as many are taken beyond.
constexpr uint32_t kFewSamples = 4;
constexpr float kLittleContrast = 0.04f, kMuchContrast = 0.25f;
// Shadow rays to each area light from each of the few, the usual and the many samples.
constexpr uint32_t kRaysOfFew = 4, kRaysOfUsual = 2, kRaysOfMany = 1;

uint64_t pixel_seed(int x, int y) { return hash_of(static_cast<uint32_t>(x), static_cast<uint32_t>(y)); }

// Samples of a pixel, summed.
struct PixelSum {
  Rgb sum;
  float luminance_squares = 0;
  uint32_t count = 0;
  uint32_t shadow_points = 0;  // of each area light, used so far

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

// Difference of two radiances over their sum, in the channel where it is largest.
float contrast(Rgb a, Rgb b) {
  float most = 0;
  for (int c = 0; c < 3; ++c) {
    if (a[c] != b[c]) most = std::max(most, std::abs(a[c] - b[c]) / (a[c] + b[c]));
  }
  return most;
}

// A pixel at a time. `corners` are there when the frame is a single instant and has more than one sample a
// pixel.
class PixelRenderer {
 public:
  PixelRenderer(const FrameView& view, int samples, const std::optional<Corners>& corners)
      : view_(view),
        samples_(static_cast<uint32_t>(samples)),
        corners_(corners),
        shares_(view.area_light_count) {}

  Rgb pixel(int x, int y) {
    if (samples_ == 1) return middle(x, y);
    if (corners_ && corners_->surround_one_surface(x, y) && !corners_->shadow_edge(x, y)) {
      if (const std::optional<Rgb> base = smooth_base(x, y)) return *base + corners_->area_light(x, y);
    }
    return inside(x, y);
  }

 private:
  std::optional<Rgb> smooth_base(int x, int y);
  void sample_inside(int x, int y, uint32_t count, uint32_t rays, PixelSum* sum);
  Rgb inside(int x, int y);
  Rgb middle(int x, int y);

  const FrameView& view_;
  const uint32_t samples_;
  const std::optional<Corners>& corners_;
  std::vector<AreaShare> shares_;  // of the sample at hand
};

// The mean over a pixel whose corners are alike of all but area lights, if few samples tell it.
std::optional<Rgb> PixelRenderer::smooth_base(int x, int y) {
  Rgb low = corners_->sample(x, y).base, high = low, sum;
  for (int k = 0; k < 4; ++k) {
    const Rgb base = corners_->sample(x + (k & 1), y + (k >> 1)).base;
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], base[c]), high[c] = std::max(high[c], base[c]);
    sum += base;
  }
  const Rgb of_corners = 0.25f * sum;
  const bool texture = textured(view_, corners_->sample(x, y));
  const float change = contrast(low, high);
  if (change <= (texture ? kTextureContrast : kEvenContrast)) return of_corners;
  if (texture) return std::nullopt;
  const Sample middle = take_sample(view_, 0, x + 0.5, y + 0.5, {}, shares_.data());
  if (!alike(view_, corners_->sample(x, y), middle)) return std::nullopt;
  if (contrast(middle.base, of_corners) > kSmoothBend) return std::nullopt;
  return (1 / 3.0f) * (of_corners + 2 * middle.base);  // exact for quadratic functions
}

// Adds samples of a pixel until there are `count`, spread evenly over its area and the instants, each with
// `rays` shadow rays to each area light.
void PixelRenderer::sample_inside(int x, int y, uint32_t count, uint32_t rays, PixelSum* sum) {
  const uint64_t seed = pixel_seed(x, y);
  const size_t instants = view_.instants.size();
  const uint32_t first = sum->count;
  for (uint32_t i = first; i < count; ++i) {
    const Point2 at = sobol_point(i, seed);
    const double moment = (i - first + unit_from(hash_of(seed, i))) / (count - first);
    const size_t instant =
        std::min(instants - 1, static_cast<size_t>(moment * static_cast<double>(instants)));
    const Sample sample =
        take_sample(view_, instant, x + at.u, y + at.v, {sum->shadow_points, rays}, shares_.data());
    sum->shadow_points += rays;
    sum->add(radiance(view_, sample, shares_.data()));
  }
}

// The mean of many samples within the pixel: few where these and the corners hardly differ, and four times as
// many as usual where they differ much.
Rgb PixelRenderer::inside(int x, int y) {
  PixelSum sum;
  if (corners_ && samples_ > kFewSamples) {
    sample_inside(x, y, kFewSamples, kRaysOfFew, &sum);
    PixelSum with_corners = sum;
    for (int k = 0; k < 4; ++k) {
      const int u = x + (k & 1), v = y + (k >> 1);
      with_corners.add(radiance(view_, corners_->sample(u, v), corners_->shares(u, v)));
    }
    if (with_corners.deviation() <= kLittleContrast) return sum.mean();
  }
  sample_inside(x, y, samples_, kRaysOfUsual, &sum);
  if (sum.deviation() > kMuchContrast) sample_inside(x, y, 4 * samples_, kRaysOfMany, &sum);
  return sum.mean();
}

// A single sample in the middle, for quick looks.
Rgb PixelRenderer::middle(int x, int y) {
  const size_t instant = view_.instants.size() / 2;
  const ShadowPoints points{kPenumbraRays * interleaved_set(x, y), kPenumbraRays};
  const Sample sample = take_sample(view_, instant, x + 0.5, y + 0.5, points, shares_.data());
  return radiance(view_, sample, shares_.data());
}

}  // namespace

void render_tile(const FrameView& view, int samples, TileRect rect, Image* image) {
  std::optional<Corners> corners;
  if (samples > 1 && view.instants.size() == 1) corners.emplace(view, rect);
  PixelRenderer renderer(view, samples, corners);
  for (uint32_t y = rect.top; y < rect.bottom; ++y) {
    for (uint32_t x = rect.left; x < rect.right; ++x) {
      image->at(x, y) = renderer.pixel(static_cast<int>(x), static_cast<int>(y));
    }
  }
}

}  // namespace strad
