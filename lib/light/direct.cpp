#include "light/direct.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

// Corners of the part of the polygon above the horizon of `point`, relative to it; at most one corner more.
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

struct EmitterAtInstant {
  std::array<Vec3, 4> corners;
  int count;
  Vec3 normal;
};

EmitterAtInstant emitter_at(const Scene& scene, const Polygon& polygon, const Instant& instant) {
  EmitterAtInstant e;
  e.count = polygon.corner_count();
  const Pose& pose = instant.world_from_body[body_of(scene, polygon)];
  for (int c = 0; c < e.count; ++c) e.corners[c] = pose * scene.vertices[polygon.corners[c]];
  e.normal = normalized(cross(e.corners[1] - e.corners[0], e.corners[2] - e.corners[0]));
  return e;
}

// Maps the unit square onto the polygon: bilinearly, or by folding onto a triangle.
Vec3 point_on(const EmitterAtInstant& e, double u, double v) {
  if (e.count == 4) return lerp(lerp(e.corners[0], e.corners[1], u), lerp(e.corners[3], e.corners[2], u), v);
  const double root = std::sqrt(u);  // uniform by area (Turk 1990)
  return (1 - root) * e.corners[0] + root * (1 - v) * e.corners[1] + root * v * e.corners[2];
}

}  // namespace

Instant instant_at(const Scene& scene, double time) {
  Instant instant;
  instant.time = time;
  instant.world_from_body = poses_at(scene, time);
  for (const Spot& spot : scene.spots)
    instant.spots.push_back(spot_at(scene, spot, instant.world_from_body, time));
  instant.glow = glow_at(scene, time);
  return instant;
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

double spot_falloff(const Spot& spot, double cos_theta) {
  const double low = std::cos(spot.outer), high = std::cos(spot.inner);
  if (!(cos_theta > low)) return 0;
  if (cos_theta >= high) return 1;
  const double s = (cos_theta - low) / (high - low);
  return s * s * (3 - 2 * s);
}

DirectLight::DirectLight(const Scene& scene, const Tracer& tracer) : scene_(scene), tracer_(tracer) {
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    if (emits(scene, scene.polygons[p])) emitters_.push_back(p);
}

Rgb DirectLight::irradiance(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                            uint64_t* rays) const {
  uint64_t traced = 0;
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb sum;
  for (size_t s = 0; s < scene_.spots.size(); ++s) {
    const SpotState& spot = instant.spots[s];
    const Vec3 to_spot = spot.position - point.position;
    const double distance2 = length2(to_spot);
    const double cos_receiver = dot(to_spot, point.normal);  // times the distance
    if (!(cos_receiver > 0)) continue;
    const double distance = std::sqrt(distance2);
    const double falloff = spot_falloff(scene_.spots[s], -dot(to_spot, spot.direction) / distance);
    if (!(falloff > 0)) continue;
    ++traced;
    if (tracer_.occluded(instant.world_from_body, lifted, spot.position)) continue;
    sum += static_cast<float>(falloff * cos_receiver / (distance2 * distance)) * spot.intensity;
  }
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(samples))));
  for (const uint32_t p : emitters_) {
    const Polygon& polygon = scene_.polygons[p];
    const float glow = instant.glow[polygon.material];
    if (p == point.polygon || glow == 0) continue;
    const EmitterAtInstant e = emitter_at(scene_, polygon, instant);
    if (!(dot(point.position - e.corners[0], e.normal) > 0)) continue;  // behind its front
    const double unoccluded = unit_irradiance(point.position, point.normal, e.corners.data(), e.count);
    if (!(unoccluded > 0)) continue;
    double visible = 0, all = 0;
    for (int i = 0; i < side * side; ++i) {
      const uint64_t h = hash_of(seed, p, static_cast<uint64_t>(i));
      const double u = (i % side + unit_from(h)) / side, v = (i / side + unit_from(mix64(h))) / side;
      const Vec3 y = point_on(e, u, v);
      const Vec3 to_y = y - point.position;
      const double cos_receiver = dot(to_y, point.normal), cos_emitter = -dot(to_y, e.normal);
      if (!(cos_receiver > 0) || !(cos_emitter > 0)) continue;
      const double distance2 = length2(to_y);
      const double weight = cos_receiver * cos_emitter / (distance2 * distance2);
      all += weight;
      ++traced;
      if (!tracer_.occluded(instant.world_from_body, lifted, y + tracer_.offset() * e.normal))
        visible += weight;
    }
    if (all > 0)
      sum +=
          static_cast<float>(unoccluded * glow * visible / all) * scene_.materials[polygon.material].emission;
  }
  if (rays) *rays += traced;
  return sum;
}

}  // namespace strad
