// Squared errors without the noise of the estimates, and intervals that hold the truth as often as they say.
#include "frame/error_estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

Rgb grey(double value) {
  const auto v = static_cast<float>(value);
  return {v, v, v};
}

// Uniform in [-1, 1): variance 1/3.
double noise(uint64_t a, uint64_t b, uint64_t c) { return 2 * unit_from(hash_of(a, b, c)) - 1; }

TEST(ErrorEstimate, SquaredErrorIsTheMeanOverPairs) {
  // Differences -1, -2, -3: pairs (2 + 3 + 6) / 3. The mean of the estimates is 2, its deviation sqrt(1 / 3).
  const Rgb estimates[] = {grey(1), grey(2), grey(3)};
  const PointError point = point_error({}, estimates, 5);
  EXPECT_NEAR(point.squared, 11 / 3.0, 1e-12);
  EXPECT_NEAR(point.reference, 2, 1e-12);
  EXPECT_NEAR(point.deviation, std::sqrt(1 / 3.0), 1e-12);
  EXPECT_EQ(point.weight, 5);
  EXPECT_NEAR(sure_error(point), 2 - 3 * std::sqrt(1 / 3.0), 1e-12);
  EXPECT_EQ(sure_error(point_error(grey(3.7), estimates, 1)), 0);  // 1.7 < 1.73: noise explains it
  EXPECT_NEAR(sure_error(point_error(grey(12), estimates, 1)), 10 - 3 * std::sqrt(1 / 3.0), 1e-12);
}

TEST(ErrorEstimate, OneBrightPathAddsNoSquaredError) {
  const Rgb estimates[] = {grey(1), grey(1), grey(1001), grey(1)};
  EXPECT_EQ(point_error(grey(1), estimates, 1).squared, 0);
}

TEST(ErrorEstimate, NoiseOfTheEstimatesIsTakenOut) {
  // e = 0.1 at all points, noise of variance s = 1/3 in each of K = 4 estimates and 3 channels. The variance
  // of a channel's squared error is 4 e^2 s / K + 2 s^2 / (K (K - 1)) = 0.0219; of the mean over 3 channels
  // of 20000 points 3.6e-7: four deviations are 0.0024. The plain square would be e^2 + s / K = 0.093.
  std::vector<PointError> points;
  for (uint64_t i = 0; i < 20000; ++i) {
    Rgb estimates[4];
    for (uint64_t k = 0; k < 4; ++k)
      for (uint64_t c = 0; c < 3; ++c)
        estimates[k][static_cast<int>(c)] = static_cast<float>(2 + noise(i, k, c));
    points.push_back(point_error(grey(2.1), estimates, 1));
  }
  const ErrorEstimate estimate = estimate_error(points);
  EXPECT_NEAR(estimate.squared / 20000, 0.01, 0.0024);
  EXPECT_NEAR(estimate.mean, 2, 0.01);
  EXPECT_LE(estimate.rel.low, 0.05);  // 0.1 / 2
  EXPECT_GE(estimate.rel.high, 0.05);
}

TEST(ErrorEstimate, WeightsCount) {
  // Without noise: radiance 1 with weight 3 and 3 with weight 1, both 10 % too bright. Mean 1.5, mean squared
  // error 0.01 (3 * 1 + 1 * 9) / 4 = 0.03.
  const Rgb one[] = {grey(1), grey(1)}, three[] = {grey(3), grey(3)};
  const ErrorEstimate estimate =
      estimate_error({point_error(grey(1.1), one, 3), point_error(grey(3.3), three, 1)});
  EXPECT_NEAR(estimate.mean, 1.5, 1e-6);
  EXPECT_NEAR(estimate.rel.value, std::sqrt(0.03) / 1.5, 1e-6);
  EXPECT_NEAR(estimate.bias.value, 0.1, 1e-6);
  EXPECT_NEAR(estimate.bias.low, 0.1, 1e-6);  // in any resample
  EXPECT_NEAR(estimate.bias.high, 0.1, 1e-6);
}

TEST(ErrorEstimate, IntervalHoldsTheTruth) {
  // Errors uniform in [-0.3, 0.3] about radiance 1: the mean square is 0.03. Of 200 trials 190 should hold
  // it, with a deviation of 3.1; the bootstrap's intervals are a little short at 100 points.
  int held = 0;
  for (uint64_t trial = 0; trial < 200; ++trial) {
    std::vector<PointError> points;
    for (uint64_t i = 0; i < 100; ++i) {
      const uint64_t key = hash_of(trial, i);
      Rgb estimates[4];
      for (uint64_t k = 0; k < 4; ++k) estimates[k] = grey(1 + 0.2 * noise(key, k, 1));
      points.push_back(point_error(grey(1 + 0.3 * noise(key, 0, 2)), estimates, 1));
    }
    const Confidence rel = estimate_error(points).rel;
    held += rel.low <= std::sqrt(0.03) && std::sqrt(0.03) <= rel.high;
  }
  EXPECT_GE(held, 176);
  EXPECT_LE(held, 199);
}

TEST(ErrorEstimate, NoPointsAndNoLight) {
  EXPECT_EQ(estimate_error({}).rel.value, 0);
  const Rgb dark[] = {Rgb{}, Rgb{}};
  EXPECT_EQ(estimate_error({point_error(grey(1), dark, 1)}).rel.high, 0);
}

}  // namespace
}  // namespace strad
