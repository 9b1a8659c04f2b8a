#include "frame/penumbra.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// Variance of the visible fraction that n well-spread rays find: an edge cuts about n^(1/2) of the n cells
// that they stand for. In each of these a ray finds 0 or 1 in place of a fraction. So the variance falls as
// n^(-3/2).
// Measured in penumbrae of rectangles where half is visible.
constexpr double kVariance = 0.12;
// It is less where more or less than half is visible, but not less than this part.
constexpr double kLeastVariance = 0.2;

// By size of the window, from the widest: the fit of a plane is used in full where its residual is less than
// `full` times that variance, and not at all where it is more than `none` times. Residuals over smaller
// windows are less certain, so their limits are wider.
struct ResidualLimits {
  double full, none;
};
constexpr ResidualLimits kLimits[kReach] = {{1.5, 3}, {2, 5}, {4, 10}};

// A plane through fractions: its value in the middle of the window, and the mean square of what is off it.
struct PlaneFit {
  double middle = 0, residual = 0;
};

// Weighted sums over corners; x and y from the middle of the window, f the fraction.
struct Moments {
  double w = 0, x = 0, y = 0, f = 0, xx = 0, xy = 0, yy = 0, xf = 0, yf = 0, ff = 0;

  void add(double weight, double at_x, double at_y, double fraction) {
    const double wx = weight * at_x, wy = weight * at_y, wf = weight * fraction;
    w += weight, x += wx, y += wy, f += wf;
    xx += wx * at_x, xy += wx * at_y, yy += wy * at_y;
    xf += wf * at_x, yf += wf * at_y, ff += wf * fraction;
  }
};

// Least squares about the centroid. Corners that lie on a line, or none but one, have a mean only.
PlaneFit plane_of(const Moments& m) {
  if (!(m.w > 0)) return {};
  const double x = m.x / m.w, y = m.y / m.w, f = m.f / m.w;
  const double xx = m.xx / m.w - x * x, xy = m.xy / m.w - x * y, yy = m.yy / m.w - y * y;
  const double xf = m.xf / m.w - x * f, yf = m.yf / m.w - y * f, ff = m.ff / m.w - f * f;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-6)) return {f, std::max(0.0, ff)};
  const double along_x = (yy * xf - xy * yf) / determinant, along_y = (xx * yf - xy * xf) / determinant;
  return {std::clamp(f - along_x * x - along_y * y, 0.0, 1.0),
          std::max(0.0, ff - along_x * xf - along_y * yf)};
}

// Over the pixel's corners and `reach` more on each side. Weights fall to the sides, so that no corner shows
// where the window ends.
PlaneFit fit_plane(const PenumbraWindow& window, int reach) {
  Moments moments;
  const double width = reach + 1.5;
  const auto weight = [&](double x) { return 1 - x * x / (width * width); };
  for (int v = kReach - reach; v < kReach + reach + 2; ++v) {
    for (int u = kReach - reach; u < kReach + reach + 2; ++u) {
      const auto at = static_cast<size_t>(v * kWindow + u);
      if (!window.known[at]) continue;
      const double x = u - kReach - 0.5, y = v - kReach - 0.5;
      moments.add(weight(x) * weight(y), x, y, static_cast<double>(window.fraction[at]));
    }
  }
  return plane_of(moments);
}

double expected_variance(double fraction, uint32_t rays) {
  return kVariance * std::pow(rays, -1.5) * std::max(kLeastVariance, 4 * fraction * (1 - fraction));
}

}  // namespace

float smooth_fraction(const PenumbraWindow& window, uint32_t rays) {
  double value = 0, left = 1;
  for (int k = 0; k < kReach && left > 0; ++k) {
    const PlaneFit fit = fit_plane(window, kReach - k);
    const double off = fit.residual / expected_variance(fit.middle, rays);
    const double share =
        left * std::clamp((kLimits[k].none - off) / (kLimits[k].none - kLimits[k].full), 0.0, 1.0);
    value += share * fit.middle;
    left -= share;
  }
  if (left > 0) value += left * fit_plane(window, 0).middle;
  return static_cast<float>(value);
}

}  // namespace strad
