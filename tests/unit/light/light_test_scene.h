// Scenes made by hand, for tests of light and of the solver.
#pragma once

#include <initializer_list>

#include "scene/scene.h"

namespace strad {

// A quad (or triangle) of an object of its own on `body`, with a material of its own. Returns the polygon.
inline uint32_t add_polygon(Scene* scene, std::initializer_list<Vec3> corners, uint32_t body = 0,
                            Rgb reflectance = {0.5f, 0.5f, 0.5f}, Rgb emission = {}) {
  Polygon polygon;
  int corner = 0;
  for (const Vec3& at : corners) {
    polygon.corners[corner++] = static_cast<uint32_t>(scene->vertices.size());
    scene->vertices.push_back(at);
  }
  Material material;
  material.reflectance = reflectance;
  material.emission = emission;
  polygon.material = static_cast<uint32_t>(scene->materials.size());
  polygon.object = static_cast<uint32_t>(scene->objects.size());
  scene->materials.push_back(material);
  scene->objects.push_back({"object" + std::to_string(polygon.object), body});
  scene->polygons.push_back(polygon);
  return static_cast<uint32_t>(scene->polygons.size() - 1);
}

// The six sides of a box, seen from inside (`inwards`) or from outside. Returns the first of six polygons:
// floor, ceiling, south, north, west, east.
inline uint32_t add_box(Scene* scene, Vec3 l, Vec3 u, bool inwards, uint32_t body = 0,
                        Rgb reflectance = {0.5f, 0.5f, 0.5f}, Rgb emission = {}) {
  const auto at = [&](int x, int y, int z) { return Vec3{x ? u.x : l.x, y ? u.y : l.y, z ? u.z : l.z}; };
  const auto side = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return inwards ? add_polygon(scene, {a, b, c, d}, body, reflectance, emission)
                   : add_polygon(scene, {d, c, b, a}, body, reflectance, emission);
  };
  const uint32_t first = side(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0));
  side(at(0, 0, 1), at(0, 1, 1), at(1, 1, 1), at(1, 0, 1));
  side(at(0, 0, 0), at(0, 0, 1), at(1, 0, 1), at(1, 0, 0));
  side(at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1));
  side(at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1));
  side(at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0));
  return first;
}

// A body that goes from rest to `move` and `turn` (radians about `axis`) during the whole animation.
inline uint32_t add_body(Scene* scene, Vec3 move, double turn = 0, Vec3 axis = {0, 1, 0}, Vec3 pivot = {},
                         uint32_t parent = 0) {
  Body body;
  body.name = "body" + std::to_string(scene->bodies.size());
  body.parent = parent;
  body.pivot = pivot;
  body.axis = axis;
  BodyKey begin, end;
  begin.time = scene->start;
  end.time = scene->end;
  end.move = move;
  end.turn = turn;
  body.keys = {begin, end};
  scene->bodies.push_back(body);
  return static_cast<uint32_t>(scene->bodies.size() - 1);
}

inline void add_spot(Scene* scene, Vec3 at, Vec3 aim, double inner, double outer, Rgb intensity) {
  Spot spot;
  spot.name = "spot" + std::to_string(scene->spots.size());
  spot.inner = inner;
  spot.outer = outer;
  spot.keys = {{0, at, aim, intensity}};
  scene->spots.push_back(spot);
}

}  // namespace strad
