#include "light/direct.h"

#include <algorithm>
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

// With more emitters than this above the horizon, those that give less than their share of all are faint.
constexpr int kFew = 48;

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
  const std::vector<bool> moving = moving_bodies(scene);
  const auto moves = [&](uint32_t p) { return moving[body_of(scene, scene.polygons[p])]; };
  std::stable_partition(emitters_.begin(), emitters_.end(), [&](uint32_t p) { return !moves(p); });
  const std::vector<Pose> poses = poses_at(scene, scene.start);
  for (const uint32_t p : emitters_)
    if (!moves(p)) still_.push_back(emitter_at(p, poses));
  for (const Spot& spot : scene.spots) cos_outer_.push_back(std::cos(spot.outer));
}

DirectLight::Emitter DirectLight::emitter_at(uint32_t p, const std::vector<Pose>& world_from_body) const {
  const Polygon& polygon = scene_.polygons[p];
  const Pose& pose = world_from_body[body_of(scene_, polygon)];
  Emitter e;
  e.count = polygon.corner_count();
  for (int c = 0; c < e.count; ++c) {
    e.corners[c] = pose * scene_.vertices[polygon.corners[c]];
    e.centre += e.corners[c] / e.count;
  }
  const Vec3 doubled = e.count == 4 ? cross(e.corners[2] - e.corners[0], e.corners[3] - e.corners[1])
                                    : cross(e.corners[1] - e.corners[0], e.corners[2] - e.corners[0]);
  e.area = length(doubled) / 2;
  e.normal = normalized(doubled);
  return e;
}

// The point at (u, v) of the unit square, which is mapped bilinearly or folded onto a triangle, as one of
// unit weight for all the area.
EmitterSample DirectLight::sample_at(const Emitter& e, const SurfacePoint& point, double u, double v) const {
  const double root = std::sqrt(u);  // uniform by area (Turk 1990)
  const Vec3 y = e.count == 4
                     ? lerp(lerp(e.corners[0], e.corners[1], u), lerp(e.corners[3], e.corners[2], u), v)
                     : (1 - root) * e.corners[0] + root * (1 - v) * e.corners[1] + root * v * e.corners[2];
  const Vec3 to = y - point.position;
  const double cos_receiver = dot(to, point.normal), cos_emitter = -dot(to, e.normal);
  if (!(cos_receiver > 0) || !(cos_emitter > 0)) return {};
  const double distance2 = length2(to);
  return {y + tracer_.offset() * e.normal,
          static_cast<float>(cos_receiver * cos_emitter * e.area / (distance2 * distance2)), 0};
}

Rgb DirectLight::spots(const Instant& instant, const SurfacePoint& point, uint64_t* rays) const {
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb sum;
  for (size_t s = 0; s < scene_.spots.size(); ++s) {
    const SpotState& spot = instant.spots[s];
    const Vec3 to_spot = spot.position - point.position;
    const double distance2 = length2(to_spot);
    const double cos_receiver = dot(to_spot, point.normal);  // times the distance
    if (!(cos_receiver > 0)) continue;
    const double distance = std::sqrt(distance2);
    const double cos_spot = -dot(to_spot, spot.direction) / distance;
    if (!(cos_spot > cos_outer_[s])) continue;
    const double falloff = spot_falloff(scene_.spots[s], cos_spot);
    if (!(falloff > 0)) continue;
    ++*rays;
    if (tracer_.occluded(instant.world_from_body, lifted, spot.position)) continue;
    sum += static_cast<float>(falloff * cos_receiver / (distance2 * distance)) * spot.intensity;
  }
  return sum;
}

std::vector<EmitterSample> DirectLight::emitter_samples(const Instant& instant, const SurfacePoint& point,
                                                        int samples, uint64_t seed, Which which) const {
  struct Candidate {
    Emitter shape;
    uint32_t polygon;
    double likely;  // W / m^2, roughly, unoccluded
  };
  std::vector<Candidate> candidates;
  double total = 0;
  const size_t first_emitter = which == Which::kMoving ? still_.size() : 0;
  const size_t end_emitter = which == Which::kStill ? still_.size() : emitters_.size();
  for (size_t i = first_emitter; i < end_emitter; ++i) {
    const uint32_t p = emitters_[i];
    const Polygon& polygon = scene_.polygons[p];
    if (p == point.polygon || instant.glow[polygon.material] == 0) continue;
    const Emitter e = i < still_.size() ? still_[i] : emitter_at(p, instant.world_from_body);
    if (!(dot(point.position - e.corners[0], e.normal) > 0)) continue;  // behind its front
    double highest = -1;
    for (int c = 0; c < e.count; ++c)
      highest = std::max(highest, dot(e.corners[c] - point.position, point.normal));
    if (!(highest > 0)) continue;  // below the horizon
    const Vec3 to = e.centre - point.position;
    const double radius2 = length2(e.corners[0] - e.centre), distance2 = length2(to) + radius2;
    const double cosines = (std::max(0.0, dot(to, point.normal)) + std::sqrt(radius2)) *
                           (std::max(0.0, -dot(to, e.normal)) + std::sqrt(radius2)) / distance2;
    const double likely = max_channel(scene_.materials[polygon.material].emission) *
                          instant.glow[polygon.material] * std::min(1.0, cosines) * e.area / distance2;
    candidates.push_back({e, p, likely});
    total += likely;
  }

  std::vector<EmitterSample> chosen;
  double faint = 0;
  const double least = candidates.size() > kFew ? total / kFew : 0;
  for (const Candidate& c : candidates) {
    if (c.likely < least) {
      faint += c.likely;
      continue;
    }
    const double unoccluded =
        unit_irradiance(point.position, point.normal, c.shape.corners.data(), c.shape.count);
    if (!(unoccluded > 0)) continue;
    const double share = std::min(1.0, 8 * c.likely / total);
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(samples * share))));
    const size_t first = chosen.size();
    double all = 0;
    for (int i = 0; i < side * side; ++i) {
      const uint64_t h = hash_of(seed, c.polygon, static_cast<uint64_t>(i));
      const double u = (i % side + unit_from(h)) / side, v = (i / side + unit_from(mix64(h))) / side;
      const EmitterSample sample = sample_at(c.shape, point, u, v);
      if (!(sample.irradiance > 0)) continue;
      chosen.push_back(sample);
      all += sample.irradiance;
    }
    for (size_t i = first; i < chosen.size(); ++i) {
      chosen[i].irradiance *= static_cast<float>(unoccluded / all);
      chosen[i].material = scene_.polygons[c.polygon].material;
    }
  }
  // Of the faint ones draw some, as often as they are likely to matter.
  if (!(faint > 0)) return chosen;
  const int draws = std::max(1, static_cast<int>(std::ceil(4 * samples * faint / total)));
  const double u0 = unit_from(hash_of(seed, 8)), v0 = unit_from(hash_of(seed, 9));
  double next = unit_from(hash_of(seed, 7)) * faint / draws;
  double before = 0;
  uint32_t draw = 0;
  for (const Candidate& c : candidates) {
    if (!(c.likely < least)) continue;
    before += c.likely;
    for (; next < before; next += faint / draws) {
      const Point2 uv = r2_point(draw++, u0, v0);
      EmitterSample sample = sample_at(c.shape, point, uv.u, uv.v);
      sample.irradiance *= static_cast<float>(faint / (draws * c.likely));
      sample.material = scene_.polygons[c.polygon].material;
      if (sample.irradiance > 0) chosen.push_back(sample);
    }
  }
  return chosen;
}

Rgb DirectLight::emitters(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                          Which which, uint64_t* rays) const {
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb sum;
  for (const EmitterSample& sample : emitter_samples(instant, point, samples, seed, which)) {
    ++*rays;
    if (tracer_.occluded(instant.world_from_body, lifted, sample.target)) continue;
    sum += (sample.irradiance * instant.glow[sample.material]) * scene_.materials[sample.material].emission;
  }
  return sum;
}

Rgb DirectLight::irradiance(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                            uint64_t* rays) const {
  uint64_t traced = 0;
  const Rgb sum =
      spots(instant, point, &traced) + emitters(instant, point, samples, seed, Which::kAll, &traced);
  if (rays) *rays += traced;
  return sum;
}

}  // namespace strad
