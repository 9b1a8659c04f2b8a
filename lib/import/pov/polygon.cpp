// POV-Ray's polygons of several rings. Holes are joined to the ring around them by bridges.
#include <algorithm>
#include <cmath>
#include <optional>

#include "import/polygonize.h"
#include "import/pov/shapes.h"

namespace strad {
namespace {

// A ring in the common plane of all.
struct FlatRing {
  std::vector<Vec2> points;
  std::vector<uint32_t> corners;
  double area = 0;  // signed
};

bool contains(const FlatRing& ring, Vec2 p) {
  bool inside = false;
  for (size_t i = 0, j = ring.points.size() - 1; i < ring.points.size(); j = i++) {
    const Vec2 a = ring.points[i], b = ring.points[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

size_t count_inside(const FlatRing& ring, const FlatRing& inner) {
  size_t inside = 0;
  for (const Vec2 p : inner.points) inside += contains(ring, p);
  return inside;
}

// Whether most of `inner` is in `ring`: they may touch in some points.
bool contains(const FlatRing& ring, const FlatRing& inner) {
  return 2 * count_inside(ring, inner) > inner.points.size();
}

// The outline that a hole is in: the smallest that has most of its corners, else that which has the most.
const FlatRing* around(const FlatRing& hole, const std::vector<FlatRing>& rings) {
  const FlatRing* best = nullptr;
  for (const FlatRing& ring : rings) {
    if (!(ring.area > 0)) continue;
    const bool better =
        !best || (contains(ring, hole) == contains(*best, hole)
                      ? (contains(ring, hole) ? ring.area < best->area
                                              : count_inside(ring, hole) > count_inside(*best, hole))
                      : contains(ring, hole));
    if (better) best = &ring;
  }
  return best;
}

// Whether the segments a b and c d cross in the inside of both.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross2(b - a, c - a) * cross2(b - a, d - a) < 0 && cross2(d - c, a - c) * cross2(d - c, b - c) < 0;
}

bool crosses(const FlatRing& ring, Vec2 a, Vec2 b) {
  for (size_t i = 0; i < ring.points.size(); ++i)
    if (cross_each_other(a, b, ring.points[i], ring.points[(i + 1) % ring.points.size()])) return true;
  return false;
}

void reverse(FlatRing* ring) {
  std::reverse(ring->points.begin(), ring->points.end());
  std::reverse(ring->corners.begin(), ring->corners.end());
  ring->area = -ring->area;
}

// Joins a hole to the outline: along the shortest bridge that crosses nothing, around the hole, and back.
void join(FlatRing* outline, const FlatRing& hole, const std::vector<const FlatRing*>& others) {
  double shortest = std::numeric_limits<double>::infinity();
  size_t from = 0, to = 0;
  for (size_t i = 0; i < outline->points.size(); ++i) {
    for (size_t j = 0; j < hole.points.size(); ++j) {
      const Vec2 a = outline->points[i], b = hole.points[j];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (length >= shortest || crosses(*outline, a, b) || crosses(hole, a, b)) continue;
      if (std::any_of(others.begin(), others.end(),
                      [&](const FlatRing* other) { return crosses(*other, a, b); }))
        continue;
      shortest = length, from = i, to = j;
    }
  }
  FlatRing joined;
  const auto add = [&joined](const FlatRing& ring, size_t i) {
    joined.points.push_back(ring.points[i % ring.points.size()]);
    joined.corners.push_back(ring.corners[i % ring.corners.size()]);
  };
  for (size_t i = 0; i <= from; ++i) add(*outline, i);
  for (size_t j = 0; j <= hole.points.size(); ++j) add(hole, to + j);
  for (size_t i = from; i < outline->points.size(); ++i) add(*outline, i);
  outline->points = std::move(joined.points);
  outline->corners = std::move(joined.corners);
}

std::vector<FlatRing> flattened(const std::vector<std::vector<Vec3>>& rings, Vec3 normal, PovObject* object) {
  const Frame frame = frame_about(normal);
  std::vector<FlatRing> flat;
  for (const std::vector<Vec3>& ring : rings) {
    FlatRing& to = flat.emplace_back();
    for (const Vec3 p : ring) {
      to.points.push_back({dot(p - rings[0][0], frame.tangent), dot(p - rings[0][0], frame.bitangent)});
      to.corners.push_back(static_cast<uint32_t>(object->points.size()));
      object->points.push_back(p);
    }
    to.area = dot(doubled_area(ring), frame.normal) / 2;
  }
  return flat;
}

// Turns rings so that outlines are counter-clockwise and holes clockwise.
void orient(std::vector<FlatRing>* flat) {
  for (FlatRing& ring : *flat) {
    int depth = 0;
    for (const FlatRing& other : *flat) depth += &other != &ring && contains(other, ring);
    if ((ring.area > 0) != (depth % 2 == 0)) reverse(&ring);
  }
}

// Each outline with its holes as a facet.
void add_facets(std::vector<FlatRing> flat, PovObject* object) {
  std::vector<std::vector<const FlatRing*>> holes(flat.size());
  const std::vector<FlatRing> rings = flat;
  for (const FlatRing& ring : rings)
    if (!(ring.area > 0))
      if (const FlatRing* outline = around(ring, rings))
        holes[static_cast<size_t>(outline - rings.data())].push_back(&ring);
  for (size_t i = 0; i < flat.size(); ++i) {
    if (!(flat[i].area > 0)) continue;
    while (!holes[i].empty()) {
      const FlatRing* hole = holes[i].back();
      holes[i].pop_back();
      join(&flat[i], *hole, holes[i]);
    }
    PovFacet facet;
    facet.corners = flat[i].corners;
    object->facets.push_back(std::move(facet));
  }
}

}  // namespace

PovObject pov_polygon(const std::vector<std::vector<Vec3>>& rings) {
  const auto largest = std::max_element(rings.begin(), rings.end(), [](const auto& a, const auto& b) {
    return length(doubled_area(a)) < length(doubled_area(b));
  });
  PovObject object;
  std::vector<FlatRing> flat = flattened(rings, normalized(doubled_area(*largest)), &object);
  orient(&flat);
  add_facets(std::move(flat), &object);
  return object;
}

PovObject pov_oriented_polygon(const std::vector<std::vector<Vec3>>& rings, Vec3 normal) {
  PovObject object;
  add_facets(flattened(rings, normal, &object), &object);
  return object;
}

}  // namespace strad
