// Functions of time of many leaves in one array, which can be filled in any order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/none.h"
#include "base/rgb.h"

namespace strad {

// 6 bytes per time sample: each channel is the upper half of a float, rounded to nearest, so its error is at
// most 1/256 of the value. The error of a sum of many values is far smaller.
class FunctionBlock {
 public:
  FunctionBlock() = default;
  // Zero functions for `leaves` (ascending, below `leaf_count`), `sample_count` time samples each.
  FunctionBlock(size_t leaf_count, const std::vector<uint32_t>& leaves, size_t sample_count)
      : leaves_(leaves),
        sample_count_(sample_count),
        row_(leaf_count, kNone),
        bits_(3 * sample_count * leaves.size()) {
    for (size_t i = 0; i < leaves.size(); ++i) row_[leaves[i]] = static_cast<uint32_t>(i);
  }

  const std::vector<uint32_t>& rows() const { return leaves_; }
  size_t sample_count() const { return sample_count_; }
  bool has(uint32_t leaf) const { return row_[leaf] != kNone; }

  // REQUIRES: has(leaf).
  Rgb get(uint32_t leaf, size_t time_sample) const {
    const uint16_t* b = bits_.data() + 3 * size_t{row_[leaf]} * sample_count_ + time_sample;
    return {decoded(b[0]), decoded(b[sample_count_]), decoded(b[2 * sample_count_])};
  }
  void set(uint32_t leaf, size_t time_sample, Rgb value) {
    uint16_t* b = bits_.data() + 3 * size_t{row_[leaf]} * sample_count_ + time_sample;
    for (int c = 0; c < 3; ++c, b += sample_count_)
      *b = static_cast<uint16_t>((std::bit_cast<uint32_t>(value[c]) + 0x8000u) >> 16);
  }
  // sums[c * sample_count() + i] += weights[i] * get(leaf, i)[c], for the time samples i of [first, end).
  void add(uint32_t leaf, size_t first, size_t end, const float* weights, float* sums) const {
    const uint16_t* b = bits_.data() + 3 * size_t{row_[leaf]} * sample_count_;
    for (int c = 0; c < 3; ++c, b += sample_count_, sums += sample_count_)
      for (size_t i = first; i < end; ++i) sums[i] += weights[i] * decoded(b[i]);
  }

 private:
  static float decoded(uint16_t bits) { return std::bit_cast<float>(static_cast<uint32_t>(bits) << 16); }

  std::vector<uint32_t> leaves_;
  size_t sample_count_ = 0;
  std::vector<uint32_t> row_;   // [leaf]
  std::vector<uint16_t> bits_;  // [row][channel][time sample]
};

}  // namespace strad
