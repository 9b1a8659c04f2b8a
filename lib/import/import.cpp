// What the readers of all formats have in common.
#include "import/import.h"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/text.h"
#include "base/utf8.h"
#include "import/coincident_lamps.h"

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

// Names as UTF-8. Old programs write one byte a character.
class NameRepair {
 public:
  template <class Named>
  void repair(std::vector<Named>* things) {
    for (Named& thing : *things) {
      if (is_utf8(thing.name)) continue;
      thing.name = utf8_from_latin1(thing.name);
      if (++count_ == 1) first_ = thing.name;
    }
  }
  void tell(const std::string& file, ImportReport* report) const {
    if (count_ == 0) return;
    report->add(std::to_string(count_) + " names that are not UTF-8 are taken as Latin-1, such as " +
                    in_quotes(first_),
                file, 0);
  }

 private:
  size_t count_ = 0;
  std::string first_;
};

void repair_names(Scene* scene, const std::string& file, ImportReport* report) {
  NameRepair repair;
  repair.repair(&scene->textures);
  repair.repair(&scene->materials);
  repair.repair(&scene->objects);
  repair.repair(&scene->bodies);
  repair.repair(&scene->spots);
  repair.repair(&scene->cameras);
  repair.tell(file, report);
}

// Vertices are stored as floats, and lights fall with the squares of lengths.
void check_size(const Scene& scene, const std::string& name, ImportReport* report) {
  constexpr double kSmallest = 1e-9, kTold = 1e-4;
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  const double size = box.diagonal();
  char text[128];
  if (!(size >= kSmallest)) {
    std::snprintf(text, sizeof text, ": is %.3g m in size, expected 1e-9 m or more", size);
    throw BadInput(name + text);
  }
  float farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(static_cast<float>(box.lower[axis])),
                         std::abs(static_cast<float>(box.upper[axis]))});
  const double error = 0.5 * (static_cast<double>(std::nextafter(farthest, INFINITY)) - farthest);
  if (!(error > kTold * size)) return;
  std::snprintf(text, sizeof text, "so far from the origin, vertices are stored with errors of up to %.1g m",
                error);
  report->add(text, name, 0);
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

void limit_energy(Material* material, const std::string& file, uint32_t line, ImportReport* report) {
  const Finish& finish = material->finish;
  if (!(finish.ior >= kLeastIor && finish.ior <= kMostIor))
    fail_at(file, line,
            "found the index of refraction " + std::to_string(finish.ior) + ", expected 0.01 to 100");
  if (is_plain(finish)) return;
  const float n = finish.ior;
  const float straight = finish.fresnel ? (n - 1) * (n - 1) / ((n + 1) * (n + 1)) : 1;
  bool lowered = false;
  for (int c = 0; c < 3; ++c) {
    const float mirrored = straight * finish.specular[c];
    const float left = 1 - mirrored - (1 - mirrored) * finish.transmission[c];
    if (!(material->reflectance[c] > std::max(left, 0.0f) + 1e-6f)) continue;
    material->reflectance[c] = std::max(left, 0.0f);
    lowered = true;
  }
  if (lowered)
    report->add("diffuse reflectance is lowered to what mirror and glass leave of the light", file, line);
}

Rgb overridden_emission(Rgb emission, const std::string& name, const ImportOptions& options) {
  for (const MaterialLight& light : options.lights)
    if (means(light, name)) emission = light.radiance;
  return emission;
}

Scene finish_import(Scene scene, const ImportOptions& options, const std::string& name,
                    ImportReport* report) {
  if (scene.polygons.empty()) throw BadInput(name + ": has no polygons");
  repair_names(&scene, name, report);
  override_emissions(&scene, options, name);
  drop_unused_points(&scene);
  turn_scene(&scene, {options.scale, options.up == 'z'});
  try {
    validate(scene);
  } catch (const BadInput& fault) {
    throw BadInput(name + ": " + fault.what());
  }
  check_size(scene, name, report);
  tell_coincident_lamps(scene, name, report);
  return scene;
}

}  // namespace strad
