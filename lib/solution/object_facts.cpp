#include "solution/object_facts.h"

#include <set>

#include "scene/polygon_geometry.h"

namespace strad {
namespace {

// Some of the scene's polygons.
struct Part {
  size_t polygons = 0;
  double area = 0;  // m^2
  Box bounds;
  std::set<uint32_t> materials;

  void add(const Scene& scene, const Polygon& polygon) {
    ++polygons;
    area += polygon_area(scene, polygon);
    for (int c = 0; c < polygon.corner_count(); ++c) bounds.add(scene.vertices[polygon.corners[c]]);
    materials.insert(polygon.material);
  }
};

Fact size_of(const Part& part, FactGroup names) {
  names.push_back({"polygons", number_fact(part.polygons)});
  names.push_back({"area m^2", number_fact(static_cast<float>(part.area))});
  names.push_back({"bounds m", box_fact(part.bounds)});
  return {std::move(names)};
}

std::string names_of(const Scene& scene, const std::set<uint32_t>& materials) {
  std::string names;
  for (const uint32_t material : materials)
    names += (names.empty() ? "" : " ") + scene.materials[material].name;
  return names;
}

}  // namespace

Fact object_facts(const Scene& scene) {
  std::vector<Part> objects(scene.objects.size()), materials(scene.materials.size()),
      bodies(scene.bodies.size());
  for (const Polygon& polygon : scene.polygons) {
    objects[polygon.object].add(scene, polygon);
    materials[polygon.material].add(scene, polygon);
    bodies[body_of(scene, polygon)].add(scene, polygon);
  }
  FactList object_list, material_list, body_list;
  for (size_t i = 0; i < objects.size(); ++i) {
    const Object& object = scene.objects[i];
    object_list.push_back(
        size_of(objects[i], {{"name", text_fact(object.name)},
                             {"body", text_fact(scene.bodies[object.body].name)},
                             {"materials", text_fact(names_of(scene, objects[i].materials))}}));
  }
  for (size_t i = 0; i < materials.size(); ++i)
    material_list.push_back(size_of(materials[i], {{"name", text_fact(scene.materials[i].name)}}));
  for (size_t i = 0; i < bodies.size(); ++i)
    body_list.push_back(size_of(bodies[i], {{"name", text_fact(scene.bodies[i].name)}}));
  return {FactGroup{{"of objects", {std::move(object_list)}},
                    {"of materials", {std::move(material_list)}},
                    {"of bodies", {std::move(body_list)}}}};
}

}  // namespace strad
