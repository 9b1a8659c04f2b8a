#include "frame/preview.h"

#include <algorithm>
#include <map>

#include "base/parallel.h"
#include "frame/camera.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

constexpr size_t kMostLamps = 16;     // the strongest, so that a frame stays quick
constexpr float kHeadlight = 0.1f;    // radiance of a white surface that faces the camera, beside lamps
constexpr float kHeadlightAlone = 1;  // the same where there are no lamps
constexpr float kGrazing = 0.3f;      // of that, on a surface seen from the side

}  // namespace

Preview::Preview(const Scene& scene)
    : scene_(scene), tracer_(scene), surfaces_(scene, tracer_), cones_(cones_of(scene.spots)) {
  struct Sum {
    Vec3 centre, normal;
    double area = 0;
  };
  std::map<std::pair<uint32_t, uint32_t>, Sum> sums;  // by object and material
  for (const Polygon& polygon : scene.polygons) {
    if (!emits(scene, polygon)) continue;
    const auto corner = [&](int k) { return scene.vertices[polygon.corners[k]]; };
    Vec3 twice = cross(corner(1) - corner(0), corner(2) - corner(0)),
         middle = corner(0) + corner(1) + corner(2);
    if (polygon.corner_count() == 4) {
      twice += cross(corner(2) - corner(0), corner(3) - corner(0));
      middle += corner(3);
    }
    Sum& sum = sums[{polygon.object, polygon.material}];
    const double area = length(twice) / 2;
    sum.centre += area / polygon.corner_count() * middle;
    sum.normal += 0.5 * twice;
    sum.area += area;
  }
  for (const auto& [key, sum] : sums) {
    if (!(sum.area > 0)) continue;
    Lamp lamp{scene.objects[key.first].body, key.second, sum.centre / sum.area, {}, sum.area, sum.area / 4};
    // Facets that face one way shine that way; a closed lamp shows a quarter of its area all around (Cauchy).
    if (length(sum.normal) > sum.area / 2) {
      lamp.normal = normalized(sum.normal);
      lamp.projected = length(sum.normal);
    }
    lamps_.push_back(lamp);
  }
  const auto power = [&](const Lamp& lamp) {
    return lamp.area * luminance(scene.materials[lamp.material].emission);
  };
  std::stable_sort(lamps_.begin(), lamps_.end(),
                   [&](const Lamp& a, const Lamp& b) { return power(a) > power(b); });
  if (lamps_.size() > kMostLamps) lamps_.resize(kMostLamps);
}

Rgb Preview::lamps_irradiance(const Instant& instant, const SurfacePoint& point) const {
  Rgb sum;
  for (size_t i = 0; i < cones_.size(); ++i) {
    const double irradiance = spot_irradiance(cones_[i], instant.spots[i], point);
    sum += static_cast<float>(irradiance) * instant.spots[i].intensity;
  }
  for (const Lamp& lamp : lamps_) {
    const Pose& pose = instant.world_from_body[lamp.body];
    const Vec3 to = pose * lamp.centre - point.position;
    const double d2 = length2(to);
    if (!(d2 > 0)) continue;
    const Vec3 direction = to / std::sqrt(d2);
    const double cosine = dot(direction, point.normal);
    const double lamps_cosine = lamp.normal == Vec3{} ? 1 : -dot(direction, rotate(pose, lamp.normal));
    if (!(cosine > 0 && lamps_cosine > 0)) continue;
    // A disc of the lamp's area, seen from its axis, instead of a point: finite where it is near.
    const double form = lamp.projected * lamps_cosine * cosine / (d2 + lamp.area / kPi);
    sum += static_cast<float>(form) * instant.glow[lamp.material] * scene_.materials[lamp.material].emission;
  }
  return sum;
}

Image Preview::render(const Camera& camera, double time, uint32_t width, uint32_t height) const {
  const Instant instant = instant_at(scene_, time);
  const CameraRays rays(camera_at(camera, time), width, height);
  const float headlight = cones_.empty() && lamps_.empty() ? kHeadlightAlone : kHeadlight;
  Image image(width, height);
  parallel_for(height, 8, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (uint32_t x = 0; x < width; ++x) {
        const Vec3 direction = rays.direction(x + 0.5, static_cast<double>(y) + 0.5);
        const Sight sight = surfaces_.look(instant, rays.from(), direction);
        if (sight.point.polygon == kNone) continue;
        const auto facing = static_cast<float>(std::abs(dot(direction, sight.point.normal)));
        const float own = headlight * (kGrazing + (1 - kGrazing) * facing);
        const Rgb irradiance = lamps_irradiance(instant, sight.point);
        image.at(x, static_cast<uint32_t>(y)) =
            sight.emission +
            sight.reflectance * (static_cast<float>(1 / kPi) * irradiance + Rgb{own, own, own});
      }
    }
  });
  return image;
}

}  // namespace strad
