#include "solve/prepare/connected_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/none.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

struct Edge {
  Vec3 low, high;
  uint32_t polygon;
};

auto order_of(Vec3 a) { return std::tuple(a.x, a.y, a.z); }

// The edges of all polygons, those at the same place in a row.
std::vector<Edge> sorted_edges(const Scene& scene) {
  std::vector<Edge> edges;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const int n = scene.polygons[p].corner_count();
    for (int i = 0; i < n; ++i) {
      const Vec3 a = scene.vertices[scene.polygons[p].corners[i]];
      const Vec3 b = scene.vertices[scene.polygons[p].corners[(i + 1) % n]];
      const bool forward = order_of(a) < order_of(b);
      edges.push_back({forward ? a : b, forward ? b : a, p});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tuple(order_of(a.low), order_of(a.high), a.polygon) <
           std::tuple(order_of(b.low), order_of(b.high), b.polygon);
  });
  return edges;
}

// Joins the sides that bound each wedge about an edge.
void join_around(const Scene& scene, const Edge* begin, const Edge* end, DisjointSets* sets) {
  struct Leaf {
    double angle;
    uint32_t polygon, ahead;  // the side that faces growing angles
  };
  const Frame frame = frame_about(normalized(begin->high - begin->low));
  std::vector<Leaf> leaves;
  for (const Edge* edge = begin; edge != end; ++edge) {
    const Polygon& polygon = scene.polygons[edge->polygon];
    Vec3 centre;
    for (int c = 0; c < polygon.corner_count(); ++c)
      centre += scene.vertices[polygon.corners[c]] / polygon.corner_count();
    const Vec3 into = centre - begin->low;
    const double x = dot(into, frame.tangent), y = dot(into, frame.bitangent);
    const Vec3 turning = x * frame.bitangent - y * frame.tangent;
    const uint32_t back = dot(polygon_normal(scene, polygon), turning) < 0;
    leaves.push_back({std::atan2(y, x), edge->polygon, 2 * edge->polygon + back});
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return std::tie(a.angle, a.polygon) < std::tie(b.angle, b.polygon);
  });
  for (size_t i = 0; i < leaves.size(); ++i)
    sets->join(leaves[i].ahead, leaves[(i + 1) % leaves.size()].ahead ^ 1u);
}

// Of a side of a polygon: the sum over a closed surface is negative when seen from within.
double volume_of(const Scene& scene, uint32_t side) {
  const double volume = six_volumes(scene, scene.polygons[side / 2], scene.vertices.front());
  return side % 2 ? -volume : volume;
}

}  // namespace

ConnectedSurfaces::ConnectedSurfaces(const Scene& scene) {
  const auto sides = static_cast<uint32_t>(2 * scene.polygons.size());
  DisjointSets sets(sides);
  std::vector<bool> has_open_edge(scene.polygons.size(), false);
  const std::vector<Edge> edges = sorted_edges(scene);
  for (size_t i = 0; i < edges.size();) {
    size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end - i == 1)
      has_open_edge[edges[i].polygon] = true;
    else
      join_around(scene, &edges[i], edges.data() + end, &sets);
    i = end;
  }
  surface_of_side_.resize(sides);
  for (uint32_t side = 0; side < sides; ++side) {
    const uint32_t lowest = sets.find(side);
    if (lowest == side) {
      surface_of_side_[side] = count();
      first_.push_back(0);
    }
    surface_of_side_[side] = surface_of_side_[lowest];
    ++first_[surface_of_side_[side] + 1];
  }
  for (size_t s = 1; s < first_.size(); ++s) first_[s] += first_[s - 1];
  sides_.resize(sides);
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  std::vector<double> volume(count(), 0.0);
  encloses_.assign(count(), true);
  for (uint32_t side = 0; side < sides; ++side) {
    const uint32_t surface = surface_of_side_[side];
    sides_[next[surface]++] = side;
    volume[surface] += volume_of(scene, side);
    if (has_open_edge[side / 2]) encloses_[surface] = false;
  }
  for (uint32_t s = 0; s < count(); ++s)
    if (!(volume[s] < 0)) encloses_[s] = false;
}

}  // namespace strad
