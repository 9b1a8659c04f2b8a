#include "light/emitter.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// Clips the polygon to the horizon of `point` (Sutherland & Hodgman 1974). The corners of the part above are
// relative to it; there is at most one more than before.
int clip_to_horizon(Vec3 point, Vec3 normal, const Vec3* corners, int count, Vec3* clipped) {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 a = corners[i] - point, b = corners[(i + 1) % count] - point;
    const double ha = dot(a, normal), hb = dot(b, normal);
    if (ha > 0) clipped[kept++] = a;
    if ((ha > 0) != (hb > 0)) clipped[kept++] = lerp(a, b, ha / (ha - hb));
  }
  return kept;
}

// Angles whose cosine is no further from 1 than this have their sine by a power series.
constexpr double kSmallVersine = 0.002;

// angle / sin(angle) from x = 1 - cos(angle): f satisfies x (2 - x) f' = 1 - (1 - x) f, so the coefficients
// are a[n] = a[n - 1] n / (2 n + 1) from a[0] = 1. Each term is less than x / 2 of the one before.
double angle_over_sine(double x) {
  return 1 + (1 / 3.0) * x * (1 + (2 / 5.0) * x * (1 + (3 / 7.0) * x * (1 + (4 / 9.0) * x)));
}

}  // namespace

Emitter emitter_at(const Scene& scene, uint32_t p, const std::vector<Pose>& world_from_body) {
  const Polygon& polygon = scene.polygons[p];
  const Pose& pose = world_from_body[body_of(scene, polygon)];
  Emitter e;
  e.polygon = p;
  e.count = polygon.corner_count();
  auto& c = e.corners;
  for (int i = 0; i < e.count; ++i) {
    c[i] = pose * scene.vertices[polygon.corners[i]];
    e.centre += c[i] / e.count;
  }
  const Vec3 doubled = e.count == 4 ? cross(c[2] - c[0], c[3] - c[1]) : cross(c[1] - c[0], c[2] - c[0]);
  e.area = length(doubled) / 2;
  e.normal = normalized(doubled);
  const double skew2 = length2((c[0] - c[1]) + (c[2] - c[3]));
  e.parallelogram = e.count == 4 && skew2 <= 1e-18 * length2(c[2] - c[0]);
  return e;
}

Vec3 point_on(const Emitter& emitter, double u, double v) {
  const auto& c = emitter.corners;
  if (emitter.count == 4) return lerp(lerp(c[0], c[1], u), lerp(c[3], c[2], u), v);
  const double root = std::sqrt(u);
  return (1 - root) * c[0] + root * (1 - v) * c[1] + root * v * c[2];
}

double stretch_at(const Emitter& emitter, double u, double v) {
  if (emitter.parallelogram || emitter.count == 3) return 1;
  const auto& c = emitter.corners;
  const Vec3 along_u = lerp(c[1] - c[0], c[2] - c[3], v), along_v = lerp(c[3] - c[0], c[2] - c[1], u);
  return length(cross(along_u, along_v)) / emitter.area;
}

double point_irradiance(const Emitter& emitter, Vec3 on_emitter, const SurfacePoint& point) {
  const Vec3 to = on_emitter - point.position;
  const double cos_receiver = dot(to, point.normal),
               cos_emitter = -dot(to, emitter.normal);  // times distance
  if (!(cos_receiver > 0) || !(cos_emitter > 0)) return 0;
  const double distance2 = length2(to);
  return cos_receiver * cos_emitter * emitter.area / (distance2 * distance2);
}

bool is_before(const Emitter& emitter, Vec3 point) {
  return dot(point - emitter.corners[0], emitter.normal) > 0;
}

double edge_irradiance(Vec3 a, Vec3 b, Vec3 normal) {
  const Vec3 across = cross(a, b);
  const double cosine = dot(a, b), lengths2 = length2(a) * length2(b);
  if (!(lengths2 > 0)) return 0;
  const double scale = 1 / std::sqrt(lengths2), versine = 1 - cosine * scale;
  if (versine < kSmallVersine) return angle_over_sine(versine) * dot(across, normal) * scale;
  const double sine = length(across);
  return sine * scale > 1e-12 ? std::atan2(sine, cosine) * dot(across, normal) / sine : 0;
}

double unit_irradiance(Vec3 point, Vec3 normal, const Vec3* corners, int count) {
  Vec3 v[8];
  count = clip_to_horizon(point, normal, corners, count, v);
  if (count < 3) return 0;
  for (int i = 0; i < count; ++i) v[i] = normalized(v[i]);
  Vec3 sum;
  for (int i = 0; i < count; ++i) {
    const Vec3 c = cross(v[i], v[(i + 1) % count]);
    const double sine = length(c);
    if (!(sine > 1e-12)) continue;
    sum += (std::atan2(sine, dot(v[i], v[(i + 1) % count])) / sine) * c;
  }
  return std::clamp(0.5 * std::abs(dot(sum, normal)), 0.0, kPi);
}

}  // namespace strad
