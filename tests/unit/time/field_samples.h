// Functions of time to sample, for tests of fields.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "time/field.h"

namespace strad {

using TimeFunction = std::function<double(double)>;

// Values at the nodes of a grid; the channels are f, f / 2 and 0.
inline std::vector<Rgb> samples_of(const TimeGrid& grid, const TimeFunction& f) {
  std::vector<Rgb> values;
  for (uint32_t n = 0; n < grid.sample_count(); ++n) {
    const auto y = static_cast<float>(f(sample_time(grid, n)));
    values.push_back({y, 0.5f * y, 0});
  }
  return values;
}

inline Field field_of(const TimeGrid& grid, const TimeFunction& f, float tolerance) {
  Field field;
  field.order = grid.order;
  append_row(grid, samples_of(grid, f), {}, tolerance, &field);
  return field;
}

}  // namespace strad
