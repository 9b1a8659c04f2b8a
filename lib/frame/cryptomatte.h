// Masks of named things in a picture, by the Cryptomatte specification 1.2.0 (Psyop, 2018).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/layers.h"

namespace strad {

// MurmurHash3 for 32-bit results with seed 0 (A. Appleby 2011), which the specification prescribes.
uint32_t murmur_hash(std::string_view text);

// A name as the number that stands for it in a picture: its hash, kept away from numbers that are not finite
// or not normalized.
float cryptomatte_id(std::string_view name);

// What is in a pixel, by name: how much of its area each thing covers. Largest first.
class Coverage {
 public:
  void add(uint32_t thing, float share);
  void clear() { shares_.clear(); }
  std::vector<std::pair<uint32_t, float>> largest() const;  // equal shares in order of things

 private:
  std::vector<std::pair<uint32_t, float>> shares_;
};

// The layers and texts of one matte: `name`00 to `name`02 with the channels R, G, B, A for two things each.
class Cryptomatte {
 public:
  // REQUIRES: `things` are the names by number.
  Cryptomatte(std::string name, std::vector<std::string> things, uint32_t width, uint32_t height);

  void set(uint32_t x, uint32_t y, const Coverage& coverage);  // may be called for different pixels at once
  void finish(LayeredImage* image);                            // moves all into `image`

 private:
  std::string name_;
  std::vector<std::string> things_;
  std::vector<float> ids_;
  uint32_t width_;
  std::vector<Layer> layers_;
};

}  // namespace strad
