#include "frame/shading.h"

#include <algorithm>

#include "scene/texture.h"

namespace strad {
namespace {

// Neighbours whose normals differ by less than 15 degrees may be parts of one curved surface.
const double kCosSmooth = std::cos(15 * kPi / 180);

Rgb reflected(const Sight& sight, Rgb irradiance) {
  return static_cast<float>(1 / kPi) * sight.reflectance * irradiance;
}

// Does b lie on the continuation of the surface at a? Steps between parallel faces do not.
bool continues(const SurfacePoint& a, const SurfacePoint& b) {
  if (dot(a.normal, b.normal) < kCosSmooth) return false;
  const Vec3 across = b.position - a.position;
  return std::abs(dot(across, a.normal)) <= 0.3 * length(across);
}

}  // namespace

Sight look(const FrameView& view, size_t instant, double x, double y) {
  const CameraRays& camera = view.cameras[instant];
  const FrameInstant& now = view.instants[instant];
  return view.surfaces.look(now.tracer, now.lights.instant, camera.from(), camera.direction(x, y));
}

Sample take_sample(const FrameView& view, size_t instant, double x, double y, ShadowPoints points,
                   GroupShare* shares) {
  return shade(view, instant, look(view, instant, x, y), points, shares);
}

Sample shade(const FrameView& view, size_t instant, const Sight& sight, ShadowPoints points,
             GroupShare* shares) {
  std::fill(shares, shares + view.group_count, GroupShare{});
  const FrameInstant& now = view.instants[instant];
  Sample sample;
  sample.point = sight.smooth;
  sample.front = sight.front;
  sample.base = {sight.emission, {}, sight.emission};
  if (sight.point.polygon == kNone || is_black(sight.reflectance)) return sample;
  Rgb irradiance = view.light.irradiance(sight.point.polygon, sight.front, sight.at, &sample.leaf);
  sample.base.indirect = reflected(
      sight, view.indirect
                 ? view.indirect->irradiance(sight.point.polygon, sight.front, sight.at, &sample.leaf)
                 : irradiance);
  SpotRays spot_rays;
  if (view.trace_direct) irradiance += now.spots.irradiance(sight.smooth, &spot_rays);
  sample.spots = spot_rays.reached;
  sample.base.all += reflected(sight, irradiance);
  thread_local GroupSight seen;
  for (size_t l = 0; l < view.group_count; ++l) {
    const LitGroup& group = now.lights.groups[l];
    if (is_black(group.radiance)) continue;
    see_group(group, sight.smooth, &seen);
    shares[l].irradiance = unoccluded_irradiance(group, sight.smooth, seen);
    shares[l].radiance = static_cast<float>(shares[l].irradiance) * reflected(sight, group.radiance);
    add_shadow_rays(now.tracer, group, sight.smooth, shares[l].irradiance, points, &seen, &shares[l].shadow);
  }
  return sample;
}

void add_shadow_rays(const FrameView& view, size_t instant, const Sample& sample, size_t group,
                     ShadowPoints points, GroupShare* share) {
  const FrameInstant& now = view.instants[instant];
  thread_local GroupSight seen;
  see_group(now.lights.groups[group], sample.point, &seen);
  add_shadow_rays(now.tracer, now.lights.groups[group], sample.point, share->irradiance, points, &seen,
                  &share->shadow);
}

Light light_of(const FrameView& view, const Sample& sample, const GroupShare* shares) {
  Light sum = sample.base;
  for (size_t l = 0; l < view.group_count; ++l)
    sum.all += free_fraction(shares[l].shadow) * shares[l].radiance;
  return sum;
}

bool on_one_surface(const FrameView& view, const Sample& a, const Sample& b) {
  if (a.point.polygon == kNone || b.point.polygon == kNone || a.front != b.front) return false;
  if (a.point.polygon == b.point.polygon) return true;
  const Polygon& of_a = view.scene.polygons[a.point.polygon];
  const Polygon& of_b = view.scene.polygons[b.point.polygon];
  return of_a.object == of_b.object && of_a.material == of_b.material && continues(a.point, b.point);
}

bool alike(const FrameView& view, const Sample& a, const Sample& b) {
  if (a.point.polygon == kNone && b.point.polygon == kNone) return true;
  return on_one_surface(view, a, b) && a.leaf == b.leaf && a.spots == b.spots;
}

bool evenly_lit(const FrameView& view, const GroupShare* shares) {
  return std::all_of(shares, shares + view.group_count, [](const GroupShare& share) {
    return share.shadow.free == 0 || share.shadow.free == share.shadow.rays;
  });
}

bool textured(const FrameView& view, const Sample& sample) {
  return sample.point.polygon != kNone && has_texture(view.scene, view.scene.polygons[sample.point.polygon]);
}

}  // namespace strad
