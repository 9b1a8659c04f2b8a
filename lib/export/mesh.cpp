#include "export/mesh.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "scene/texture.h"
#include "solution/mesh.h"

namespace strad {
namespace {

// A point of a leaf: the vertices from whose values it is interpolated, and its position at rest.
struct LeafPoint {
  std::array<uint32_t, 4> vertices{kNone, kNone, kNone, kNone};
  std::array<float, 4> weights{};
  Vec3 position;
};

LeafPoint mean_of(const Mesh& mesh, const uint32_t* vertices, int count) {
  LeafPoint point;
  for (int i = 0; i < count; ++i) {
    point.vertices[i] = vertices[i];
    point.weights[i] = 1 / static_cast<float>(count);
    point.position += mesh.vertices[vertices[i]].position / count;
  }
  return point;
}

// The point at (u, v) of a quad.
LeafPoint between(const Mesh& mesh, const uint32_t* vertices, double u, double v) {
  const double weights[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
  LeafPoint point;
  for (size_t i = 0; i < 4; ++i) {
    point.vertices[i] = vertices[i];
    point.weights[i] = static_cast<float>(weights[i]);
    point.position += weights[i] * mesh.vertices[vertices[i]].position;
  }
  return point;
}

// All data of a corner: corners with equal keys are merged.
using CornerKey = std::tuple<std::array<uint32_t, 4>, std::array<float, 4>, double, double, double, uint32_t,
                             bool, bool, double, double, double, double, double>;

// Gathers the corners and triangles of one body.
class BodyBuilder {
 public:
  BodyBuilder(const Scene& scene, double lift) : scene_(scene), lift_(lift) {}

  void add_fan(uint32_t polygon, uint32_t side, bool lifted, const std::vector<LeafPoint>& outline) {
    const uint32_t first = corner(polygon, side, lifted, outline[0]);
    uint32_t previous = corner(polygon, side, lifted, outline[1]);
    for (size_t i = 2; i < outline.size(); ++i) {
      const uint32_t next = corner(polygon, side, lifted, outline[i]);
      if (side == 0) body_.triangles.push_back({first, previous, next});
      if (side == 1) body_.triangles.push_back({first, next, previous});
      previous = next;
    }
  }

  // The body with its corners ordered by material, so that each material has one range of them.
  ExportBody take(uint32_t body) {
    body_.body = body;
    std::vector<uint32_t> order(body_.corners.size()), rank(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
      const ExportCorner &first = body_.corners[a], &second = body_.corners[b];
      return std::tie(first.material, first.textured) < std::tie(second.material, second.textured);
    });
    std::vector<ExportCorner> sorted;
    sorted.reserve(order.size());
    for (uint32_t i = 0; i < order.size(); ++i) {
      rank[order[i]] = i;
      sorted.push_back(body_.corners[order[i]]);
    }
    body_.corners = std::move(sorted);
    for (auto& triangle : body_.triangles) {
      for (uint32_t& corner : triangle) corner = rank[corner];
    }
    return std::move(body_);
  }

 private:
  uint32_t corner(uint32_t polygon_index, uint32_t side, bool lifted, const LeafPoint& point) {
    const Polygon& polygon = scene_.polygons[polygon_index];
    ExportCorner corner;
    corner.vertices = point.vertices;
    corner.weights = point.weights;
    corner.material = polygon.material;
    corner.emits = side == 0 && emits(scene_, polygon);
    corner.textured = has_texture(scene_, polygon);
    if (corner.textured) {
      corner.uv = texture_uv(scene_, polygon, parametric_of(scene_, polygon, point.position));
    }
    corner.position = point.position;
    if (!scene_.normals.empty()) corner.normal = normal_at(polygon, side, point.position);
    if (lifted) corner.position += -lift_ * polygon_normal(scene_, polygon);
    const auto index = static_cast<uint32_t>(body_.corners.size());
    if (point.vertices[0] != kNone) {
      const CornerKey key{point.vertices,   point.weights,   point.position.x, point.position.y,
                          point.position.z, corner.material, corner.textured,  corner.emits,
                          corner.uv.x,      corner.uv.y,     corner.normal.x,  corner.normal.y,
                          corner.normal.z};
      const auto [it, added] = index_of_.try_emplace(key, index);
      if (!added) return it->second;
    }
    body_.corners.push_back(corner);
    return index;
  }

  Vec3 normal_at(const Polygon& polygon, uint32_t side, Vec3 rest_point) const {
    Vec3 normal = polygon_normal(scene_, polygon);
    if (polygon.is_smooth()) {
      const CornerWeights weights = corner_weights(polygon, parametric_of(scene_, polygon, rest_point));
      Vec3 sum;
      for (int c = 0; c < polygon.corner_count(); ++c)
        sum += weights.of[c] * scene_.normals[polygon.normals[c]];
      if (length(sum) > 1e-6) normal = normalized(sum);
    }
    return side == 0 ? normal : -normal;
  }

  const Scene& scene_;
  const double lift_;
  ExportBody body_;
  std::map<CornerKey, uint32_t> index_of_;
};

// Adds a quad as four quarters, each a fan of triangles about its centre. This has a sixteenth of the error
// of two triangles.
void add_quarters(const Mesh& mesh, const uint32_t* vertices, const Face& face, bool lifted,
                  BodyBuilder* body) {
  for (const double u : {0.25, 0.75})
    for (const double v : {0.25, 0.75}) {
      std::vector<LeafPoint> points{between(mesh, vertices, u, v)};
      for (const Vec2 d : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}, Vec2{-1, -1}})
        points.push_back(between(mesh, vertices, u + 0.25 * d.x, v + 0.25 * d.y));
      body->add_fan(face.polygon, face.side, lifted, points);
    }
}

// Adds the exported leaves below `element`, or the element itself if it is one.
void add_leaves(const Scene& scene, const Mesh& mesh, const ExportLeaves& leaves, uint32_t element,
                const Face& face, bool lifted, BodyBuilder* body) {
  const Element& e = mesh.elements[element];
  if (is_uniform(e)) {
    std::vector<LeafPoint> points;
    const Polygon& polygon = scene.polygons[face.polygon];
    for (int i = 0; i < polygon.corner_count(); ++i)
      points.push_back({{e.vertices[0], kNone, kNone, kNone}, {1}, scene.vertices[polygon.corners[i]]});
    return body->add_fan(face.polygon, face.side, lifted, points);
  }
  if (!leaves.is_leaf(element)) {
    for (uint32_t c = 0; c < 4; ++c) add_leaves(scene, mesh, leaves, e.first_child + c, face, lifted, body);
    return;
  }
  const int n = e.corner_count();
  if (n == 4 && leaves.twisted(element) && leaves.alone(element))
    return add_quarters(mesh, e.vertices, face, lifted, body);
  const std::vector<uint32_t> outline = leaves.outline(element);
  std::vector<LeafPoint> points;
  const bool about_centre = outline.size() > static_cast<size_t>(n) || leaves.twisted(element);
  if (about_centre) points.push_back(mean_of(mesh, e.vertices, n));
  for (const uint32_t v : outline) points.push_back(mean_of(mesh, &v, 1));
  if (about_centre) points.push_back(points[1]);
  body->add_fan(face.polygon, face.side, lifted, points);
}

// Adds the front of a polygon that no light reaches.
void add_dark(const Scene& scene, uint32_t polygon, BodyBuilder* body) {
  std::vector<LeafPoint> points;
  for (int i = 0; i < scene.polygons[polygon].corner_count(); ++i) {
    points.push_back({.position = scene.vertices[scene.polygons[polygon].corners[i]]});
  }
  body->add_fan(polygon, 0, false, points);
}

void add_polygon(const Scene& scene, const Mesh& mesh, const ExportLeaves& leaves, uint32_t polygon,
                 BodyBuilder* body) {
  const uint32_t front = mesh.face_of_side[2 * polygon], back = mesh.face_of_side[2 * polygon + 1];
  const bool front_shows = front != kNone || back == kNone || emits(scene, scene.polygons[polygon]);
  if (front != kNone) {
    add_leaves(scene, mesh, leaves, mesh.faces[front].element, mesh.faces[front], false, body);
  } else if (front_shows) {
    add_dark(scene, polygon, body);
  }
  if (back != kNone) {
    add_leaves(scene, mesh, leaves, mesh.faces[back].element, mesh.faces[back], front_shows, body);
  }
}

}  // namespace

std::vector<ExportBody> export_mesh(const Scene& scene, const Slab& slab, ExportLight light) {
  const ExportLeaves leaves(slab, light);
  std::vector<BodyBuilder> builders(scene.bodies.size(), BodyBuilder(scene, export_lift(scene)));
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    add_polygon(scene, slab.mesh, leaves, p, &builders[body_of(scene, scene.polygons[p])]);
  }
  std::vector<ExportBody> bodies;
  for (uint32_t b = 0; b < builders.size(); ++b) {
    ExportBody body = builders[b].take(b);
    if (!body.triangles.empty()) bodies.push_back(std::move(body));
  }
  return bodies;
}

double export_lift(const Scene& scene) {
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  return 2e-6 * box.diagonal();  // about twenty units in the last place of a float
}

Rgb corner_irradiance(const ExportCorner& corner, const std::vector<Rgb>& vertex_irradiance) {
  Rgb sum;
  for (size_t i = 0; i < 4 && corner.vertices[i] != kNone; ++i)
    sum += corner.weights[i] * vertex_irradiance[corner.vertices[i]];
  return sum;
}

}  // namespace strad
