#include "frame/emitter_groups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <tuple>

#include "base/disjoint_sets.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

// Material, body, and where an edge begins and ends.
using EdgePlaces = std::tuple<uint32_t, uint32_t, std::array<double, 6>>;
constexpr double kCosSharp = 0.5;  // of the angle between normals across an edge

std::vector<uint32_t> emitting_polygons(const Scene& scene) {
  std::vector<uint32_t> emitting;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    if (emits(scene, scene.polygons[p])) emitting.push_back(p);
  return emitting;
}

EdgePlaces places_of(const Scene& scene, const Polygon& polygon, int corner) {
  const Vec3 a = scene.vertices[polygon.corners[corner]],
             b = scene.vertices[polygon.corners[(corner + 1) % polygon.corner_count()]];
  const std::array<double, 6> there{a.x, a.y, a.z, b.x, b.y, b.z}, back{b.x, b.y, b.z, a.x, a.y, a.z};
  return {polygon.material, body_of(scene, polygon), std::min(there, back)};
}

Vec3 centre_of(const Scene& scene, const Polygon& polygon) {
  Vec3 centre;
  for (int c = 0; c < polygon.corner_count(); ++c)
    centre += scene.vertices[polygon.corners[c]] / polygon.corner_count();
  return centre;
}

// Do two polygons with a common edge face each other, as walls of a room do? Then they are lights apart:
// close to one of them its irradiance is found exactly, and rays shared with the other would make that
// noisier.
bool face_each_other(const Scene& scene, const Polygon& a, const Polygon& b) {
  const Vec3 normal = polygon_normal(scene, a);
  return dot(normal, polygon_normal(scene, b)) < kCosSharp &&
         dot(normal, centre_of(scene, b) - centre_of(scene, a)) > 0;
}

// Which of the emitting polygons belong together.
DisjointSets connected(const Scene& scene, const std::vector<uint32_t>& emitting) {
  DisjointSets sets(emitting.size());
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> first_of_object;
  std::map<EdgePlaces, uint32_t> first_at_edge;
  for (uint32_t i = 0; i < emitting.size(); ++i) {
    const Polygon& polygon = scene.polygons[emitting[i]];
    sets.join(i, first_of_object.try_emplace({polygon.object, polygon.material}, i).first->second);
    for (int c = 0; c < polygon.corner_count(); ++c) {
      const uint32_t first = first_at_edge.try_emplace(places_of(scene, polygon, c), i).first->second;
      if (first != i && !face_each_other(scene, scene.polygons[emitting[first]], polygon))
        sets.join(i, first);
    }
  }
  return sets;
}

struct Facet {
  uint32_t polygon;
  Vec3 centre;
};

// Halves the facets at the median along the longest side of their box, and the halves again.
void order_as_tree(std::vector<Facet>* facets, size_t begin, size_t end) {
  if (end - begin < 3) return;
  Box box;
  for (size_t i = begin; i < end; ++i) box.add((*facets)[i].centre);
  const Vec3 size = box.upper - box.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto before = [&](const Facet& a, const Facet& b) {
    return std::pair(a.centre[axis], a.polygon) < std::pair(b.centre[axis], b.polygon);
  };
  const size_t middle = (begin + end) / 2;
  const auto at = [&](size_t i) { return facets->begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), before);
  order_as_tree(facets, begin, middle);
  order_as_tree(facets, middle, end);
}

void add_corners(const Scene& scene, EmitterGroup* group) {
  std::map<std::tuple<double, double, double>, uint32_t> known;
  for (const uint32_t p : group->polygons) {
    const Polygon& polygon = scene.polygons[p];
    std::array<uint32_t, 4>& corners = group->corners.emplace_back();
    corners.fill(kNone);
    for (int c = 0; c < polygon.corner_count(); ++c) {
      const Vec3 at = scene.vertices[polygon.corners[c]];
      const auto [it, is_new] =
          known.try_emplace({at.x, at.y, at.z}, static_cast<uint32_t>(group->vertices.size()));
      if (is_new) group->vertices.push_back(at);
      corners[static_cast<size_t>(c)] = it->second;
    }
  }
}

void add_edges(EmitterGroup* group) {
  const uint32_t none = static_cast<uint32_t>(group->corners.size());
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> single;  // edges without a neighbour so far
  for (uint32_t f = 0; f < group->corners.size(); ++f) {
    const auto& corners = group->corners[f];
    const size_t count = corners[3] == kNone ? 3 : 4;
    for (size_t c = 0; c < count; ++c) {
      const uint32_t from = corners[c], to = corners[(c + 1) % count];
      const auto other = single.find({to, from});
      if (other != single.end()) {
        group->edges[other->second].right = f;
        single.erase(other);
      } else {
        single.insert_or_assign({from, to}, static_cast<uint32_t>(group->edges.size()));
        group->edges.push_back({from, to, f, none});
      }
    }
  }
}

}  // namespace

std::vector<EmitterGroup> emitter_groups(const Scene& scene) {
  const std::vector<uint32_t> emitting = emitting_polygons(scene);
  DisjointSets sets = connected(scene, emitting);
  std::map<uint32_t, std::vector<Facet>> members;
  for (uint32_t i = 0; i < emitting.size(); ++i) {
    const Polygon& polygon = scene.polygons[emitting[i]];
    members[sets.find(i)].push_back({emitting[i], centre_of(scene, polygon)});
  }
  std::vector<EmitterGroup> groups;
  for (auto& [first, facets] : members) {
    order_as_tree(&facets, 0, facets.size());
    const Polygon& polygon = scene.polygons[emitting[first]];
    EmitterGroup& group = groups.emplace_back();
    group.material = polygon.material;
    group.body = body_of(scene, polygon);
    for (const Facet& facet : facets) group.polygons.push_back(facet.polygon);
    add_corners(scene, &group);
    add_edges(&group);
    group.views = GroupViews(group);
  }
  return groups;
}

}  // namespace strad
