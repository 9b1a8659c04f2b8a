// The sRGB transfer curve (IEC 61966-2-1), for pictures of 8 or 16 bits only.
#pragma once

#include <cmath>
#include <cstdint>

namespace strad {

inline float srgb_from_linear(float linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 1;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

inline float linear_from_srgb(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

// Clamped to 0..255; NaN gives 0.
inline uint8_t srgb_byte(float linear) { return static_cast<uint8_t>(255 * srgb_from_linear(linear) + 0.5f); }
inline uint16_t srgb_word(float linear) {
  return static_cast<uint16_t>(65535 * srgb_from_linear(linear) + 0.5f);
}
inline float linear_from_byte(uint8_t srgb) { return linear_from_srgb(static_cast<float>(srgb) / 255); }

}  // namespace strad
