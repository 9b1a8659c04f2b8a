// Visible fractions of lamps from noisy ones around a pixel.
#include "frame/penumbra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "base/rng.h"
#include "frame/corners.h"
#include "frame/sobol.h"

namespace strad {
namespace {

// `value` of the place relative to the pixel's middle, in pixels.
PenumbraWindow window_of(const std::function<double(double, double)>& value) {
  PenumbraWindow window;
  for (int v = 0; v < kWindow; ++v) {
    for (int u = 0; u < kWindow; ++u) {
      const auto at = static_cast<size_t>(v * kWindow + u);
      window.fraction[at] = static_cast<float>(value(u - kReach - 0.5, v - kReach - 0.5));
      window.known[at] = true;
    }
  }
  return window;
}

// The middle of a plane is its value there, also where the window is cut off on one side, as by a wall.
TEST(Penumbra, PlanesAreKept) {
  PenumbraWindow window = window_of([](double x, double y) { return 0.4 + 0.05 * x - 0.02 * y; });
  EXPECT_NEAR(smooth_fraction(window, 32), 0.4, 1e-6);
  for (size_t i = 0; i < window.known.size(); ++i) window.known[i] = i % kWindow < 5;
  EXPECT_NEAR(smooth_fraction(window, 32), 0.4, 1e-6);
  window.known.fill(false);
  window.known[0] = window.known[3 * kWindow + 3] = true;
  window.fraction[0] = 0.4f, window.fraction[3 * kWindow + 3] = 0.4f;
  EXPECT_NEAR(smooth_fraction(window, 32), 0.4, 1e-6);
}

// Noise of about the deviation of 32 rays, (0.12 * 32^-1.5)^(1/2) = 0.026, evenly distributed: over 64
// corners whose weights are nearly even its mean deviates by about 0.026 / 8 = 0.003; 5 deviations are
// allowed.
TEST(Penumbra, NoiseIsAveraged) {
  for (uint64_t trial = 0; trial < 20; ++trial) {
    uint64_t draw = 0;
    const PenumbraWindow window = window_of([&](double x, double) {
      return 0.5 + 0.02 * x + 0.026 * std::sqrt(12.0) * (unit_from(hash_of(trial, ++draw)) - 0.5);
    });
    EXPECT_NEAR(smooth_fraction(window, 32), 0.5, 0.016) << trial;
  }
}

// A sharp edge one pixel away is none in the pixel.
TEST(Penumbra, EdgesAreNotBlurred) {
  const PenumbraWindow window = window_of([](double x, double) { return x > 1 ? 1.0 : 0.0; });
  EXPECT_NEAR(smooth_fraction(window, 32), 0, 1e-6);
}

// With ever more rays noise is no excuse: the plane's residual of a parabola asks for the smallest window,
// whose mean is 0.5 + 0.01 / 4.
TEST(Penumbra, MoreRaysTrustMore) {
  const PenumbraWindow window = window_of([](double x, double) { return 0.5 + 0.01 * x * x; });
  EXPECT_NEAR(smooth_fraction(window, 1 << 20), 0.5025, 1e-6);
}

// The points of blocks of corners at multiples of their size are one stretch of the sequence: each is there
// once, also at negative places, which margins reach.
TEST(Penumbra, BlocksOfCornersUseEachPointOnce) {
  for (const int side : {2, 4, 8, 16, 32}) {
    std::set<uint32_t> firsts;
    uint64_t scramble = corner_points(-32, 64, 4).scramble;
    for (int y = 64; y < 64 + side; ++y) {
      for (int x = -32; x < -32 + side; ++x) {
        const ShadowPoints points = corner_points(x, y, 4);
        EXPECT_EQ(points.scramble, scramble);
        firsts.insert(points.first);
      }
    }
    const uint32_t count = static_cast<uint32_t>(side * side);
    ASSERT_EQ(firsts.size(), count);
    EXPECT_EQ(*firsts.begin() % (4 * count), 0u);
    EXPECT_EQ(*firsts.rbegin() - *firsts.begin(), 4 * (count - 1));
  }
}

// Owen's scrambling keeps the (0, 2)-property: 256 points from a multiple of 256 on fill each of 2^a x 2^(8 -
// a) cells once.
TEST(Penumbra, ScrambledPointsFillAllCells) {
  for (const uint32_t first : {0u, 256u, 5u * 256u}) {
    for (int a = 0; a <= 8; ++a) {
      OwenSequence sequence(first, hash_of(first, 3));
      std::set<std::pair<int, int>> cells;
      for (int i = 0; i < 256; ++i) {
        const Point2 at = sequence.next();
        cells.emplace(static_cast<int>(at.u * (1 << a)), static_cast<int>(at.v * (1 << (8 - a))));
      }
      EXPECT_EQ(cells.size(), 256u) << first << " " << a;
    }
  }
}

}  // namespace
}  // namespace strad
