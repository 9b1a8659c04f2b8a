#include "frame/reference.h"

#include <bit>

#include "base/parallel.h"
#include "frame/camera.h"
#include "frame/sobol.h"
#include "frame/specular.h"

namespace strad {
namespace {

struct View {
  Instant instant;
  CameraRays camera;
};

}  // namespace

struct Reference::Exposure {
  const Scene& scene;
  const Camera& camera;
  const ReferenceOptions& options;
  double time;
  uint64_t key;  // of seed and time
  View at_time;

  View view(double when) const {
    return {instant_at(scene, when), CameraRays(camera_at(camera, when), options.width, options.height)};
  }
};

Reference::Reference(const Scene& scene)
    : scene_(scene), tracer_(scene), surfaces_(scene, tracer_), paths_(scene, tracer_, surfaces_) {}

Rgb Reference::diffuse(const Instant& instant, const Sight& sight, PathRandom* random) const {
  Rgb radiance = sight.emission;
  if (is_black(sight.reflectance)) return radiance;
  Rgb irradiance = paths_.spots(instant, sight.point, random);
  Point2 first;
  first.u = random->next();
  first.v = random->next();
  irradiance += paths_.but_spots(instant, sight.point, first, random);
  radiance += static_cast<float>(1 / kPi) * sight.reflectance * irradiance;
  return radiance;
}

// What the eye sees there, by one of the ways on from each mirror and glass.
Rgb Reference::radiance(const Instant& instant, Sight sight, PathRandom* random) const {
  Rgb sum, throughput{1, 1, 1};
  for (int depth = 0; sight.point.polygon != kNone; ++depth) {
    sum += throughput * diffuse(instant, sight, random);
    if (depth == kMostSpecular || !sight.finish) break;
    Point2 lobe;
    lobe.u = random->next();
    lobe.v = random->next();
    const SpecularRays rays =
        specular_rays(tracer_.glass_kind(sight.point.polygon), sight, tracer_.offset(), lobe);
    const float mirrored = max_channel(rays.mirrored.share), all = mirrored + max_channel(rays.passed.share);
    if (!(all > 0)) break;
    const bool mirror = random->next() * double{all} < double{mirrored};
    const SpecularRay& ray = mirror ? rays.mirrored : rays.passed;
    throughput = (all / max_channel(ray.share)) * throughput * ray.share;
    sight = surfaces_.look(instant, ray.from, ray.direction);
  }
  return sum;
}

Rgb Reference::pixel(const Exposure& exposure, uint32_t x, uint32_t y) const {
  const ReferenceOptions& options = exposure.options;
  const uint64_t key = hash_of(exposure.key, x, y);
  double sum[3] = {0, 0, 0};
  View moment = exposure.at_time;
  for (int p = 0; p < options.paths; ++p) {
    PathRandom random(hash_of(key, static_cast<uint64_t>(p), 1));
    // Spread evenly over the pixel and over the shutter's time.
    const Point2 at = sobol_point(static_cast<uint32_t>(p), key);
    if (options.shutter > 0)
      moment = exposure.view(exposure.time + options.shutter * (p + random.next()) / options.paths);
    const Sight sight =
        surfaces_.look(moment.instant, moment.camera.from(), moment.camera.direction(x + at.u, y + at.v));
    const Rgb radiance = this->radiance(moment.instant, sight, &random);
    for (int c = 0; c < 3; ++c) sum[c] += radiance[c];
  }
  const double count = options.paths;
  return {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count),
          static_cast<float>(sum[2] / count)};
}

Image Reference::render(const Camera& camera, double time, const ReferenceOptions& options) const {
  Exposure exposure{
      scene_,
      camera,
      options,
      time,
      hash_of(options.seed, std::bit_cast<uint64_t>(time)),
      {instant_at(scene_, time), CameraRays(camera_at(camera, time), options.width, options.height)}};
  Image image(options.width, options.height);
  parallel_for(options.height, 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y)
      for (uint32_t x = 0; x < options.width; ++x)
        image.at(x, static_cast<uint32_t>(y)) = pixel(exposure, x, static_cast<uint32_t>(y));
  });
  return image;
}

}  // namespace strad
