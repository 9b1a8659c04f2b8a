#include "frame/geometry_layers.h"

#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "base/rng.h"
#include "frame/cryptomatte.h"
#include "frame/projection.h"
#include "frame/sobol.h"

namespace strad {
namespace {

constexpr float kNowhere = 1e10f;  // m: the depth of nothing, as Blender has it

// An instant as the camera sees it.
struct Moment {
  Instant instant;
  CameraState camera;
};

// The layers that are asked for; the others stay empty.
struct Targets {
  Layer *albedo = nullptr, *normal = nullptr, *position = nullptr, *depth = nullptr;
  Layer *forward = nullptr, *backward = nullptr;
  std::optional<Cryptomatte> objects, materials;
};

template <typename Named>
std::vector<std::string> names_of(const std::vector<Named>& things) {
  std::vector<std::string> names;
  for (const Named& thing : things) names.push_back(thing.name);
  return names;
}

class GeometryRenderer {
 public:
  GeometryRenderer(const Scene& scene, const Surfaces& surfaces, const Camera& camera, double time,
                   const GeometryOptions& options, Targets* targets)
      : scene_(scene),
        surfaces_(surfaces),
        options_(options),
        targets_(*targets),
        now_(moment(camera, time)),
        next_(moment(camera, time + 1 / scene.rate)),
        before_(moment(camera, time - 1 / scene.rate)),
        rays_(now_.camera, options.width, options.height) {}

  void row(uint32_t y) const {
    const bool filtered = targets_.albedo || targets_.objects || targets_.materials;
    for (uint32_t x = 0; x < options_.width; ++x) {
      const Sight middle = look(x + 0.5, y + 0.5);
      set_middle(x, y, middle);
      if (filtered) set_means(x, y, middle);
    }
  }

 private:
  Moment moment(const Camera& camera, double time) const {
    return {instant_at(scene_, time), camera_at(camera, time)};
  }
  Projection projection(const Moment& moment) const {
    return {moment.camera, options_.width, options_.height};
  }
  Sight look(double x, double y) const {
    return surfaces_.look(now_.instant, rays_.from(), rays_.direction(x, y));
  }
  float* at(Layer* layer, uint32_t x, uint32_t y) const {
    return &layer->samples[layer->channels.size() * (size_t{y} * options_.width + x)];
  }
  void set_middle(uint32_t x, uint32_t y, const Sight& sight) const;
  void set_motion(Layer* layer, uint32_t x, uint32_t y, const Moment& other, const Sight& sight) const;
  void set_means(uint32_t x, uint32_t y, const Sight& middle) const;
  bool is_alike(const Sight& a, const Sight& b) const;

  const Scene& scene_;
  const Surfaces& surfaces_;
  const GeometryOptions& options_;
  Targets& targets_;
  const Moment now_, next_, before_;
  const CameraRays rays_;
};

void put(float* to, Vec3 v) {
  to[0] = static_cast<float>(v.x), to[1] = static_cast<float>(v.y), to[2] = static_cast<float>(v.z);
}

void GeometryRenderer::set_middle(uint32_t x, uint32_t y, const Sight& sight) const {
  const bool seen = sight.point.polygon != kNone;
  if (targets_.normal && seen) put(at(targets_.normal, x, y), sight.smooth.normal);
  if (targets_.position && seen) put(at(targets_.position, x, y), sight.point.position);
  if (targets_.depth)
    *at(targets_.depth, x, y) =
        seen ? static_cast<float>(projection(now_).depth_of(sight.point.position)) : kNowhere;
  if (targets_.forward && seen) {
    set_motion(targets_.forward, x, y, next_, sight);
    set_motion(targets_.backward, x, y, before_, sight);
  }
}

// Where the point of the surface that is seen is at another moment.
void GeometryRenderer::set_motion(Layer* layer, uint32_t x, uint32_t y, const Moment& other,
                                  const Sight& sight) const {
  const uint32_t body = body_of(scene_, scene_.polygons[sight.point.polygon]);
  const Vec3 rest = inverse(now_.instant.world_from_body[body]) * sight.point.position;
  const auto there = projection(other).pixel_of(other.instant.world_from_body[body] * rest);
  if (!there) return;
  float* uv = at(layer, x, y);
  uv[0] = static_cast<float>(there->x - (x + 0.5));
  uv[1] = static_cast<float>((y + 0.5) - there->y);
}

bool GeometryRenderer::is_alike(const Sight& a, const Sight& b) const {
  if (a.point.polygon == kNone || b.point.polygon == kNone) return a.point.polygon == b.point.polygon;
  const Polygon& of_a = scene_.polygons[a.point.polygon];
  const Polygon& of_b = scene_.polygons[b.point.polygon];
  return of_a.object == of_b.object && of_a.material == of_b.material && a.reflectance == b.reflectance;
}

// Means over a pixel: of its middle, if that and points near its corners are alike, else of points spread
// over its area.
void GeometryRenderer::set_means(uint32_t x, uint32_t y, const Sight& middle) const {
  Coverage objects, materials;
  Rgb albedo;
  const auto add = [&](const Sight& sight, float share) {
    albedo += share * sight.reflectance;
    if (sight.point.polygon == kNone) return;
    objects.add(scene_.polygons[sight.point.polygon].object, share);
    materials.add(scene_.polygons[sight.point.polygon].material, share);
  };
  constexpr double kNear = 1.0 / 64;  // pixels
  bool even = true;
  for (int k = 0; k < 4 && even && options_.samples > 1; ++k) {
    const double u = (k & 1) ? 1 - kNear : kNear, v = (k >> 1) ? 1 - kNear : kNear;
    even = is_alike(middle, look(x + u, y + v));
  }
  if (even) {
    add(middle, 1);
  } else {
    const uint64_t seed = hash_of(x, y);
    for (int i = 0; i < options_.samples; ++i) {
      const Point2 p = sobol_point(static_cast<uint32_t>(i), seed);
      add(look(x + p.u, y + p.v), 1 / static_cast<float>(options_.samples));
    }
  }
  if (targets_.albedo)
    for (int c = 0; c < 3; ++c) at(targets_.albedo, x, y)[c] = albedo[c];
  if (targets_.objects) targets_.objects->set(x, y, objects);
  if (targets_.materials) targets_.materials->set(x, y, materials);
}

}  // namespace

void add_geometry_layers(const Scene& scene, const Surfaces& surfaces, const Camera& camera, double time,
                         const GeometryOptions& options, const std::vector<LayerKind>& kinds,
                         LayeredImage* image) {
  Targets targets;
  std::vector<Layer> layers;
  layers.reserve(kinds.size() + 1);  // pointers to them stay
  const auto add = [&](const char* name, const char* channels, bool exact) {
    const size_t count = std::string_view(channels).size() * options.width * options.height;
    layers.push_back({name, channels, exact, std::vector<float>(count)});
    return &layers.back();
  };
  for (const LayerKind kind : kinds) {
    switch (kind) {
      case LayerKind::kAlbedo:
        targets.albedo = add("albedo", "RGB", false);
        break;
      case LayerKind::kNormal:
        targets.normal = add("normal", "XYZ", false);
        break;
      case LayerKind::kPosition:
        targets.position = add("position", "XYZ", true);
        break;
      case LayerKind::kDepth:
        targets.depth = add("depth", "Z", true);
        break;
      case LayerKind::kMotion:
        targets.forward = add("forward", "uv", true);
        targets.backward = add("backward", "uv", true);
        break;
      case LayerKind::kObject:
        targets.objects.emplace("CryptoObject", names_of(scene.objects), options.width, options.height);
        break;
      case LayerKind::kMaterial:
        targets.materials.emplace("CryptoMaterial", names_of(scene.materials), options.width, options.height);
        break;
      default:
        break;  // light
    }
  }
  const GeometryRenderer renderer(scene, surfaces, camera, time, options, &targets);
  parallel_for(options.height, 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) renderer.row(static_cast<uint32_t>(y));
  });
  for (Layer& layer : layers) image->layers.push_back(std::move(layer));
  if (targets.objects) targets.objects->finish(image);
  if (targets.materials) targets.materials->finish(image);
}

}  // namespace strad
