#include "image/metrics.h"

#include <cmath>
#include <limits>

#include "base/error.h"

namespace strad {
namespace {

double ratio(double value, double reference) {
  if (reference > 0) return value / reference;
  return value == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), value);
}

bool counts(const std::vector<bool>& left_out, size_t pixel) { return left_out.empty() || !left_out[pixel]; }

std::string size_text(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
}

}  // namespace

Comparison compare(const Image& a, const Image& b, const Image* twin, const std::vector<bool>& left_out) {
  Comparison sums;
  size_t count = 0;
  for (size_t pixel = 0; pixel < a.pixels.size(); ++pixel) {
    if (!counts(left_out, pixel)) continue;
    for (int channel = 0; channel < 3; ++channel, ++count) {
      const float value_a = a.pixels[pixel][channel], value_b = b.pixels[pixel][channel];
      const double error = double{value_b} - value_a;
      sums.mean_a += twin ? 0.5 * (double{value_a} + twin->pixels[pixel][channel]) : value_a;
      sums.mean_b += value_b;
      sums.mean_square += error * (twin ? double{value_b} - twin->pixels[pixel][channel] : error);
      if (std::abs(error) <= sums.largest) continue;
      sums.largest = std::abs(error);
      sums.worst = {static_cast<uint32_t>(pixel % a.width), static_cast<uint32_t>(pixel / a.width), channel,
                    value_a, value_b};
    }
  }
  if (count == 0) return {};
  for (double* sum : {&sums.mean_a, &sums.mean_b, &sums.mean_square}) *sum /= static_cast<double>(count);
  return sums;
}

Comparison mean_of(const std::vector<Comparison>& frames) {
  Comparison mean;
  for (const Comparison& frame : frames) {
    const double weight = 1 / static_cast<double>(frames.size());
    mean.mean_a += weight * frame.mean_a;
    mean.mean_b += weight * frame.mean_b;
    mean.mean_square += weight * frame.mean_square;
    if (frame.largest <= mean.largest) continue;
    mean.largest = frame.largest;
    mean.worst = frame.worst;
  }
  return mean;
}

double rel_rmse(const Comparison& comparison) {
  const double root = std::sqrt(std::abs(comparison.mean_square));
  return ratio(std::copysign(root, comparison.mean_square), comparison.mean_a);
}

double bias(const Comparison& comparison) {
  return ratio(comparison.mean_b - comparison.mean_a, comparison.mean_a);
}

Flicker flicker(const Image& before, const Image& middle, const Image& after,
                const std::vector<bool>& left_out) {
  Flicker sums;
  size_t count = 0;
  for (size_t pixel = 0; pixel < middle.pixels.size(); ++pixel) {
    if (!counts(left_out, pixel)) continue;
    const double now = luminance(middle.pixels[pixel]);
    const double second = luminance(after.pixels[pixel]) - 2 * now + luminance(before.pixels[pixel]);
    sums.rms += second * second;
    sums.mean += now;
    ++count;
  }
  if (count == 0) return {};
  return {std::sqrt(sums.rms / static_cast<double>(count)), sums.mean / static_cast<double>(count)};
}

Image difference(const Image& a, const Image& b) {
  Image result(a.width, a.height);
  for (size_t pixel = 0; pixel < a.pixels.size(); ++pixel)
    result.pixels[pixel] = b.pixels[pixel] - a.pixels[pixel];
  return result;
}

Image heat_map(const Image& a, const Image& b, double full) {
  const Rgb ramp[] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 0}, {1, 0, 0}, {1, 1, 1}};
  constexpr int kSteps = 5;
  Image result = difference(a, b);
  for (Rgb& pixel : result.pixels) {
    const Rgb size{std::abs(pixel.r), std::abs(pixel.g), std::abs(pixel.b)};
    const double heat = full > 0 ? std::min(max_channel(size) / full, 1.0) : is_black(size) ? 0 : 1;
    const int step = std::min(static_cast<int>(heat * kSteps), kSteps - 1);
    const float s = static_cast<float>(heat * kSteps - step);
    pixel = (1 - s) * ramp[step] + s * ramp[step + 1];
  }
  return result;
}

void require_finite(const Image& image, const std::string& name) {
  for (size_t pixel = 0; pixel < image.pixels.size(); ++pixel)
    if (!is_finite(image.pixels[pixel]))
      throw BadInput(name + ": the pixel in column " + std::to_string(pixel % image.width) + " of row " +
                     std::to_string(pixel / image.width) + " is not finite");
}

void require_equal_sizes(const Image& a, const std::string& name_a, const Image& b,
                         const std::string& name_b) {
  if (a.width != b.width || a.height != b.height)
    throw BadInput(name_b + ": found " + size_text(b) + ", expected " + size_text(a) + " as in " + name_a);
}

}  // namespace strad
