#include "frame/emitter_groups.h"

#include <algorithm>
#include <map>

#include "base/rng.h"
#include "frame/sobol.h"

namespace strad {

std::vector<EmitterGroup> emitter_groups(const Scene& scene) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> place;
  std::vector<EmitterGroup> groups;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon& polygon = scene.polygons[p];
    if (!emits(scene, polygon)) continue;
    const auto [it, is_new] =
        place.try_emplace({polygon.object, polygon.material}, static_cast<uint32_t>(groups.size()));
    if (is_new) groups.push_back({polygon.material, {}});
    groups[it->second].polygons.push_back(p);
  }
  return groups;
}

LitInstant lit_instant(const Scene& scene, const std::vector<EmitterGroup>& groups, double time) {
  LitInstant lit;
  lit.instant = instant_at(scene, time);
  lit.cones = cones_of(scene.spots);
  for (const EmitterGroup& group : groups) {
    std::vector<Emitter> emitters;
    for (const uint32_t p : group.polygons)
      emitters.push_back(emitter_at(scene, p, lit.instant.world_from_body));
    lit.emitters.push_back(std::move(emitters));
    lit.radiance.push_back(lit.instant.glow[group.material] * scene.materials[group.material].emission);
  }
  return lit;
}

void find_unoccluded(const std::vector<Emitter>& emitters, const SurfacePoint& point,
                     UnoccludedIrradiance* irradiance) {
  irradiance->up_to.clear();
  irradiance->total = 0;
  for (const Emitter& emitter : emitters) {
    if (is_before(emitter, point.position) && emitter.polygon != point.polygon) {
      irradiance->total +=
          unit_irradiance(point.position, point.normal, emitter.corners.data(), emitter.count);
    }
    irradiance->up_to.push_back(irradiance->total);
  }
}

void add_shadow_rays(const Tracer& tracer, const LitInstant& lit, const std::vector<Emitter>& emitters,
                     const SurfacePoint& point, const UnoccludedIrradiance& unoccluded, uint32_t first,
                     uint32_t count, ShadowRays* shadow) {
  if (!(unoccluded.total > 0)) return;
  const Vec3 lifted = point.position + tracer.offset() * point.normal;
  const uint64_t scramble = hash_of(emitters.front().polygon);
  for (uint32_t i = first; i < first + count; ++i) {
    const Point2 at = sobol_point(i, scramble);
    // Chooses an emitter in proportion to its irradiance. The number's position within its share is uniform
    // again.
    const double target = at.u * unoccluded.total;
    const auto chosen = std::upper_bound(unoccluded.up_to.begin(), unoccluded.up_to.end() - 1, target);
    const Emitter& emitter = emitters[static_cast<size_t>(chosen - unoccluded.up_to.begin())];
    const double below = chosen == unoccluded.up_to.begin() ? 0 : *(chosen - 1);
    const double share = *chosen - below, u = std::clamp((target - below) / share, 0.0, 1.0);
    const Vec3 on_emitter = point_on(emitter, u, at.v);
    const double weight = stretch_at(emitter, u, at.v) * point_irradiance(emitter, on_emitter, point) / share;
    if (!(weight > 0)) continue;
    ++shadow->rays;
    shadow->all += static_cast<float>(weight);
    if (tracer.occluded(lit.instant.world_from_body, lifted, on_emitter + tracer.offset() * emitter.normal))
      continue;
    ++shadow->free;
    shadow->seen += static_cast<float>(weight);
  }
}

}  // namespace strad
