#include "light/posed_spots.h"

#include "base/rng.h"

namespace strad {
namespace {

// Surely outside a cone that is narrower than a hemisphere: without a root, and with room for rounding.
bool outside(const SpotCone& cone, const SpotState& spot, Vec3 to_spot) {
  if (!(cone.cos_outer >= 0)) return false;
  const double along = -dot(to_spot, spot.direction);
  return !(along > 0) || along * along < (1 - 1e-9) * cone.cos_outer * cone.cos_outer * length2(to_spot);
}

}  // namespace

PosedSpots::PosedSpots(const PosedTracer& tracer, const std::vector<SpotCone>& cones, const Instant& instant)
    : tracer_(tracer), cones_(cones), instant_(instant) {
  for (uint32_t s = 0; s < cones.size(); ++s)
    if (!is_black(instant.spots[s].intensity)) lit_.push_back(s);
}

Rgb PosedSpots::irradiance(const SurfacePoint& point, SpotRays* rays) const {
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb sum;
  for (const uint32_t s : lit_) {
    const SpotState& spot = instant_.spots[s];
    const Vec3 to_spot = spot.position - point.position;
    if (!(dot(to_spot, point.normal) > 0)) continue;
    if (outside(cones_[s], spot, to_spot)) continue;
    const double unoccluded = spot_irradiance(cones_[s], spot, point);
    if (!(unoccluded > 0)) continue;
    ++rays->traced;
    Rgb passed{1, 1, 1};
    if (tracer_.occluded(lifted, spot.position, &passed)) continue;
    sum += passed * (static_cast<float>(unoccluded) * spot.intensity);
    rays->reached = mix64(rays->reached + s);
    if (passed != Rgb{1, 1, 1}) rays->reached = mix64(rays->reached);  // seen through glass
  }
  return sum;
}

}  // namespace strad
