#include "solve/mesh/polygon_joints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "base/rng.h"
#include "scene/polygon_geometry.h"
#include "solution/mesh.h"

namespace strad {
namespace {

// Of the largest angle between parts of one curved surface.
const double kCosCurved = std::cos(30 * kPi / 180);

// For each vertex the first vertex at the same place. So faces meet even if the file repeats their vertices.
std::vector<uint32_t> merged_positions(const std::vector<Vec3>& vertices) {
  std::vector<uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](uint32_t v) { return std::tuple(vertices[v].x, vertices[v].y, vertices[v].z, v); };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  for (size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && vertices[order[i]] == vertices[order[i - 1]] ? first[order[i - 1]] : order[i];
  return first;
}

}  // namespace

size_t CornerHash::operator()(const CornerKey& key) const {
  uint64_t h = hash_of(key.position, key.body, key.side);
  for (const int n : key.normal) h = mix64(h ^ static_cast<uint64_t>(static_cast<int64_t>(n)));
  return h;
}

PolygonJoints::PolygonJoints(const Scene& scene)
    : scene_(scene), position_of_vertex_(merged_positions(scene.vertices)) {}

CornerKey PolygonJoints::corner(uint32_t polygon, uint32_t side, int corner) const {
  const Polygon& p = scene_.polygons[polygon];
  const Vec3 n = polygon_normal(scene_, p);
  const auto coarse = [](double x) { return static_cast<int>(std::lround(x * 1000)); };
  return {position_of_vertex_[p.corners[corner]],
          body_of(scene_, p),
          side,
          {coarse(n.x), coarse(n.y), coarse(n.z)}};
}

uint64_t PolygonJoints::edge(uint32_t polygon, int corner) const {
  const Polygon& p = scene_.polygons[polygon];
  return edge_key(position_of_vertex_[p.corners[corner]],
                  position_of_vertex_[p.corners[(corner + 1) % p.corner_count()]]);
}

bool PolygonJoints::continues(uint32_t polygon, uint32_t other) const {
  const Polygon &p = scene_.polygons[polygon], &q = scene_.polygons[other];
  return body_of(scene_, p) == body_of(scene_, q) &&
         dot(polygon_normal(scene_, p), polygon_normal(scene_, q)) >= kCosCurved;
}

}  // namespace strad
