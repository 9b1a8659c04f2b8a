// How much two pictures differ, and how much a sequence flickers.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace strad {

struct WorstPixel {
  uint32_t x = 0, y = 0;
  int channel = 0;  // 0 red, 1 green, 2 blue
  float a = 0, b = 0;
};

// Over all pixels and channels that count.
struct Comparison {
  double mean_a = 0, mean_b = 0;
  double mean_square = 0;  // of b - a; negative only if a twin removes more noise than there is error
  double largest = 0;      // |b - a|, at `worst`
  WorstPixel worst;
};

// Compares `b` to the reference `a`. A `twin` is a second rendering of the reference with independent noise:
// the mean of (b - a)(b - twin) is free of the noise of both. Pixels with left_out[pixel] do not count.
// REQUIRES: equal sizes, finite pixels; `left_out` empty or one flag per pixel.
Comparison compare(const Image& a, const Image& b, const Image* twin = nullptr,
                   const std::vector<bool>& left_out = {});

// The frames of a sequence taken together; each weighs the same.
Comparison mean_of(const std::vector<Comparison>& frames);

// RMSE over the reference's mean; negative if the mean square is. 0 for equal pictures, infinite if only the
// reference is black.
double rel_rmse(const Comparison& comparison);
// (mean of b) / (mean of a) - 1
double bias(const Comparison& comparison);

// RMS over pixels of the second temporal difference of luminance, and the mean luminance of the middle frame.
struct Flicker {
  double rms = 0, mean = 0;
};
Flicker flicker(const Image& before, const Image& middle, const Image& after,
                const std::vector<bool>& left_out = {});

// Pixel by pixel b - a.
Image difference(const Image& a, const Image& b);

// False colours of the largest channel of |b - a|: black, blue, cyan, yellow, red and, from `full` on, white.
Image heat_map(const Image& a, const Image& b, double full);

// Throw BadInput, which begins with the name of the picture at fault.
void require_finite(const Image& image, const std::string& name);
void require_equal_sizes(const Image& a, const std::string& name_a, const Image& b,
                         const std::string& name_b);

}  // namespace strad
