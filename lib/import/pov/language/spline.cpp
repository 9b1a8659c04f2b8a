#include "import/pov/language/spline.h"

#include <algorithm>

#include "base/text.h"

namespace strad {
namespace {

using Points = std::vector<std::pair<double, PovNumbers>>;

// Of one part of the vectors.
double value(const Points& p, size_t i, int part) { return p[i].second[part]; }
double slope(const Points& p, size_t i, int part) {
  return (value(p, i + 1, part) - value(p, i, part)) / (p[i + 1].first - p[i].first);
}

double linear(const Points& p, size_t i, double time, int part) {
  return value(p, i, part) + slope(p, i, part) * (time - p[i].first);
}

// The parabola through three points (Lagrange).
double quadratic(const Points& p, size_t i, double time, int part) {
  if (p.size() < 3) return linear(p, i, time, part);
  const size_t first = i == 0 ? 0 : i - 1;
  double sum = 0;
  for (size_t a = first; a < first + 3; ++a) {
    double weight = 1;
    for (size_t b = first; b < first + 3; ++b)
      if (b != a) weight *= (time - p[b].first) / (p[a].first - p[b].first);
    sum += weight * value(p, a, part);
  }
  return sum;
}

// Catmull & Rom 1974, for times that are not evenly spaced. The first and last points only give tangents.
double cubic(const Points& p, size_t i, double time, int part) {
  if (p.size() < 4) return linear(p, i, time, part);
  i = std::clamp<size_t>(i, 1, p.size() - 3);
  const double dt = p[i + 1].first - p[i].first;
  const double u = std::clamp((time - p[i].first) / dt, 0.0, 1.0);
  const double from = (slope(p, i - 1, part) + slope(p, i, part)) / 2 * dt;
  const double to = (slope(p, i, part) + slope(p, i + 1, part)) / 2 * dt;
  const double u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * value(p, i, part) + (3 * u2 - 2 * u3) * value(p, i + 1, part) +
         (u3 - 2 * u2 + u) * from + (u3 - u2) * to;
}

// The natural cubic spline: its second derivatives are 0 at the ends. They solve a tridiagonal system
// (Thomas's algorithm).
double natural(const Points& p, size_t i, double time, int part) {
  const size_t n = p.size();
  if (n < 3) return linear(p, i, time, part);
  std::vector<double> bend(n, 0), above(n, 0);
  const auto gap = [&p](size_t k) { return p[k + 1].first - p[k].first; };
  for (size_t k = 1; k + 1 < n; ++k) {
    const double diagonal = 2 * (gap(k - 1) + gap(k)) - gap(k - 1) * above[k - 1];
    above[k] = gap(k) / diagonal;
    bend[k] = (6 * (slope(p, k, part) - slope(p, k - 1, part)) - gap(k - 1) * bend[k - 1]) / diagonal;
  }
  for (size_t k = n - 2; k > 0; --k) bend[k] -= above[k] * bend[k + 1];
  const double h = gap(i), a = (p[i + 1].first - time) / h, b = (time - p[i].first) / h;
  return a * value(p, i, part) + b * value(p, i + 1, part) +
         ((a * a * a - a) * bend[i] + (b * b * b - b) * bend[i + 1]) * h * h / 6;
}

}  // namespace

bool is_spline_type(std::string_view word) {
  return is_one_of(word, {"linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"});
}

PovNumbers spline_at(const PovSpline& spline, const std::string& type, double time) {
  const Points& p = spline.points;
  if (p.size() == 1 || time <= p.front().first)
    return type == "cubic_spline" && p.size() > 3 ? p[1].second : p.front().second;
  if (time >= p.back().first)
    return type == "cubic_spline" && p.size() > 3 ? p[p.size() - 2].second : p.back().second;
  size_t i = 0;
  while (i + 2 < p.size() && time >= p[i + 1].first) ++i;
  const auto between = type == "linear_spline"      ? linear
                       : type == "quadratic_spline" ? quadratic
                       : type == "cubic_spline"     ? cubic
                                                    : natural;
  PovNumbers result = p[i].second;
  for (int part = 0; part < result.size; ++part) result[part] = between(p, i, time, part);
  return result;
}

}  // namespace strad
