#include "solve/links/nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/rng.h"
#include "scene/texture.h"

namespace strad {
namespace {

// Groups of so few faces get no further steps of the octree, which would cost more links than they save.
constexpr uint32_t kFlat = 8;

Box box_of(const Scene& scene, const Face& face) {
  Box box;
  const PatchPoints points = face_points(scene, face);
  for (int i = 0; i < points.corner_count; ++i) box.add(points.corners[i]);
  return box;
}

double largest_extent(const Box& box) {
  const Vec3 size = box.upper - box.lower;
  return std::max({size.x, size.y, size.z});
}

double farthest_corner(const Box& box, Vec3 from) {
  Vec3 d;
  for (int i = 0; i < 3; ++i) d[i] = std::max(from[i] - box.lower[i], box.upper[i] - from[i]);
  return length(d);
}

}  // namespace

NodeTree::NodeTree(const Scene& scene, MeshBuilder* builder, bool clusters)
    : scene_(scene), builder_(*builder) {
  const std::vector<Face>& faces = builder_.mesh().faces;
  if (std::any_of(scene.polygons.begin(), scene.polygons.end(),
                  [&](const Polygon& polygon) { return may_have_holes(scene, polygon); }))
    for (const Polygon& polygon : scene.polygons)
      coverage_.push_back(static_cast<float>(coverage_of(scene, polygon)));
  node_of_face_.assign(faces.size(), kNone);
  if (!clusters) {
    for (const Face& face : faces) add_patch(face.element, kNone);
    return;
  }
  const auto body = [&](uint32_t f) { return body_of(scene, scene.polygons[faces[f].polygon]); };
  for (uint32_t f = 0; f < faces.size(); ++f) cluster_faces_.push_back(f);
  std::stable_sort(cluster_faces_.begin(), cluster_faces_.end(),
                   [&](uint32_t a, uint32_t b) { return body(a) < body(b); });
  for (uint32_t first = 0; first < faces.size();) {
    uint32_t end = first;
    while (end < faces.size() && body(cluster_faces_[end]) == body(cluster_faces_[first])) ++end;
    add_cluster(first, end - first, kNone);
    first = end;
  }
}

Vec3 NodeTree::face_normal(uint32_t face) const {
  const Face& f = builder_.mesh().faces[face];
  return (f.side == 0 ? 1.0 : -1.0) * polygon_normal(scene_, scene_.polygons[f.polygon]);
}

double NodeTree::face_area(uint32_t face) const {
  return polygon_area(scene_, scene_.polygons[builder_.mesh().faces[face].polygon]);
}

float NodeTree::face_coverage(uint32_t face) const {
  return coverage_.empty() ? 1 : coverage_[builder_.mesh().faces[face].polygon];
}

uint32_t NodeTree::add_patch(uint32_t element, uint32_t parent) {
  const auto index = static_cast<uint32_t>(nodes_.size());
  Node node;
  node.element = element;
  node.parent = parent;
  node.slot = static_cast<uint32_t>(slot_count_++);
  node.face = builder_.face_of(element);
  const Face& face = builder_.mesh().faces[node.face];
  const Polygon& polygon = scene_.polygons[face.polygon];
  node.body = body_of(scene_, polygon);
  node.normal = face_normal(node.face);
  node.reflectance = scene_.materials[polygon.material].reflectance;
  node.coverage = face_coverage(node.face);
  const PatchPoints patch = patch_points(*this, node);
  node.area = static_cast<float>(area_of(patch.corners, patch.corner_count));
  for (int i = 0; i < patch.corner_count; ++i) node.centre += patch.corners[i] / patch.corner_count;
  for (int i = 0; i < patch.corner_count; ++i)
    node.radius = std::max(node.radius, static_cast<float>(length(patch.corners[i] - node.centre)));
  if (face.element == element) node_of_face_[node.face] = index;
  nodes_.push_back(node);
  return index;
}

uint32_t NodeTree::add_cluster(uint32_t first_face, uint32_t face_count, uint32_t parent) {
  const auto index = static_cast<uint32_t>(nodes_.size());
  Node node;
  node.cluster = static_cast<uint32_t>(clusters_.size());
  node.parent = parent;
  node.slot = static_cast<uint32_t>(slot_count_);
  slot_count_ += kLobes;
  Cluster cluster;
  cluster.first_face = first_face;
  cluster.face_count = face_count;
  double area = 0, lobe_area[kLobes] = {};
  for (uint32_t i = first_face; i < first_face + face_count; ++i) {
    const uint32_t f = cluster_faces_[i];
    const Face& face = builder_.mesh().faces[f];
    const Box box = box_of(scene_, face);
    cluster.box.add(box);
    const double a = std::max(face_area(f), 1e-12);
    const LobeWeights w = lobes_of_normal(face_normal(f));
    for (int l = 0; l < 3; ++l) lobe_area[w.lobe[l]] += a * w.weight[l];
    area += a;
    node.centre += a * box.centre();
    const Polygon& polygon = scene_.polygons[face.polygon];
    node.body = body_of(scene_, polygon);
    node.reflectance += static_cast<float>(a) * scene_.materials[polygon.material].reflectance;
    node_of_face_[f] = index;
  }
  node.area = static_cast<float>(area);
  node.centre = node.centre / area;
  node.reflectance = static_cast<float>(1 / area) * node.reflectance;
  node.radius = static_cast<float>(farthest_corner(cluster.box, node.centre));
  for (int l = 0; l < kLobes; ++l) cluster.lobe_share[l] = static_cast<float>(lobe_area[l] / area);
  sample(&cluster, area, hash_of(index, 3));
  nodes_.push_back(node);
  clusters_.push_back(cluster);
  return index;
}

// One point in each of kSamples equal shares of the area, in the order of the faces (stratified sampling).
void NodeTree::sample(Cluster* cluster, double area, uint64_t seed) const {
  uint32_t i = cluster->first_face;
  const uint32_t last = cluster->first_face + cluster->face_count - 1;
  double before = 0;  // area of the faces before i
  for (int s = 0; s < Cluster::kSamples; ++s) {
    const uint64_t h = hash_of(seed, static_cast<uint64_t>(s));
    const double wanted = area * (s + unit_from(h)) / Cluster::kSamples;
    while (i < last && before + face_area(cluster_faces_[i]) < wanted)
      before += face_area(cluster_faces_[i++]);
    const uint32_t face = cluster_faces_[i];
    const PatchPoints points = face_points(scene_, builder_.mesh().faces[face]);
    const double u = unit_from(mix64(h + 1)), v = unit_from(mix64(h + 2));
    cluster->samples[s] = {point_on_patch(points, 0.02 + 0.96 * u, 0.02 + 0.96 * v), face_normal(face)};
  }
}

void NodeTree::split(uint32_t node) {
  if (nodes_[node].is_cluster()) return split_cluster(node);
  const uint32_t element = nodes_[node].element;
  if (builder_.mesh().elements[element].first_child == kNone) builder_.split(element);
  const uint32_t first = builder_.mesh().elements[element].first_child;
  const auto first_child = static_cast<uint32_t>(nodes_.size());
  for (uint32_t c = 0; c < 4; ++c) add_patch(first + c, node);
  nodes_[node].first_child = first_child;
  nodes_[node].child_count = 4;
}

// A step of the octree (Christensen et al. 1997). Faces no larger than an octant of the cube about the
// cluster go to the octant that holds their centre. Larger faces become children themselves.
void NodeTree::divide(uint32_t patch) {
  split(patch);
  const Node& node = nodes_[patch];
  for (uint32_t c = 0; c < node.child_count; ++c) nodes_[node.first_child + c].is_part = true;
}

void NodeTree::split_cluster(uint32_t n) {
  const Cluster cluster = clusters_[nodes_[n].cluster];
  const auto begin = cluster_faces_.begin() + cluster.first_face;
  const Vec3 centre = cluster.box.centre();
  const double octant_size = 0.5 * largest_extent(cluster.box);
  std::array<std::vector<uint32_t>, 9> groups;  // 0: faces of their own
  for (uint32_t i = 0; i < cluster.face_count; ++i) {
    const uint32_t face = begin[i];
    const Box box = box_of(scene_, builder_.mesh().faces[face]);
    const Vec3 at = box.centre() - centre;
    const int octant = (at.x > 0 ? 1 : 0) + (at.y > 0 ? 2 : 0) + (at.z > 0 ? 4 : 0);
    const bool own = cluster.face_count <= kFlat || largest_extent(box) > octant_size;
    groups[own ? 0 : 1 + octant].push_back(face);
  }
  for (size_t g = 1; g < groups.size(); ++g) {
    if (groups[g].size() == cluster.face_count) {  // all centres in one octant: halve the list
      const auto middle = groups[g].begin() + static_cast<ptrdiff_t>(groups[g].size() / 2);
      groups[g == 1 ? 2 : 1].assign(middle, groups[g].end());
      groups[g].erase(middle, groups[g].end());
      break;
    }
    if (groups[g].size() != 1) continue;
    groups[0].push_back(groups[g][0]);
    groups[g].clear();
  }
  auto to = begin;
  for (const std::vector<uint32_t>& group : groups) to = std::copy(group.begin(), group.end(), to);
  const auto first_child = static_cast<uint32_t>(nodes_.size());
  for (const uint32_t face : groups[0]) add_patch(builder_.mesh().faces[face].element, n);
  auto first = cluster.first_face + static_cast<uint32_t>(groups[0].size());
  for (size_t g = 1; g < groups.size(); ++g) {
    const auto count = static_cast<uint32_t>(groups[g].size());
    if (count > 0) add_cluster(first, count, n);
    first += count;
  }
  nodes_[n].first_child = first_child;
  nodes_[n].child_count = static_cast<uint32_t>(nodes_.size()) - first_child;
}

uint32_t NodeTree::leaf_at(uint32_t polygon, uint32_t side, Vec2* uv) const {
  const uint32_t face = builder_.mesh().face_of_side[2 * polygon + side];
  if (face == kNone) return kNone;
  uint32_t node = node_of_face_[face];
  if (nodes_[node].is_cluster()) return static_cast<uint32_t>(nodes_.size()) + face;
  if (nodes_[node].is_leaf()) return node;
  const bool quad = scene_.polygons[polygon].corner_count() == 4;
  while (!nodes_[node].is_leaf()) {
    const uint32_t child = quad ? quad_child(uv) : triangle_child(uv);
    node = nodes_[node].first_child + child;
  }
  return node;
}

PatchPoints patch_points(const NodeTree& tree, const Node& node) {
  const Mesh& mesh = tree.builder().mesh();
  PatchPoints patch;
  const Polygon& polygon = tree.scene().polygons[mesh.faces[node.face].polygon];
  patch.corner_count = corners_of(tree.scene(), polygon, mesh, mesh.elements[node.element], patch.corners);
  return patch;
}

PatchPoints face_points(const Scene& scene, const Face& face) {
  const Polygon& polygon = scene.polygons[face.polygon];
  PatchPoints patch;
  patch.corner_count = polygon.corner_count();
  for (int i = 0; i < patch.corner_count; ++i) patch.corners[i] = scene.vertices[polygon.corners[i]];
  return patch;
}

Vec3 point_on_patch(const PatchPoints& patch, double u, double v) {
  const Vec3* c = patch.corners;
  if (patch.corner_count == 4) return lerp(lerp(c[0], c[1], u), lerp(c[3], c[2], u), v);
  const double root = std::sqrt(u);  // uniform by area (Turk 1990)
  return (1 - root) * c[0] + root * (1 - v) * c[1] + root * v * c[2];
}

}  // namespace strad
