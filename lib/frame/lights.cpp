#include "frame/lights.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/rng.h"
#include "frame/sobol.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

Emitter emitter_at(const Scene& scene, uint32_t p, const std::vector<Pose>& world_from_body) {
  const Polygon& polygon = scene.polygons[p];
  const Pose& pose = world_from_body[body_of(scene, polygon)];
  Emitter emitter;
  emitter.polygon = p;
  emitter.count = polygon.corner_count();
  for (int c = 0; c < emitter.count; ++c) {
    emitter.corners[static_cast<size_t>(c)] = pose * scene.vertices[polygon.corners[c]];
  }
  emitter.normal = rotate(pose, polygon_normal(scene, polygon));
  emitter.area = polygon_area(scene, polygon);
  const auto& c = emitter.corners;
  const double skew = length((c[0] - c[1]) + (c[2] - c[3]));
  emitter.parallelogram = emitter.count == 4 && skew <= 1e-9 * length(c[2] - c[0]);
  return emitter;
}

// Maps the unit square onto the polygon, uniformly on parallelograms and triangles. The second value is the
// density that is left over on other quads: area of the image of a small square, over the mean one.
Vec3 point_on(const Emitter& emitter, double u, double v, double* stretch) {
  const auto& c = emitter.corners;
  *stretch = 1;
  if (emitter.parallelogram) return c[0] + u * (c[1] - c[0]) + v * (c[3] - c[0]);
  if (emitter.count == 3) {
    const double root = std::sqrt(u);  // Turk 1990
    return (1 - root) * c[0] + root * (1 - v) * c[1] + root * v * c[2];
  }
  const Vec3 along_u = lerp(c[1] - c[0], c[2] - c[3], v), along_v = lerp(c[3] - c[0], c[2] - c[1], u);
  *stretch = length(cross(along_u, along_v)) / emitter.area;
  return lerp(lerp(c[0], c[1], u), lerp(c[3], c[2], u), v);
}

}  // namespace

std::vector<AreaLight> area_lights(const Scene& scene) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> place;
  std::vector<AreaLight> lights;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon& polygon = scene.polygons[p];
    if (!emits(scene, polygon)) continue;
    const auto [it, is_new] =
        place.try_emplace({polygon.object, polygon.material}, static_cast<uint32_t>(lights.size()));
    if (is_new) lights.push_back({polygon.material, {}});
    lights[it->second].polygons.push_back(p);
  }
  return lights;
}

LitInstant lit_instant(const Scene& scene, const std::vector<AreaLight>& lights, double time) {
  LitInstant lit;
  lit.instant = instant_at(scene, time);
  for (const Spot& spot : scene.spots) lit.cos_outer.push_back(std::cos(spot.outer));
  for (const AreaLight& light : lights) {
    std::vector<Emitter> emitters;
    for (const uint32_t p : light.polygons) {
      emitters.push_back(emitter_at(scene, p, lit.instant.world_from_body));
    }
    lit.emitters.push_back(std::move(emitters));
    lit.radiance.push_back(lit.instant.glow[light.material] * scene.materials[light.material].emission);
  }
  return lit;
}

Rgb spot_irradiance(const Scene& scene, const Tracer& tracer, const LitInstant& lit,
                    const SurfacePoint& point, uint64_t* reached) {
  const Vec3 lifted = point.position + tracer.offset() * point.normal;
  Rgb sum;
  for (size_t s = 0; s < scene.spots.size(); ++s) {
    const SpotState& spot = lit.instant.spots[s];
    const Vec3 to_spot = spot.position - point.position;
    const double facing = dot(to_spot, point.normal), ahead = -dot(to_spot, spot.direction);
    const double distance2 = length2(to_spot), distance = std::sqrt(distance2);
    if (!(facing > 0) || !(ahead > lit.cos_outer[s] * distance) || is_black(spot.intensity)) continue;
    const double falloff = spot_falloff(scene.spots[s], ahead / distance);
    if (!(falloff > 0) || tracer.occluded(lit.instant.world_from_body, lifted, spot.position)) continue;
    sum += static_cast<float>(falloff * facing / (distance2 * distance)) * spot.intensity;
    *reached = mix64(*reached + s);
  }
  return sum;
}

void look_at(const std::vector<Emitter>& emitters, const SurfacePoint& point, AreaView* view) {
  view->up_to.clear();
  view->irradiance = 0;
  for (const Emitter& emitter : emitters) {
    const bool before = dot(point.position - emitter.corners[0], emitter.normal) > 0;
    if (before && emitter.polygon != point.polygon) {
      view->irradiance +=
          unit_irradiance(point.position, point.normal, emitter.corners.data(), emitter.count);
    }
    view->up_to.push_back(view->irradiance);
  }
}

void add_shadow_rays(const Tracer& tracer, const LitInstant& lit, const std::vector<Emitter>& emitters,
                     const SurfacePoint& point, const AreaView& view, uint32_t first, uint32_t count,
                     Shadow* shadow) {
  if (!(view.irradiance > 0)) return;
  const Vec3 lifted = point.position + tracer.offset() * point.normal;
  const uint64_t scramble = hash_of(emitters.front().polygon);
  for (uint32_t i = first; i < first + count; ++i) {
    const Point2 at = sobol_point(i, scramble);
    // An emitter in proportion to what it would bring; the place within its share is uniform again.
    const double target = at.u * view.irradiance;
    const auto chosen = std::upper_bound(view.up_to.begin(), view.up_to.end() - 1, target);
    const Emitter& emitter = emitters[static_cast<size_t>(chosen - view.up_to.begin())];
    const double below = chosen == view.up_to.begin() ? 0 : *(chosen - 1);
    const double share = *chosen - below;
    double stretch = 1;
    const Vec3 on_light = point_on(emitter, std::clamp((target - below) / share, 0.0, 1.0), at.v, &stretch);
    const Vec3 to_light = on_light - point.position;
    const double cos_point = dot(to_light, point.normal), cos_light = -dot(to_light, emitter.normal);
    if (!(cos_point > 0) || !(cos_light > 0)) continue;
    const double distance2 = length2(to_light);
    const double weight = stretch * emitter.area * cos_point * cos_light / (distance2 * distance2 * share);
    ++shadow->rays;
    shadow->all += static_cast<float>(weight);
    if (tracer.occluded(lit.instant.world_from_body, lifted, on_light + tracer.offset() * emitter.normal))
      continue;
    ++shadow->free;
    shadow->seen += static_cast<float>(weight);
  }
}

}  // namespace strad
