// What the readers of all formats have in common.
#include "import/import.h"

#include <fnmatch.h>

#include <algorithm>

#include "base/error.h"
#include "base/text.h"

namespace strad {
namespace {

bool means(const MaterialLight& light, const std::string& material) {
  return fnmatch(light.pattern.c_str(), material.c_str(), 0) == 0;
}

// Throws BadInput for a light that matches no material.
void override_emissions(Scene* scene, const ImportOptions& options, const std::string& name) {
  for (const MaterialLight& light : options.lights) {
    const auto meant = [&](const Material& material) { return means(light, material.name); };
    if (std::none_of(scene->materials.begin(), scene->materials.end(), meant))
      throw BadInput(name + ": no material in use matches the light " + in_quotes(light.pattern));
  }
  for (Material& material : scene->materials)
    material.emission = overridden_emission(material.emission, material.name, options);
}

// To y up and metres.
struct Turned {
  double scale;
  bool z_is_up;
  Vec3 direction(Vec3 v) const { return z_is_up ? Vec3{v.x, v.z, -v.y} : v; }
  Vec3 point(Vec3 p) const { return scale * direction(p); }
};

void turn_scene(Scene* scene, const Turned& turned) {
  for (Vec3& vertex : scene->vertices) vertex = turned.point(vertex);
  for (Vec3& normal : scene->normals) normal = turned.direction(normal);
  for (Body& body : scene->bodies) {
    body.pivot = turned.point(body.pivot);
    body.axis = turned.direction(body.axis);
    for (BodyKey& key : body.keys) {
      key.move = turned.point(key.move);  // a difference of points: there is no shift in it
      const Vec3 v = turned.direction({key.quat.x, key.quat.y, key.quat.z});
      key.quat = {key.quat.w, v.x, v.y, v.z};
    }
  }
  for (Spot& spot : scene->spots) {
    for (SpotKey& key : spot.keys) {
      key.at = turned.point(key.at);
      key.aim = turned.point(key.aim);
      key.intensity = static_cast<float>(turned.scale * turned.scale) * key.intensity;  // the same irradiance
    }
  }
  for (Camera& camera : scene->cameras) {
    for (CameraKey& key : camera.keys) {
      key.from = turned.point(key.from);
      key.to = turned.point(key.to);
      key.up = turned.direction(key.up);
    }
  }
}

// Keeps those items of a list that are used, in their order, and renumbers the indices into it.
class Compaction {
 public:
  explicit Compaction(size_t count) : place_(count, kNone) {}
  void use(uint32_t index) {
    if (index != kNone) place_[index] = 0;
  }
  template <typename Item>
  void apply(std::vector<Item>* items) {
    uint32_t kept = 0;
    for (size_t i = 0; i < items->size(); ++i) {
      if (place_[i] == kNone) continue;
      place_[i] = kept;
      (*items)[kept++] = (*items)[i];
    }
    items->resize(kept);
  }
  uint32_t renumbered(uint32_t index) const { return index == kNone ? kNone : place_[index]; }

 private:
  std::vector<uint32_t> place_;
};

void drop_unused_points(Scene* scene) {
  Compaction vertices(scene->vertices.size()), uvs(scene->uvs.size()), normals(scene->normals.size());
  for (const Polygon& polygon : scene->polygons) {
    for (int k = 0; k < 4; ++k) {
      vertices.use(polygon.corners[k]);
      uvs.use(polygon.uvs[k]);
      normals.use(polygon.normals[k]);
    }
  }
  vertices.apply(&scene->vertices);
  uvs.apply(&scene->uvs);
  normals.apply(&scene->normals);
  for (Polygon& polygon : scene->polygons) {
    for (int k = 0; k < 4; ++k) {
      polygon.corners[k] = vertices.renumbered(polygon.corners[k]);
      polygon.uvs[k] = uvs.renumbered(polygon.uvs[k]);
      polygon.normals[k] = normals.renumbered(polygon.normals[k]);
    }
  }
}

}  // namespace

Rgb limited_reflectance(Rgb reflectance, const std::string& file, uint32_t line, ImportReport* report) {
  for (int c = 0; c < 3; ++c) {
    if (!(reflectance[c] >= 0 && reflectance[c] <= 1))
      fail_at(file, line, "reflectance " + std::to_string(reflectance[c]) + ", expected 0 to 1");
  }
  if (!(max_channel(reflectance) > kMaxReflectance)) return reflectance;
  report->add("reflectance above 0.98 is taken as 0.98: light must fade as it is reflected", file, line);
  for (int c = 0; c < 3; ++c) reflectance[c] = std::min(reflectance[c], kMaxReflectance);
  return reflectance;
}

Rgb overridden_emission(Rgb emission, const std::string& name, const ImportOptions& options) {
  for (const MaterialLight& light : options.lights)
    if (means(light, name)) emission = light.radiance;
  return emission;
}

Scene finish_import(Scene scene, const ImportOptions& options, const std::string& name) {
  if (scene.polygons.empty()) throw BadInput(name + ": has no polygons");
  override_emissions(&scene, options, name);
  drop_unused_points(&scene);
  turn_scene(&scene, {options.scale, options.up == 'z'});
  validate(scene);
  return scene;
}

}  // namespace strad
