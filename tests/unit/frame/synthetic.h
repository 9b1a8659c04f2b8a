// Scenes and solutions made by hand, for tests of frames.
#pragma once

#include <functional>

#include "scene/scene.h"
#include "solution/solution.h"

namespace strad {

// A quad of an object of its own, with a material of its own.
inline uint32_t add_quad(Scene* scene, Vec3 a, Vec3 b, Vec3 c, Vec3 d, Rgb reflectance = {0.5f, 0.5f, 0.5f},
                         Rgb emission = {}) {
  const uint32_t first = static_cast<uint32_t>(scene->vertices.size());
  for (const Vec3 corner : {a, b, c, d}) scene->vertices.push_back(corner);
  Material material;
  material.reflectance = reflectance;
  material.emission = emission;
  scene->materials.push_back(material);
  scene->objects.push_back({"object" + std::to_string(scene->objects.size()), 0});
  Polygon polygon{{first, first + 1, first + 2, first + 3}, {kNone, kNone, kNone, kNone}, 0, 0};
  polygon.material = static_cast<uint32_t>(scene->materials.size() - 1);
  polygon.object = static_cast<uint32_t>(scene->objects.size() - 1);
  scene->polygons.push_back(polygon);
  return static_cast<uint32_t>(scene->polygons.size() - 1);
}

// The inside of a box, seen from its fronts: six quads.
inline void add_room(Scene* scene, Vec3 l, Vec3 u, Rgb reflectance, Rgb emission) {
  const auto at = [&](int x, int y, int z) { return Vec3{x ? u.x : l.x, y ? u.y : l.y, z ? u.z : l.z}; };
  const auto wall = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    add_quad(scene, a, b, c, d, reflectance, emission);
  };
  wall(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0));
  wall(at(0, 0, 1), at(0, 1, 1), at(1, 1, 1), at(1, 0, 1));
  wall(at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1));
  wall(at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0));
  wall(at(0, 0, 0), at(0, 0, 1), at(1, 0, 1), at(1, 0, 0));
  wall(at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1));
}

inline void add_camera(Scene* scene, Vec3 from, Vec3 to, Vec3 up, double fov_degrees) {
  scene->cameras.push_back({"main", {{0, from, to, up, fov_degrees * kPi / 180}}});
}

// One face per side, without subdivision; indirect irradiance at its vertices from `value` of the rest
// position, held over [begin, end].
inline Slab plain_slab(const Scene& scene, double begin, double end, const std::function<Rgb(Vec3)>& value) {
  Slab slab;
  slab.grid.spans = {{begin, end, 0, 0}};
  slab.mesh.face_of_side.assign(2 * scene.polygons.size(), kNone);
  for (uint32_t side = 0; side < 2 * scene.polygons.size(); ++side) {
    const Polygon& polygon = scene.polygons[side / 2];
    Element root;
    for (int i = 0; i < polygon.corner_count(); ++i) {
      root.vertices[i] = static_cast<uint32_t>(slab.mesh.vertices.size());
      slab.mesh.vertices.push_back({{kNone, kNone, kNone, kNone}, scene.vertices[polygon.corners[i]]});
      slab.indirect.pieces.push_back({0, 0});
      slab.indirect.coefficients.push_back(value(slab.mesh.vertices.back().position));
      slab.indirect.first_piece.push_back(static_cast<uint32_t>(slab.indirect.pieces.size()));
      slab.direct.first_piece.push_back(0);
    }
    slab.mesh.face_of_side[side] = static_cast<uint32_t>(slab.mesh.faces.size());
    slab.mesh.faces.push_back({side / 2, side % 2, static_cast<uint32_t>(slab.mesh.elements.size())});
    slab.mesh.elements.push_back(root);
  }
  return slab;
}
inline Slab even_slab(const Scene& scene, Rgb value) {
  return plain_slab(scene, scene.start, scene.end, [&](Vec3) { return value; });
}

}  // namespace strad
