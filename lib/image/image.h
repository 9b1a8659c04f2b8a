// A picture: linear RGB floats, scene-referred, rows from the top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/rgb.h"

namespace strad {

struct Image {
  uint32_t width = 0, height = 0;
  std::vector<Rgb> pixels;  // width * height

  Image() = default;
  Image(uint32_t image_width, uint32_t image_height, Rgb fill = {})
      : width(image_width), height(image_height), pixels(size_t{image_width} * image_height, fill) {}

  Rgb& at(uint32_t x, uint32_t y) { return pixels[size_t{y} * width + x]; }
  const Rgb& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
  bool operator==(const Image&) const = default;
};

// A picture as texture files hold it: 8 bits per channel on the sRGB curve, rows from the top.
struct SrgbImage {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> bytes;    // width * height * 3
  std::vector<uint8_t> alpha{};  // width * height, not on the curve; empty: opaque
};

// Larger pictures are refused before memory is taken for them.
constexpr uint64_t kMaxPixels = uint64_t{1} << 28;

// Scales all pixels by 2^stops.
inline void expose(Image* image, double stops) {
  const float scale = static_cast<float>(std::exp2(stops));
  for (Rgb& pixel : image->pixels) pixel = scale * pixel;
}

}  // namespace strad
