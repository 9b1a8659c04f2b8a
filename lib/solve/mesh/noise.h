// How the noise of rays is told from light: by how much functions of time usually differ from the mean of
// those around them, which is what light that varies linearly would be.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rgb.h"

namespace strad {

constexpr int kSweeps = 2;  // each takes out about half

// Rms of `difference` over all time samples in terms of that of `own`.
inline double relative_rms(const std::vector<Rgb>& difference, const std::vector<Rgb>& own) {
  const auto sum_of_squares = [](const std::vector<Rgb>& values) {
    double sum = 0;
    for (const Rgb& c : values) sum += double{c.r} * c.r + double{c.g} * c.g + double{c.b} * c.b;
    return sum;
  };
  const double all = sum_of_squares(own);
  return all > 0 ? std::sqrt(sum_of_squares(difference) / all) : 0;
}

// The median, 0 of none. Changes the order.
inline double median_of(std::vector<double>* values) {
  if (values->empty()) return 0;
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

// How much of a difference to take for noise: all up to the usual one, nothing from three times that on.
inline float share_of_noise(double difference, double usual) {
  constexpr double kLight = 3;
  return usual > 0 ? static_cast<float>(std::clamp((kLight - difference / usual) / (kLight - 1), 0.0, 1.0))
                   : 0;
}

}  // namespace strad
