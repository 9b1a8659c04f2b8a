// Linear RGB, Rec. 709 primaries, scene-referred.
#pragma once

#include <algorithm>
#include <cmath>

namespace strad {

struct Rgb {
  float r = 0, g = 0, b = 0;
  float& operator[](int channel) { return channel == 0 ? r : channel == 1 ? g : b; }
  float operator[](int channel) const { return channel == 0 ? r : channel == 1 ? g : b; }
  bool operator==(const Rgb&) const = default;
};

inline Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
inline Rgb operator-(Rgb a, Rgb b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
inline Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
inline Rgb operator*(float s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }
inline Rgb operator*(Rgb a, float s) { return s * a; }
inline Rgb& operator+=(Rgb& a, Rgb b) { return a = a + b; }

// Rec. 709 luminance.
inline float luminance(Rgb a) { return 0.2126f * a.r + 0.7152f * a.g + 0.0722f * a.b; }
inline float mean_channel(Rgb a) { return (a.r + a.g + a.b) / 3; }
inline float max_channel(Rgb a) { return std::max(a.r, std::max(a.g, a.b)); }
inline bool is_black(Rgb a) { return a.r == 0 && a.g == 0 && a.b == 0; }
inline bool is_finite(Rgb a) { return std::isfinite(a.r) && std::isfinite(a.g) && std::isfinite(a.b); }

}  // namespace strad
