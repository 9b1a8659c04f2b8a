// Tells the noise of rays from light.
//
// A function of time is compared to the mean of the functions around it, which it would equal if light varied
// linearly. The median of these differences over all vertices is taken for noise.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rgb.h"

namespace strad {

constexpr int kSweeps = 2;  // each removes about half of the noise

// Root mean square of `difference` over all time samples, relative to that of `own`.
inline double relative_rms(const std::vector<Rgb>& difference, const std::vector<Rgb>& own) {
  const auto sum_of_squares = [](const std::vector<Rgb>& values) {
    double sum = 0;
    for (const Rgb& c : values) sum += double{c.r} * c.r + double{c.g} * c.g + double{c.b} * c.b;
    return sum;
  };
  const double all = sum_of_squares(own);
  return all > 0 ? std::sqrt(sum_of_squares(difference) / all) : 0;
}

// The median, or 0 of no values. Changes the order of the values.
inline double median_of(std::vector<double>* values) {
  if (values->empty()) return 0;
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

// The share of a difference that is taken for noise: 1 up to the usual difference, falling to 0 at three
// times that.
inline float share_of_noise(double difference, double usual) {
  constexpr double kLight = 3;
  return usual > 0 ? static_cast<float>(std::clamp((kLight - difference / usual) / (kLight - 1), 0.0, 1.0))
                   : 0;
}

}  // namespace strad
