#include "solve/nodes.h"

#include <cmath>

namespace strad {

NodeTree::NodeTree(const Scene& scene, MeshBuilder* builder) : scene_(scene), builder_(*builder) {
  const auto faces = static_cast<uint32_t>(builder_.mesh().faces.size());
  for (uint32_t f = 0; f < faces; ++f) root_of_face_.push_back(add(builder_.mesh().faces[f].element, kNone));
}

uint32_t NodeTree::add(uint32_t element, uint32_t parent) {
  Node node;
  node.element = element;
  node.parent = parent;
  node.face = builder_.face_of(element);
  const Face& face = builder_.mesh().faces[node.face];
  const Polygon& polygon = scene_.polygons[face.polygon];
  node.body = body_of(scene_, polygon);
  node.normal = (face.side == 0 ? 1.0 : -1.0) * polygon_normal(scene_, polygon);
  node.reflectance = scene_.materials[polygon.material].reflectance;
  const PatchPoints patch = patch_points(*this, node);
  const Vec3* c = patch.corners;
  double area = 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
  if (patch.corner_count == 4) area += 0.5 * length(cross(c[2] - c[0], c[3] - c[0]));
  node.area = static_cast<float>(area);
  for (int i = 0; i < patch.corner_count; ++i) node.centre += c[i] / patch.corner_count;
  for (int i = 0; i < patch.corner_count; ++i)
    node.radius = std::max(node.radius, static_cast<float>(length(c[i] - node.centre)));
  nodes_.push_back(node);
  return static_cast<uint32_t>(nodes_.size() - 1);
}

void NodeTree::split(uint32_t node) {
  const uint32_t element = nodes_[node].element;
  if (builder_.mesh().elements[element].first_child == kNone) builder_.split(element);
  const uint32_t first = builder_.mesh().elements[element].first_child;
  const auto first_child = static_cast<uint32_t>(nodes_.size());
  for (uint32_t c = 0; c < 4; ++c) add(first + c, node);
  nodes_[node].first_child = first_child;
}

uint32_t NodeTree::leaf_at(uint32_t polygon, uint32_t side, Vec3 rest_point) const {
  const uint32_t face = builder_.mesh().face_of_side[2 * polygon + side];
  if (face == kNone) return kNone;
  const Polygon& p = scene_.polygons[polygon];
  const bool quad = p.corner_count() == 4;
  Vec2 uv = parametric_of(scene_, p, rest_point);
  uint32_t node = root_of_face_[face];
  while (nodes_[node].first_child != kNone) {
    uint32_t child = 0;
    if (quad) {
      const bool right = uv.x > 0.5, top = uv.y > 0.5;
      child = right ? (top ? 2 : 1) : (top ? 3 : 0);
      uv = {2 * uv.x - right, 2 * uv.y - top};
    } else if (uv.x > 0.5) {
      child = 1;
      uv = {2 * uv.x - 1, 2 * uv.y};
    } else if (uv.y > 0.5) {
      child = 2;
      uv = {2 * uv.x, 2 * uv.y - 1};
    } else if (uv.x + uv.y < 0.5) {
      uv = {2 * uv.x, 2 * uv.y};
    } else {
      // The middle child (m12, m20, m01): its corner 0 is at (1/2, 1/2), its axes point to (0, 1/2) and (1/2,
      // 0).
      child = 3;
      uv = {1 - 2 * uv.x, 1 - 2 * uv.y};
    }
    node = nodes_[node].first_child + child;
  }
  return node;
}

PatchPoints patch_points(const NodeTree& tree, const Node& node) {
  const Mesh& mesh = tree.builder().mesh();
  const Element& element = mesh.elements[node.element];
  PatchPoints patch;
  patch.corner_count = element.corner_count();
  for (int i = 0; i < patch.corner_count; ++i) patch.corners[i] = mesh.vertices[element.vertices[i]].position;
  return patch;
}

Vec3 point_on_patch(const PatchPoints& patch, double u, double v) {
  const Vec3* c = patch.corners;
  if (patch.corner_count == 4) return lerp(lerp(c[0], c[1], u), lerp(c[3], c[2], u), v);
  const double root = std::sqrt(u);  // uniform by area (Turk 1990)
  return (1 - root) * c[0] + root * (1 - v) * c[1] + root * v * c[2];
}

}  // namespace strad
