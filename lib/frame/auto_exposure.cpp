#include "frame/auto_exposure.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

constexpr float kMiddleGrey = 0.18f;
constexpr double kBurntShare = 0.02;
constexpr double kBlack = 1e-3;  // over the mean: so dark that its logarithm should not count in full
constexpr int kInstants = 16;
constexpr uint32_t kRows = 48;  // of the pictures that are looked at

// The radiance that is shown as middle grey.
double grey_radiance(const Encoding& encoding) {
  float low = 0, high = encoding.white;
  for (int halving = 0; halving < 32; ++halving) {
    const float middle = (low + high) / 2;
    (shown_light(middle, encoding) < kMiddleGrey ? low : high) = middle;
  }
  return high;
}

}  // namespace

double exposure_for(const std::vector<Rgb>& radiances, const Encoding& encoding) {
  double sum = 0;
  for (const Rgb& radiance : radiances) sum += luminance(radiance);
  if (!(sum > 0)) return 0;
  const double count = static_cast<double>(radiances.size());
  double logarithms = 0;
  std::vector<float> largest;
  for (const Rgb& radiance : radiances) {
    logarithms += std::log(luminance(radiance) + kBlack * sum / count);
    largest.push_back(max_channel(radiance));
  }
  const auto bright = largest.begin() + static_cast<std::ptrdiff_t>((1 - kBurntShare) * (count - 1));
  std::nth_element(largest.begin(), bright, largest.end());
  double scale = grey_radiance(encoding) / std::exp(logarithms / count);
  if (*bright > 0) scale = std::min(scale, static_cast<double>(encoding.white / *bright));
  return std::round(100 * std::log2(scale)) / 100;
}

double exposure_for(SolutionFile* file, Raster* raster, const Camera& camera, const RasterOptions& options,
                    const Encoding& encoding) {
  const uint32_t columns = std::clamp(
      static_cast<uint32_t>(std::lround(double{kRows} * options.width / options.height)), 1u, 512u);
  std::vector<Rgb> radiances;
  for (int i = 0; i < kInstants; ++i) {
    const double time = file->begin() + (i + 0.5) / kInstants * (file->end() - file->begin());
    const std::vector<Rgb> seen = raster->reflected_light(file->slab_at(time), camera, time, columns, kRows);
    radiances.insert(radiances.end(), seen.begin(), seen.end());
  }
  return exposure_for(radiances, encoding);
}

}  // namespace strad
