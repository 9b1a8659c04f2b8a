// The error of a solution from unbiased but noisy estimates of the light at some points: its square without
// the noise, and how sure it is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/rgb.h"

namespace strad {

// Solution and estimates at one point; means over the three channels, W / (sr m^2).
struct PointError {
  double weight = 1;
  double solution = 0;
  double reference = 0;  // the mean of the estimates
  double deviation = 0;  // the standard deviation of `reference`
  double squared = 0;    // an unbiased estimate of the squared error, negative where noise outweighs it
};

// The mean of (S - A)(S - B) over all pairs A, B of different estimates, which are independent: its
// expectation is the squared error of S, whatever their noise. REQUIRES: at least two estimates.
PointError point_error(Rgb solution, std::span<const Rgb> estimates, double weight);

// The error that is surely there: |solution - reference| less what noise explains, three deviations of
// it.
double sure_error(const PointError& point);

// A value and the ends of its 95 % confidence interval.
struct Confidence {
  double value = 0, low = 0, high = 0;
};

struct ErrorEstimate {
  size_t points = 0;
  double mean = 0;     // of the reference, W / (sr m^2)
  double squared = 0;  // the weighted sum of the squared errors
  Confidence rel;      // root of the mean squared error over the mean, 0 where its square is negative
  Confidence bias;     // mean of the solution over the mean, less 1
};

// Intervals by the bootstrap over points (Efron 1979), which asks nothing of their distribution; the same for
// the same points. All zero where the reference is.
ErrorEstimate estimate_error(const std::vector<PointError>& points);

}  // namespace strad
