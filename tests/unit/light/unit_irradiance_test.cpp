// Lambert's formula and the falloff of spots against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/rng.h"
#include "light/emitter.h"
#include "light/spotlight.h"

namespace strad {
namespace {

using Corners = std::vector<Vec3>;

double irradiance(Vec3 point, Vec3 normal, const Corners& corners) {
  return unit_irradiance(point, normal, corners.data(), static_cast<int>(corners.size()));
}

// A rectangle parallel to the floor at height 1, one corner above the point, u by v: pi times the form factor
// G / (2 pi).
double above(double u, double v) {
  const double ru = std::sqrt(1 + u * u), rv = std::sqrt(1 + v * v);
  return 0.5 * (u / ru * std::atan(v / ru) + v / rv * std::atan(u / rv));
}

// A rectangle upright at distance c, from the middle to b at the side, from the floor up to a. Integrating
// z c / r^4 over it: (atan(b / c) - c / s atan(b / s)) / 2 with s^2 = c^2 + a^2.
double upright(double a, double b, double c) {
  const double s = std::sqrt(c * c + a * a);
  return 0.5 * (std::atan(b / c) - c / s * std::atan(b / s));
}

const Vec3 kUp{0, 0, 1};

TEST(UnitIrradiance, ParallelRectangle) {
  for (const double u : {0.01, 0.5, 1.0, 3.0, 50.0})
    for (const double v : {0.01, 0.7, 2.0, 40.0}) {
      const Corners corners{{0, 0, 1}, {0, v, 1}, {u, v, 1}, {u, 0, 1}};
      EXPECT_NEAR(irradiance({0, 0, 0}, kUp, corners), above(u, v), 1e-9);
    }
}

TEST(UnitIrradiance, ParallelRectangleBesideThePoint) {
  // From 1 to 2 at one side: the difference of two with their corner above the point.
  const Corners corners{{1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}};
  EXPECT_NEAR(irradiance({0, 0, 0}, kUp, corners), above(2, 1) - above(1, 1), 1e-9);
}

TEST(UnitIrradiance, UprightRectangle) {
  for (const double a : {0.1, 1.0, 7.0})
    for (const double b : {0.3, 2.0})
      for (const double c : {0.2, 1.0, 4.0}) {
        const Corners corners{{0, c, 0}, {b, c, 0}, {b, c, a}, {0, c, a}};
        EXPECT_NEAR(irradiance({0, 0, 0}, kUp, corners), upright(a, b, c), 1e-9);
      }
}

TEST(UnitIrradiance, WhatLiesBelowTheHorizonDoesNotCount) {
  const Corners half{{0, 1, -2}, {1.5, 1, -2}, {1.5, 1, 0.8}, {0, 1, 0.8}};
  EXPECT_NEAR(irradiance({0, 0, 0}, kUp, half), upright(0.8, 1.5, 1), 1e-9);
  const Corners below{{0, 1, -2}, {1.5, 1, -2}, {1.5, 1, -0.1}, {0, 1, -0.1}};
  EXPECT_EQ(irradiance({0, 0, 0}, kUp, below), 0);
  // One corner above the horizon: the triangle that is left.
  const Corners triangle{{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}}, tip{{-0.5, 1, 0}, {0.5, 1, 0}, {0, 1, 1}};
  EXPECT_NEAR(irradiance({0, 0, 0}, kUp, triangle), irradiance({0, 0, 0}, kUp, tip), 1e-12);
}

TEST(UnitIrradiance, WindingDoesNotMatter) {
  const Corners one{{0, 0, 1}, {0, 2, 1}, {2, 2, 2}}, other{{2, 2, 2}, {0, 2, 1}, {0, 0, 1}};
  EXPECT_NEAR(irradiance({1, 0, 0}, kUp, one), irradiance({1, 0, 0}, kUp, other), 1e-12);
}

TEST(UnitIrradiance, APolygonIsTheSumOfItsParts) {
  const Corners whole{{-1, 0.5, -1}, {2, 1, -0.5}, {2, 2.5, 2}, {-1, 2, 1.5}};  // planar: a parallelogram
  const Vec3 point{0.3, 0, 0.2}, normal = normalized({0.2, 0.5, 1});
  double parts = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec3 middle = 0.25 * (whole[0] + whole[1] + whole[2] + whole[3]);
    parts += irradiance(point, normal, {whole[i], whole[(i + 1) % 4], middle});
  }
  EXPECT_NEAR(irradiance(point, normal, whole), parts, 1e-9);
}

TEST(UnitIrradiance, APlaneFillsTheView) {
  const double far = 1e6;
  const Corners plane{{-far, -far, 1}, {far, -far, 1}, {far, far, 1}, {-far, far, 1}};
  EXPECT_NEAR(irradiance({0, 0, 0}, kUp, plane), kPi, 1e-5);
}

// In a closed scene the form factors of a point add up to 1, wherever it is and however it is turned.
TEST(UnitIrradiance, TheWallsOfABoxAddUpToPi) {
  const auto corner = [](int i) { return Vec3{i & 1 ? 4.0 : 0, i & 2 ? 3.0 : 0, i & 4 ? 2.0 : 0}; };
  constexpr int kWalls[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                {1, 5, 7, 3}, {3, 7, 6, 2}, {2, 6, 4, 0}};
  for (uint64_t i = 0; i < 200; ++i) {
    const auto unit = [&](uint64_t k) { return unit_from(hash_of(i, k)); };
    const Vec3 point{0.01 + 3.98 * unit(0), 0.01 + 2.98 * unit(1), 0.01 + 1.98 * unit(2)};
    const Vec3 normal = normalized({unit(3) - 0.5, unit(4) - 0.5, unit(5) - 0.5});
    double sum = 0;
    for (const auto& wall : kWalls) {
      Corners corners;
      for (const int c : wall) corners.push_back(corner(c));
      sum += irradiance(point, normal, corners);
    }
    EXPECT_NEAR(sum, kPi, 1e-9);
  }
}

TEST(SpotFalloff, IsOneInsideAndZeroOutside) {
  Spot spot;
  spot.inner = 0.3, spot.outer = 0.5;
  EXPECT_EQ(spot_falloff(cone_of(spot), 1), 1);
  EXPECT_EQ(spot_falloff(cone_of(spot), std::cos(0.299)), 1);
  EXPECT_EQ(spot_falloff(cone_of(spot), std::cos(0.501)), 0);
  EXPECT_EQ(spot_falloff(cone_of(spot), -1), 0);
  EXPECT_NEAR(spot_falloff(cone_of(spot), 0.5 * (std::cos(0.3) + std::cos(0.5))), 0.5, 1e-12);
  EXPECT_NEAR(spot_falloff(cone_of(spot), 0.25 * std::cos(0.3) + 0.75 * std::cos(0.5)), 0.15625,
              1e-12);  // 3/16 - 2/64
}

// The smoothstep is point-symmetric about the middle of the two cosines, so a beam holds as much light as a
// sharp cone half-way between: 2 pi (1 - (cos inner + cos outer) / 2).
TEST(SpotFalloff, IntegratesToItsSolidAngle) {
  for (const double outer : {0.2, 0.9, 2.5}) {
    Spot spot;
    spot.inner = 0.6 * outer, spot.outer = outer;
    double sum = 0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i)
      sum += spot_falloff(cone_of(spot), -1 + 2 * (i + 0.5) / kSteps) * 2 / kSteps;
    EXPECT_NEAR(2 * kPi * sum, 2 * kPi * (1 - 0.5 * (std::cos(spot.inner) + std::cos(spot.outer))), 1e-4);
  }
}

TEST(SpotFalloff, AConeWithoutAnEdgeIsSharp) {
  Spot spot;
  spot.inner = spot.outer = 0.4;
  EXPECT_EQ(spot_falloff(cone_of(spot), std::cos(0.39)), 1);
  EXPECT_EQ(spot_falloff(cone_of(spot), std::cos(0.41)), 0);
}

}  // namespace
}  // namespace strad
