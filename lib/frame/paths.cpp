#include "frame/paths.h"

#include <algorithm>
#include <cmath>

#include "frame/cosine_direction.h"
#include "light/spotlight.h"

namespace strad {
namespace {

// Points of emitters among which one is chosen for a shadow ray.
constexpr int kCandidates = 8;
// Paths have at least this many reflections. Then Russian roulette ends them (Arvo & Kirk 1990).
constexpr int kSureReflections = 2;
// Then at most this fraction goes on: between white surfaces, or inside a closed body without light, a path
// would never end.
constexpr float kMostSurvival = 0.95f;

}  // namespace

Paths::Paths(const Scene& scene, const Tracer& tracer, const Surfaces& surfaces)
    : scene_(scene), tracer_(tracer), surfaces_(surfaces), cones_(cones_of(scene.spots)) {
  double sum = 0;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon& polygon = scene.polygons[p];
    if (!emits(scene, polygon)) continue;
    for (int c = 2; c < polygon.corner_count(); ++c) {
      const Vec3 a = scene.vertices[polygon.corners[0]], b = scene.vertices[polygon.corners[c - 1]],
                 d = scene.vertices[polygon.corners[c]];
      const Vec3 doubled = cross(b - a, d - a);
      const double area = length(doubled) / 2;
      if (!(area > 0)) continue;
      const double emission = max_channel(scene.materials[polygon.material].emission);
      sum += area * emission;
      emitters_.push_back({{a, b, d}, normalized(doubled), emission, p});
      up_to_.push_back(sum);
    }
  }
  for (EmittingTriangle& emitter : emitters_) emitter.density /= sum;
}

Rgb Paths::unoccluded(const Instant& instant, const SurfacePoint& point, size_t s) const {
  const SpotState& spot = instant.spots[s];
  return static_cast<float>(spot_irradiance(cones_[s], spot, point)) * spot.intensity;
}

// One spotlight, chosen in proportion to its unoccluded irradiance.
Rgb Paths::spots(const Instant& instant, const SurfacePoint& point, PathRandom* random) const {
  double sum = 0;
  const double u = random->next();
  size_t chosen = 0;
  Rgb brought;
  double left = u;  // one uniform number is enough for all choices: after each, its rest is scaled to [0, 1)
  for (size_t s = 0; s < instant.spots.size(); ++s) {
    const Rgb irradiance = unoccluded(instant, point, s);
    const double weight = max_channel(irradiance);
    if (!(weight > 0)) continue;
    sum += weight;
    const double take = weight / sum;
    if (left < take) {
      chosen = s, brought = irradiance, left /= take;
    } else {
      left = (left - take) / (1 - take);
    }
  }
  if (!(sum > 0)) return {};
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb passed{1, 1, 1};
  if (tracer_.occluded(instant.world_from_body, lifted, instant.spots[chosen].position, &passed)) return {};
  return passed * (static_cast<float>(sum / max_channel(brought)) * brought);
}

// A point of an emitter, chosen in proportion to area times emission.
Paths::Candidate Paths::draw_emitter(const Instant& instant, const SurfacePoint& point,
                                     PathRandom* random) const {
  const double target = random->next() * up_to_.back(), root = std::sqrt(random->next()), v = random->next();
  const auto chosen = std::upper_bound(up_to_.begin(), up_to_.end() - 1, target);
  const EmittingTriangle& emitter = emitters_[static_cast<size_t>(chosen - up_to_.begin())];
  if (emitter.polygon == point.polygon) return {};
  const Polygon& polygon = scene_.polygons[emitter.polygon];
  const Pose& pose = instant.world_from_body[body_of(scene_, polygon)];
  const auto& c = emitter.corners;
  const Vec3 on_emitter = pose * ((1 - root) * c[0] + root * (1 - v) * c[1] + root * v * c[2]);  // Turk 1990
  const Vec3 normal = rotate(pose, emitter.normal), to = on_emitter - point.position;
  const double cos_point = dot(to, point.normal), cos_emitter = -dot(to, normal), distance2 = length2(to);
  if (!(cos_point > 0) || !(cos_emitter > 0)) return {};
  const double geometry = cos_point * cos_emitter / (distance2 * distance2);
  // Over the density of the points, and times the weight that met_emitter() leaves.
  const double scale = geometry * kCandidates / (kCandidates * emitter.density + geometry / kPi) *
                       instant.glow[polygon.material];
  return {on_emitter + tracer_.offset() * normal,
          static_cast<float>(scale) * scene_.materials[polygon.material].emission};
}

// One of a few candidates, chosen in proportion to its unoccluded irradiance, stands for their mean
// (resampled importance sampling: Talbot, Cline & Egbert 2005).
Rgb Paths::emitters(const Instant& instant, const SurfacePoint& point, PathRandom* random) const {
  if (emitters_.empty()) return {};
  double sum = 0;
  Candidate chosen;
  for (int i = 0; i < kCandidates; ++i) {
    const Candidate candidate = draw_emitter(instant, point, random);
    const double weight = max_channel(candidate.irradiance);
    sum += weight;
    if (random->next() * sum < weight) chosen = candidate;
  }
  if (!(sum > 0)) return {};
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb passed{1, 1, 1};
  if (tracer_.occluded(instant.world_from_body, lifted, chosen.target, &passed)) return {};
  return passed *
         (static_cast<float>(sum / (kCandidates * max_channel(chosen.irradiance))) * chosen.irradiance);
}

// W / m^2: what the emitter that a path meets in `direction` stands for, beside the points drawn on it.
Rgb Paths::met_emitter(const SurfacePoint& from, Vec3 direction, const Sight& sight) const {
  const double distance2 = length2(sight.point.position - from.position);
  const double cosines = dot(direction, from.normal) * -dot(direction, sight.point.normal);
  const double density =
      max_channel(scene_.materials[scene_.polygons[sight.point.polygon].material].emission) / up_to_.back();
  // geometry / pi over (kCandidates * density + geometry / pi), times distance2 so that nothing is infinite.
  const double weight = cosines / kPi / (kCandidates * density * distance2 + cosines / kPi);
  return weight > 0 ? static_cast<float>(kPi * weight) * sight.emission : Rgb{};
}

Rgb Paths::but_spots(const Instant& instant, const SurfacePoint& point, Point2 first,
                     PathRandom* random) const {
  // E = pi times the mean of L over directions by their cosine, and L = Le + rho E / pi of what is met there.
  Rgb sum = emitters(instant, point, random), throughput{1, 1, 1};
  SurfacePoint from = point;
  Point2 at = first;
  for (int reflections = 1;; ++reflections) {
    const Vec3 lifted = from.position + tracer_.offset() * from.normal;
    const Vec3 direction = cosine_direction(from.normal, at);
    Rgb passed{1, 1, 1};
    const Sight sight = surfaces_.look_through(instant, lifted, direction, &passed);
    if (sight.point.polygon == kNone) return sum;
    throughput = throughput * passed;
    if (!is_black(sight.emission)) sum += throughput * met_emitter(from, direction, sight);
    throughput = throughput * sight.reflectance;
    if (reflections > kSureReflections) {
      const float survival = std::min(kMostSurvival, max_channel(throughput));
      if (!(random->next() < survival)) return sum;
      throughput = (1 / survival) * throughput;
    }
    if (is_black(throughput)) return sum;
    const Rgb from_spots = spots(instant, sight.point, random);
    sum += throughput * (from_spots + emitters(instant, sight.point, random));
    from = sight.point;
    at.u = random->next();
    at.v = random->next();
  }
}

}  // namespace strad
