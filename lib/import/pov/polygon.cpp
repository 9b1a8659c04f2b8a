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
  int depth = 0;    // number of other rings around it
};

bool contains(const FlatRing& ring, Vec2 p) {
  bool inside = false;
  for (size_t i = 0, j = ring.points.size() - 1; i < ring.points.size(); j = i++) {
    const Vec2 a = ring.points[i], b = ring.points[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
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

std::vector<FlatRing> flattened(const std::vector<std::vector<Vec3>>& rings, PovObject* object) {
  const auto largest = std::max_element(rings.begin(), rings.end(), [](const auto& a, const auto& b) {
    return length(doubled_area(a)) < length(doubled_area(b));
  });
  const Frame frame = frame_about(normalized(doubled_area(*largest)));
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
  for (FlatRing& ring : flat) {
    for (const FlatRing& other : flat) ring.depth += &other != &ring && contains(other, ring.points[0]);
    if ((ring.area > 0) != (ring.depth % 2 == 0))
      reverse(&ring);  // outlines counter-clockwise, holes clockwise
  }
  return flat;
}

}  // namespace

PovObject pov_polygon(const std::vector<std::vector<Vec3>>& rings) {
  PovObject object;
  std::vector<FlatRing> flat = flattened(rings, &object);
  for (FlatRing& outline : flat) {
    if (outline.depth % 2 != 0) continue;
    std::vector<const FlatRing*> holes;
    const FlatRing around = outline;
    for (const FlatRing& hole : flat)
      if (hole.depth == outline.depth + 1 && contains(around, hole.points[0])) holes.push_back(&hole);
    while (!holes.empty()) {
      const FlatRing* hole = holes.back();
      holes.pop_back();
      join(&outline, *hole, holes);
    }
    PovFacet facet;
    facet.corners = outline.corners;
    object.facets.push_back(std::move(facet));
  }
  return object;
}

}  // namespace strad
