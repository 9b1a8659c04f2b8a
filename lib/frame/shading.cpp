#include "frame/shading.h"

#include <algorithm>

#include "frame/sobol.h"
#include "frame/specular.h"

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

namespace {

// The light that a surface reflects diffusely and emits.
Sample shade_diffuse(const FrameView& view, size_t instant, const Sight& sight, ShadowPoints points,
                     GroupShare* shares) {
  std::fill(shares, shares + view.group_count, GroupShare{});
  const FrameInstant& now = view.instants[instant];
  Sample sample;
  sample.point = sight.smooth;
  sample.front = sight.front;
  sample.base = {sight.emission, {}, sight.emission};
  sample.varies = sight.textured || sight.finish;
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

// Rays that make less of a sample than this are not followed.
constexpr float kLeastShare = 0.003f;
// Rays of a rough mirror that a sample sees, and of one that it sees in another; and shadow rays to each
// emitter group from where they end.
constexpr uint32_t kLobes = 16, kLaterLobes = 4, kSpecularRays = 4;

// Follows what a sample sees in mirrors and through glass, all ways on from each surface.
class SpecularWalk {
 public:
  SpecularWalk(const FrameView& view, size_t instant, ShadowPoints points)
      : view_(view),
        now_(view.instants[instant]),
        instant_(instant),
        scramble_(points.scramble),
        first_(points.count > 0 ? points.first / points.count : points.first),
        shares_(view.group_count) {}

  void follow(const Sight& sight, Rgb share, int depth) {
    const GlassKind kind = now_.tracer.glass_kind(sight.point.polygon);
    const bool rough = sight.finish->roughness > 0 && kind == GlassKind::kNone;
    const uint32_t lobes = !rough || depth > 1 ? 1 : depth == 0 ? kLobes : kLaterLobes;
    const float part = 1 / static_cast<float>(lobes);
    const uint64_t key = hash_of(scramble_, static_cast<uint64_t>(depth), 23);
    for (uint32_t i = 0; i < lobes; ++i) {
      const Point2 lobe = OwenSequence(first_ * lobes + i, key).next();
      const SpecularRays rays = specular_rays(kind, sight, now_.tracer.offset(), lobe);
      for (const SpecularRay& ray : {rays.mirrored, rays.passed}) go(ray, part * share, depth + 1);
    }
    if (rough) seen = 0;  // blurred: it has no edges
  }

  Rgb sum;
  uint64_t seen = 0;  // a number for the surfaces that were met, and which spotlights reach them

 private:
  void go(const SpecularRay& ray, Rgb share, int depth) {
    share = share * ray.share;
    if (!(max_channel(share) > kLeastShare)) return;
    const Sight sight = view_.surfaces.look(now_.tracer, now_.lights.instant, ray.from, ray.direction);
    if (sight.point.polygon == kNone) {
      seen = mix64(seen);
      return;
    }
    const uint64_t key = hash_of(scramble_, static_cast<uint64_t>(depth), 29);
    const Sample sample =
        shade_diffuse(view_, instant_, sight, {first_ * kSpecularRays, kSpecularRays, key}, shares_.data());
    sum += share * light_of(view_, sample, shares_.data()).all;
    const Polygon& polygon = view_.scene.polygons[sight.point.polygon];
    seen = hash_of(seen, polygon.object * uint64_t{2} + sight.front, polygon.material);
    seen = hash_of(seen, sample.spots, sample.leaf);
    if (sight.finish && depth < kMostSpecular) follow(sight, share, depth);
  }

  const FrameView& view_;
  const FrameInstant& now_;
  size_t instant_;
  uint64_t scramble_;
  uint32_t first_;                  // of the sample among those that share scramble_
  std::vector<GroupShare> shares_;  // of the surface that is being shaded
};

}  // namespace

Sample shade(const FrameView& view, size_t instant, const Sight& sight, ShadowPoints points,
             GroupShare* shares) {
  Sample sample = shade_diffuse(view, instant, sight, points, shares);
  if (!sight.finish) return sample;
  SpecularWalk walk(view, instant, points);
  walk.follow(sight, {1, 1, 1}, 0);
  sample.base.specular = walk.sum;
  sample.base.all += walk.sum;
  sample.spots = hash_of(sample.spots, walk.seen);
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
  for (size_t l = 0; l < view.group_count; ++l) sum.all += free_colour(shares[l].shadow) * shares[l].radiance;
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
    const ShadowRays& shadow = share.shadow;
    return (shadow.free == 0 || shadow.free == shadow.rays) &&
           (shadow.through_glass == 0 || shadow.through_glass == shadow.free);
  });
}

}  // namespace strad
