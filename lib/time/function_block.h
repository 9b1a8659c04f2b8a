// Functions of time of many lights in one block, which can be filled in any order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/none.h"
#include "base/rgb.h"

namespace strad {

// Values are kept as the upper halves of floats, to 3 significant digits; what many of them add up to is far
// better than that.
class FunctionBlock {
 public:
  FunctionBlock() = default;
  // Functions of `lights` (ascending, below `light_count`) at `time samples` time samples, zero.
  FunctionBlock(size_t leaf_count, const std::vector<uint32_t>& lights, size_t time_samples)
      : lights_(lights),
        dates_(time_samples),
        row_(leaf_count, kNone),
        bits_(3 * time_samples * lights.size()) {
    for (size_t i = 0; i < lights.size(); ++i) row_[lights[i]] = static_cast<uint32_t>(i);
  }

  const std::vector<uint32_t>& rows() const { return lights_; }
  size_t sample_count() const { return dates_; }
  bool has(uint32_t light) const { return row_[light] != kNone; }

  // REQUIRES: has(light).
  Rgb get(uint32_t light, size_t time_sample) const {
    const uint16_t* b = bits_.data() + 3 * (row_[light] * dates_ + time_sample);
    return {decoded(b[0]), decoded(b[1]), decoded(b[2])};
  }
  void set(uint32_t light, size_t time_sample, Rgb value) {
    uint16_t* b = bits_.data() + 3 * (row_[light] * dates_ + time_sample);
    for (int c = 0; c < 3; ++c)
      b[c] = static_cast<uint16_t>((std::bit_cast<uint32_t>(value[c]) + 0x8000u) >> 16);
  }
  // sum[i] += weights[i] * get(light, first + i)
  void add(uint32_t light, size_t first, size_t count, const float* weights, Rgb* sum) const {
    const uint16_t* b = bits_.data() + 3 * (row_[light] * dates_ + first);
    for (size_t i = 0; i < count; ++i, b += 3)
      sum[i] += weights[i] * Rgb{decoded(b[0]), decoded(b[1]), decoded(b[2])};
  }

 private:
  static float decoded(uint16_t bits) { return std::bit_cast<float>(static_cast<uint32_t>(bits) << 16); }

  std::vector<uint32_t> lights_;
  size_t dates_ = 0;
  std::vector<uint32_t> row_;  // [light]
  std::vector<uint16_t> bits_;
};

}  // namespace strad
