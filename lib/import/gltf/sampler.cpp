#include "import/gltf/sampler.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

using Values = std::array<double, 4>;

// The key at or before an instant, and how far it is to the next.
struct Place {
  size_t key = 0;
  double u = 0, span = 0;
};

Place place_of(const GltfChannel& channel, double time, Side side) {
  const auto& times = channel.times;
  const auto next = side == Side::kFrom ? std::upper_bound(times.begin(), times.end(), time)
                                        : std::lower_bound(times.begin(), times.end(), time);
  if (next == times.begin()) return {};
  const auto key = static_cast<size_t>(next - times.begin()) - 1;
  if (key + 1 == times.size()) return {key, 0, 0};
  const double span = times[key + 1] - times[key];
  return {key, (time - times[key]) / span, span};
}

const Values& value_of(const GltfChannel& channel, size_t key) {
  return channel.values[channel.interpolation == GltfInterpolation::kCubicSpline ? 3 * key + 1 : key];
}

// Cubic Hermite spline; tangents are per second.
Values spline_at(const GltfChannel& channel, const Place& at) {
  if (at.span == 0) return value_of(channel, at.key);
  const Values &a = channel.values[3 * at.key + 1], &b = channel.values[3 * at.key + 4];
  const Values &out = channel.values[3 * at.key + 2], &in = channel.values[3 * at.key + 3];
  const double u = at.u, u2 = u * u, u3 = u2 * u;
  Values result{};
  for (size_t c = 0; c < 4; ++c)
    result[c] = (2 * u3 - 3 * u2 + 1) * a[c] + at.span * (u3 - 2 * u2 + u) * out[c] +
                (-2 * u3 + 3 * u2) * b[c] + at.span * (u3 - u2) * in[c];
  return result;
}

Quat quat_of(const Values& v) {
  const double norm = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
  if (!(norm > 0)) return {};
  return {v[3] / norm, v[0] / norm, v[1] / norm, v[2] / norm};
}

Quat slerp(Quat a, Quat b, double u) {
  const Quat step = conjugate(a) * b;
  const Vec3 v{step.x, step.y, step.z};
  const double sine = length(v);
  if (!(sine > 0)) return a;
  // The shorter way: of both quaternions of the rotation the one with w >= 0.
  const double sign = step.w < 0 ? -1 : 1;
  const double angle = 2 * std::atan2(sine, sign * step.w);
  return a * rotation_about(sign / sine * v, u * angle);
}

}  // namespace

Vec3 vector_at(const GltfChannel& channel, double time, Side side) {
  const Place at = place_of(channel, time, side);
  if (channel.interpolation == GltfInterpolation::kCubicSpline) {
    const Values v = spline_at(channel, at);
    return {v[0], v[1], v[2]};
  }
  const Values& a = value_of(channel, at.key);
  const Vec3 first{a[0], a[1], a[2]};
  if (channel.interpolation == GltfInterpolation::kStep || at.span == 0) return first;
  const Values& b = value_of(channel, at.key + 1);
  return lerp(first, Vec3{b[0], b[1], b[2]}, at.u);
}

Quat rotation_at(const GltfChannel& channel, double time, Side side) {
  const Place at = place_of(channel, time, side);
  if (channel.interpolation == GltfInterpolation::kCubicSpline) return quat_of(spline_at(channel, at));
  const Quat first = quat_of(value_of(channel, at.key));
  if (channel.interpolation == GltfInterpolation::kStep || at.span == 0) return first;
  return slerp(first, quat_of(value_of(channel, at.key + 1)), at.u);
}

bool is_constant(const GltfChannel& channel) {
  const bool spline = channel.interpolation == GltfInterpolation::kCubicSpline;
  const Values& first = value_of(channel, 0);
  double size = 0;
  for (const double c : first) size = std::max(size, std::abs(c));
  for (size_t i = 0; i < channel.values.size(); ++i) {
    const bool is_tangent = spline && i % 3 != 1;
    for (size_t c = 0; c < 4; ++c) {
      const double rest = channel.values[i][c] - (is_tangent ? 0 : first[c]);
      if (!(std::abs(rest) <= 1e-6 * size)) return false;
    }
  }
  return true;
}

}  // namespace strad
