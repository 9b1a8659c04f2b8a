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
class FineFunction {
 public:
  FineFunction() = default;
  explicit FineFunction(const std::vector<Rgb>& values) {
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

 private:
  float unit_ = 0;
  std::vector<uint16_t> codes_;
};

// The same in 4 bytes per time sample: 11 bits of red and green, 10 of blue. For functions whose values are
// all of one order, as indirect light is.
class CoarseFunction {
 public:
  CoarseFunction() = default;
  explicit CoarseFunction(const std::vector<Rgb>& values) {
    for (const Rgb& v : values) largest_ = std::max(largest_, max_channel(v));
    codes_.reserve(values.size());
    const float scale = largest_ > 0 ? 1 / largest_ : 0;
    const auto code = [&](float v, float most) {
      return static_cast<uint32_t>(std::clamp(v * scale * most + 0.5f, 0.0f, most));
    };
    for (const Rgb& v : values)
      codes_.push_back(code(v.r, 2047) << 21 | code(v.g, 2047) << 10 | code(v.b, 1023));
  }

  bool empty() const { return codes_.empty(); }
  size_t size() const { return codes_.size(); }
  Rgb operator[](size_t i) const {
    const uint32_t c = codes_[i];
    return {largest_ / 2047 * static_cast<float>(c >> 21),
            largest_ / 2047 * static_cast<float>(c >> 10 & 2047),
            largest_ / 1023 * static_cast<float>(c & 1023)};
  }
  std::vector<Rgb> unpacked() const {
    std::vector<Rgb> values(size());
    for (size_t i = 0; i < values.size(); ++i) values[i] = (*this)[i];
    return values;
  }

 private:
  float largest_ = 0;
  std::vector<uint32_t> codes_;
};

}  // namespace strad
