// A function of time at half the memory: 16 bits a value, in units of its own largest.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/rgb.h"

namespace strad {

// Values are not negative; each is kept to 1 / 65535 of the function's largest, far below what a solve
// resolves.
class PackedFunction {
 public:
  PackedFunction() = default;
  explicit PackedFunction(const std::vector<Rgb>& values) {
    float largest = 0;
    for (const Rgb& v : values) largest = std::max(largest, max_channel(v));
    unit_ = largest / 65535;
    codes_.reserve(3 * values.size());
    for (const Rgb& v : values)
      for (int c = 0; c < 3; ++c)
        codes_.push_back(unit_ > 0 ? static_cast<uint16_t>(std::clamp(v[c] / unit_ + 0.5f, 0.0f, 65535.0f))
                                   : 0);
  }

  bool empty() const { return codes_.empty(); }
  size_t size() const { return codes_.size() / 3; }
  Rgb operator[](size_t i) const {
    const uint16_t* c = codes_.data() + 3 * i;
    return {unit_ * static_cast<float>(c[0]), unit_ * static_cast<float>(c[1]),
            unit_ * static_cast<float>(c[2])};
  }
  std::vector<Rgb> unpacked() const {
    std::vector<Rgb> values(size());
    for (size_t i = 0; i < values.size(); ++i) values[i] = (*this)[i];
    return values;
  }

 private:
  float unit_ = 0;
  std::vector<uint16_t> codes_;
};

}  // namespace strad
