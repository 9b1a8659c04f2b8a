// A function of time in fewer bits: all its values are fractions of its largest.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/rgb.h"

namespace strad {

// Values at time samples, none of them negative. `Coding` turns a value and the function's largest channel
// into a code, and back.
template <typename Coding>
class ScaledFunction {
 public:
  ScaledFunction() = default;
  explicit ScaledFunction(const std::vector<Rgb>& values) {
    for (const Rgb& v : values) largest_ = std::max(largest_, max_channel(v));
    codes_.reserve(values.size());
    for (const Rgb& v : values) codes_.push_back(Coding::encode(v, largest_));
  }

  bool empty() const { return codes_.empty(); }
  size_t size() const { return codes_.size(); }
  Rgb operator[](size_t i) const { return Coding::decode(codes_[i], largest_); }
  std::vector<Rgb> unpacked() const {
    std::vector<Rgb> values(size());
    for (size_t i = 0; i < values.size(); ++i) values[i] = (*this)[i];
    return values;
  }

 private:
  float largest_ = 0;
  std::vector<typename Coding::Code> codes_;
};

// 6 bytes per time sample: 16 bits per channel. The error is at most 1 / 131070 of the largest.
struct FineCoding {
  using Code = std::array<uint16_t, 3>;
  static Code encode(Rgb value, float largest) {
    const float unit = largest / 65535;
    const auto code = [&](float v) {
      return static_cast<uint16_t>(unit > 0 ? std::clamp(v / unit + 0.5f, 0.0f, 65535.0f) : 0.0f);
    };
    return {code(value.r), code(value.g), code(value.b)};
  }
  static Rgb decode(Code code, float largest) {
    const float unit = largest / 65535;
    return {unit * static_cast<float>(code[0]), unit * static_cast<float>(code[1]),
            unit * static_cast<float>(code[2])};
  }
};

// 4 bytes per time sample: 11 bits of red and green, 10 of blue. The error is at most 1 / 4094 of the
// largest, in blue 1 / 2046. For functions whose values are all of one order of magnitude, as those of
// indirect light.
struct CoarseCoding {
  using Code = uint32_t;
  static Code encode(Rgb value, float largest) {
    const float scale = largest > 0 ? 1 / largest : 0;
    const auto code = [&](float v, float most) {
      return static_cast<uint32_t>(std::clamp(v * scale * most + 0.5f, 0.0f, most));
    };
    return code(value.r, 2047) << 21 | code(value.g, 2047) << 10 | code(value.b, 1023);
  }
  static Rgb decode(Code code, float largest) {
    return {largest / 2047 * static_cast<float>(code >> 21),
            largest / 2047 * static_cast<float>(code >> 10 & 2047),
            largest / 1023 * static_cast<float>(code & 1023)};
  }
};

using FineFunction = ScaledFunction<FineCoding>;
using CoarseFunction = ScaledFunction<CoarseCoding>;

}  // namespace strad
