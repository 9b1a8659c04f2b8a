#include "image/encoding.h"

#include <algorithm>
#include <cmath>

#include "image/srgb.h"

namespace strad {
namespace {

// J. Hable, "Uncharted 2: HDR Lighting", GDC 2010: a rational fit to the response of film, with a toe, a
// straight part and a shoulder. A shoulder strength, B linear strength, C linear angle, D toe strength,
// E toe numerator, F toe denominator.
float hable(float x) {
  constexpr float kA = 0.15f, kB = 0.50f, kC = 0.10f, kD = 0.20f, kE = 0.02f, kF = 0.30f;
  return (x * (kA * x + kC * kB) + kD * kE) / (x * (kA * x + kB) + kD * kF) - kE / kF;
}
constexpr float kHableExposure = 2;  // by which Hable scales light before his curve

// B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", ICC 1973: the 8 x 8
// matrix, as bits of x ^ y and y interleaved, the lowest bit of the place first.
float bayer_threshold(uint32_t x, uint32_t y) {
  uint32_t rank = 0;
  for (int bit = 0; bit < 3; ++bit) {
    const uint32_t across = (x >> bit) & 1, down = (y >> bit) & 1;
    rank |= ((across ^ down) << 1 | down) << (2 * (2 - bit));
  }
  return (static_cast<float>(rank) + 0.5f) / 64;
}

template <typename Word>
std::vector<Word> whole_numbers(const Image& image, const Encoding& encoding, bool dither) {
  constexpr auto kLargest = static_cast<float>(static_cast<Word>(-1));
  const bool linear = encoding.tone == ToneCurve::kLinear;
  std::vector<Word> numbers;
  numbers.reserve(3 * image.pixels.size());
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      const float threshold = dither ? bayer_threshold(x, y) : 0.5f;
      for (int c = 0; c < 3; ++c) {
        const float light = shown_light(image.at(x, y)[c], encoding);
        const float value = kLargest * (linear ? light : srgb_from_linear(light));
        numbers.push_back(static_cast<Word>(std::min(value + threshold, kLargest)));
      }
    }
  }
  return numbers;
}

}  // namespace

std::vector<Depth> depths_of(const std::string& format) {
  if (format == "exr") return {Depth::kHalf, Depth::kFloat};
  if (format == "pfm" || format == "hdr" || format == "rgbe") return {Depth::kFloat};
  if (format == "png" || format == "ppm") return {Depth::kByte, Depth::kWord};
  if (format == "tif" || format == "tiff") return {Depth::kWord, Depth::kByte};
  return {Depth::kByte};
}

float shown_light(float radiance, const Encoding& encoding) {
  if (!(radiance > 0)) return 0;
  if (encoding.tone != ToneCurve::kFilmic) return std::min(radiance / encoding.white, 1.0f);
  if (radiance >= encoding.white) return 1;
  return std::clamp(hable(kHableExposure * radiance) / hable(kHableExposure * encoding.white), 0.0f, 1.0f);
}

Image shown_light(const Image& image, const Encoding& encoding) {
  Image shown(image.width, image.height);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) shown.pixels[i][c] = shown_light(image.pixels[i][c], encoding);
  return shown;
}

std::vector<uint8_t> bytes_of(const Image& image, const Encoding& encoding) {
  return whole_numbers<uint8_t>(image, encoding, encoding.dither);
}

std::vector<uint16_t> words_of(const Image& image, const Encoding& encoding) {
  return whole_numbers<uint16_t>(image, encoding, false);
}

}  // namespace strad
