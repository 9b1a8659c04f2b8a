// The visible fraction of a lamp over a pixel from noisy fractions at the corners around it.
#pragma once

#include <array>
#include <cstdint>

namespace strad {

constexpr int kReach = 3;                  // corners around a pixel's own four
constexpr int kWindow = 2 * (kReach + 1);  // corners a side, the pixel in the middle

// Visible fractions at corners, row by row.
struct PenumbraWindow {
  std::array<float, kWindow * kWindow> fraction;
  std::array<bool, kWindow * kWindow> known;  // on the pixel's surface, with at least one shadow ray
};

// In [0, 1]: the mean over the widest part of the window over which the fractions are a plane but for the
// noise of `rays` shadow rays at each corner.
float smooth_fraction(const PenumbraWindow& window, uint32_t rays);

}  // namespace strad
