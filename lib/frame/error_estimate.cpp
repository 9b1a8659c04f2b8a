#include "frame/error_estimate.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

constexpr int kResamples = 1000;
// The mean of 16 estimates is off by more once in 100 points (Student's distribution).
constexpr double kSureDeviations = 3;

struct Sums {
  double weight = 0, solution = 0, reference = 0, squared = 0;

  void add(const PointError& point) {
    weight += point.weight;
    solution += point.weight * point.solution;
    reference += point.weight * point.reference;
    squared += point.weight * point.squared;
  }
  // Over the squared mean.
  double rel_squared() const { return reference > 0 ? squared * weight / (reference * reference) : 0; }
  double bias() const { return reference > 0 ? solution / reference - 1 : 0; }
};

double positive_root(double square) { return square > 0 ? std::sqrt(square) : 0; }

Confidence interval_of(double value, std::vector<double>* resampled) {
  std::sort(resampled->begin(), resampled->end());
  const auto last = static_cast<double>(resampled->size() - 1);
  const auto at = [&](double fraction) {
    return (*resampled)[static_cast<size_t>(std::lround(fraction * last))];
  };
  return {value, at(0.025), at(0.975)};
}

}  // namespace

PointError point_error(Rgb solution, std::span<const Rgb> estimates, double weight) {
  const auto count = static_cast<double>(estimates.size()), pairs = count * (count - 1);
  PointError point;
  point.weight = weight;
  for (int c = 0; c < 3; ++c) {
    double sum = 0, squares = 0;
    for (const Rgb& estimate : estimates) {
      const double difference = double{solution[c]} - double{estimate[c]};
      sum += difference;
      squares += difference * difference;
    }
    point.solution += solution[c] / 3.0;
    point.reference += (solution[c] - sum / count) / 3;
    point.squared += (sum * sum - squares) / pairs / 3;
  }
  double scatter = 0;
  for (const Rgb& estimate : estimates) {
    const double off = (double{estimate.r} + double{estimate.g} + double{estimate.b}) / 3 - point.reference;
    scatter += off * off;
  }
  point.deviation = std::sqrt(scatter / pairs);
  return point;
}

double sure_error(const PointError& point) {
  return std::max(0.0, std::abs(point.solution - point.reference) - kSureDeviations * point.deviation);
}

ErrorEstimate estimate_error(const std::vector<PointError>& points) {
  ErrorEstimate estimate;
  estimate.points = points.size();
  if (points.empty()) return estimate;
  Sums all;
  for (const PointError& point : points) all.add(point);
  estimate.mean = all.weight > 0 ? all.reference / all.weight : 0;
  estimate.squared = all.squared;
  std::vector<double> rel, bias;
  for (uint64_t resample = 0; resample < kResamples; ++resample) {
    Sums sums;
    for (size_t i = 0; i < points.size(); ++i) {
      const double at = unit_from(hash_of(resample, i)) * static_cast<double>(points.size());
      sums.add(points[static_cast<size_t>(at)]);
    }
    rel.push_back(positive_root(sums.rel_squared()));
    bias.push_back(sums.bias());
  }
  estimate.rel = interval_of(positive_root(all.rel_squared()), &rel);
  estimate.bias = interval_of(all.bias(), &bias);
  return estimate;
}

}  // namespace strad
