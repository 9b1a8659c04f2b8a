// How light becomes the numbers of a picture file: bits, tone, dithering.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"

namespace strad {

enum class Depth : uint8_t { kUsual, kHalf, kFloat, kByte, kWord };  // kUsual: that of the file's format

// How whole numbers follow from light. Files of floats keep light as it is.
enum class ToneCurve : uint8_t {
  kLinear,  // in proportion to light up to white; no transfer curve
  kSrgb,    // the same, on the sRGB curve
  kFilmic   // highlights are compressed towards white as by film, then the sRGB curve
};

struct Encoding {
  Depth depth = Depth::kUsual;
  ToneCurve tone = ToneCurve::kSrgb;
  float white = 1;      // the radiance that is shown as white, > 0
  bool dither = false;  // of 8 bits, so that smooth light shows no bands
};

// The white of each curve if none is asked for. Filmic: 11.2 / 2, from Hable's talk.
constexpr float usual_white(ToneCurve tone) { return tone == ToneCurve::kFilmic ? 5.6f : 1; }

// Depths that a format has, its usual one first. `format`: an extension, lower case, without its dot.
std::vector<Depth> depths_of(const std::string& format);
inline bool is_float(Depth depth) { return depth == Depth::kHalf || depth == Depth::kFloat; }

// What is shown for `radiance`, as light between 0 and 1 (white), before any transfer curve. NaN gives 0.
float shown_light(float radiance, const Encoding& encoding);
Image shown_light(const Image& image, const Encoding& encoding);

// The channels of all pixels as whole numbers from 0 to 255 or 65535, rows from the top. Bytes are rounded up
// or down by a threshold that depends on the pixel's place alone, if `encoding.dither`: the mean over any
// 8 x 8 pixels of constant light is right to 1/64 of a step, and light that has a byte of its own keeps it.
std::vector<uint8_t> bytes_of(const Image& image, const Encoding& encoding);
std::vector<uint16_t> words_of(const Image& image, const Encoding& encoding);

}  // namespace strad
