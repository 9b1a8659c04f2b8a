#include "light/spotlight.h"

#include <cmath>

#include "base/rng.h"

namespace strad {

SpotCone cone_of(const Spot& spot) { return {std::cos(spot.inner), std::cos(spot.outer)}; }

std::vector<SpotCone> cones_of(const std::vector<Spot>& spots) {
  std::vector<SpotCone> cones;
  for (const Spot& spot : spots) cones.push_back(cone_of(spot));
  return cones;
}

double spot_falloff(const SpotCone& cone, double cos_theta) {
  if (!(cos_theta > cone.cos_outer)) return 0;
  if (cos_theta >= cone.cos_inner) return 1;
  const double s = (cos_theta - cone.cos_outer) / (cone.cos_inner - cone.cos_outer);
  return s * s * (3 - 2 * s);
}

double spot_irradiance(const SpotCone& cone, const SpotState& spot, const SurfacePoint& point) {
  const Vec3 to_spot = spot.position - point.position;
  const double facing = dot(to_spot, point.normal);  // the receiver's cosine times the distance
  if (!(facing > 0)) return 0;
  const double distance2 = length2(to_spot), distance = std::sqrt(distance2);
  const double falloff = spot_falloff(cone, -dot(to_spot, spot.direction) / distance);
  return falloff * facing / (distance2 * distance);
}

Rgb spots_irradiance(const Tracer& tracer, const std::vector<SpotCone>& cones, const Instant& instant,
                     const SurfacePoint& point, SpotRays* rays) {
  const Vec3 lifted = point.position + tracer.offset() * point.normal;
  Rgb sum;
  for (size_t s = 0; s < cones.size(); ++s) {
    const SpotState& spot = instant.spots[s];
    if (is_black(spot.intensity)) continue;
    const double unoccluded = spot_irradiance(cones[s], spot, point);
    if (!(unoccluded > 0)) continue;
    ++rays->traced;
    Rgb passed{1, 1, 1};
    if (tracer.occluded(instant.world_from_body, lifted, spot.position, &passed)) continue;
    sum += passed * (static_cast<float>(unoccluded) * spot.intensity);
    rays->reached = mix64(rays->reached + s);
  }
  return sum;
}

}  // namespace strad
