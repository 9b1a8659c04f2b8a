#include "solve/mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "solve/mesh/face_kinds.h"

namespace strad {
namespace {

constexpr double kLargeFace = 1.0 / 12;  // of the scene's diagonal

Vec3 polygon_centre(const Scene& scene, const Polygon& polygon) {
  Vec3 centre;
  for (int c = 0; c < polygon.corner_count(); ++c)
    centre += scene.vertices[polygon.corners[c]] / polygon.corner_count();
  return centre;
}

}  // namespace

MeshBuilder::MeshBuilder(const Scene& scene) : scene_(scene), joints_(scene) {
  mesh_.face_of_side.assign(2 * scene.polygons.size(), kNone);
  Box box;
  for (const Vec3& v : scene.vertices) box.add(v);
  large_ = kLargeFace * box.diagonal();
}

uint32_t MeshBuilder::face(uint32_t polygon, uint32_t side) {
  const uint32_t known = mesh_.face_of_side[2 * polygon + side];
  return known != kNone ? known : add_face(polygon, side);
}

// A face whose only element has no vertices yet.
uint32_t MeshBuilder::begin_face(uint32_t polygon, uint32_t side) {
  const auto face = static_cast<uint32_t>(mesh_.faces.size());
  mesh_.face_of_side[2 * polygon + side] = face;
  mesh_.faces.push_back({polygon, side, add_element({}, face, kNone)});
  return face;
}

uint32_t MeshBuilder::add_face(uint32_t polygon, uint32_t side) {
  const uint32_t face = begin_face(polygon, side), root = mesh_.faces[face].element;
  for (int c = 0; c < scene_.polygons[polygon].corner_count(); ++c) {
    const uint32_t vertex = corner_vertex(polygon, side, c);
    mesh_.elements[root].vertices[c] = vertex;
  }
  return face;
}

void MeshBuilder::add_uniform_face(uint32_t polygon, uint32_t side) {
  const uint32_t face = begin_face(polygon, side);
  const Polygon& p = scene_.polygons[polygon];
  const uint32_t vertex = add_corner(polygon, face, 0);
  sample_points_[vertex] = polygon_centre(scene_, p);
  std::fill_n(mesh_.elements[mesh_.faces[face].element].vertices, p.corner_count(), vertex);
}

void MeshBuilder::add_undivided_face(uint32_t polygon, uint32_t side) {
  const uint32_t face = begin_face(polygon, side), root = mesh_.faces[face].element;
  const Polygon& p = scene_.polygons[polygon];
  for (int c = 0; c < p.corner_count(); ++c) {
    const uint32_t vertex = add_corner(polygon, face, c);
    mesh_.elements[root].vertices[c] = vertex;
    sample_points_[vertex] = lerp(mesh_.vertices[vertex].position, polygon_centre(scene_, p), 0.5);
  }
}

std::vector<std::vector<uint32_t>> MeshBuilder::curved_neighbours() const {
  std::unordered_map<uint64_t, uint32_t> waiting;  // by edge of a side, the first face; looked up only
  std::vector<std::vector<uint32_t>> neighbours(undivided_faces_);
  const auto is_uniform_face = [&](uint32_t f) { return is_uniform(mesh_.elements[mesh_.faces[f].element]); };
  for (uint32_t f = 0; f < undivided_faces_ && is_uniform_face(f); ++f) {
    const auto& [polygon, side, root] = mesh_.faces[f];
    const Polygon& p = scene_.polygons[polygon];
    for (int c = 0; c < p.corner_count(); ++c) {
      const auto [it, added] = waiting.try_emplace(hash_of(joints_.edge(polygon, c), uint64_t{side}), f);
      if (added || !joints_.continues(polygon, mesh_.faces[it->second].polygon)) continue;
      neighbours[f].push_back(it->second);
      neighbours[it->second].push_back(f);
    }
  }
  for (uint32_t f = 0; f < undivided_faces_; ++f) {
    const Polygon& polygon = scene_.polygons[mesh_.faces[f].polygon];
    if (neighbours[f].size() != static_cast<size_t>(polygon.corner_count())) neighbours[f].clear();
  }
  return neighbours;
}

void MeshBuilder::add_faces(const std::vector<bool>& reached, double small) {
  const FaceKinds kinds = face_kinds(scene_, joints_, reached, small);
  for (const uint32_t s : kinds.uniform) add_uniform_face(s / 2, s % 2);
  for (const uint32_t s : kinds.undivided) add_undivided_face(s / 2, s % 2);
  undivided_faces_ = static_cast<uint32_t>(mesh_.faces.size());
  undivided_vertices_ = static_cast<uint32_t>(mesh_.vertices.size());
  for (const uint32_t s : kinds.divided) add_face(s / 2, s % 2);
}

double MeshBuilder::accuracy_share(uint32_t face) const {
  return std::clamp(longest_edge(scene_, scene_.polygons[mesh_.faces[face].polygon]) / large_, 0.2, 1.0);
}

// Neighbours in one plane share their corners, so that light is continuous across them.
uint32_t MeshBuilder::corner_vertex(uint32_t polygon, uint32_t side, int corner) {
  const auto [it, added] = corners_.try_emplace(joints_.corner(polygon, side, corner),
                                                static_cast<uint32_t>(mesh_.vertices.size()));
  if (added) add_corner(polygon, mesh_.face_of_side[2 * polygon + side], corner);
  return it->second;
}

uint32_t MeshBuilder::add_corner(uint32_t polygon, uint32_t face, int corner) {
  const Polygon& p = scene_.polygons[polygon];
  MeshVertex vertex;
  vertex.position = scene_.vertices[p.corners[corner]];
  mesh_.vertices.push_back(vertex);
  face_of_vertex_.push_back(face);
  sample_points_.push_back(lerp(vertex.position, polygon_centre(scene_, p), 0.01));
  return static_cast<uint32_t>(mesh_.vertices.size() - 1);
}

Vec3 MeshBuilder::centre_of(uint32_t element) const {
  const Element& e = mesh_.elements[element];
  Vec3 centre;
  for (int c = 0; c < e.corner_count(); ++c)
    centre += mesh_.vertices[e.vertices[c]].position / e.corner_count();
  return centre;
}

uint32_t MeshBuilder::add_vertex(MeshVertex vertex, uint32_t element) {
  // 2 % of the element inwards is clear of walls that the edge touches, and makes no visible difference to
  // light.
  sample_points_.push_back(lerp(vertex.position, centre_of(element), 0.02));
  face_of_vertex_.push_back(face_of_element_[element]);
  mesh_.vertices.push_back(vertex);
  return static_cast<uint32_t>(mesh_.vertices.size() - 1);
}

uint32_t MeshBuilder::add_element(const Element& element, uint32_t face, uint32_t parent) {
  mesh_.elements.push_back(element);
  face_of_element_.push_back(face);
  parent_of_element_.push_back(parent);
  return static_cast<uint32_t>(mesh_.elements.size() - 1);
}

uint32_t MeshBuilder::middle(uint32_t a, uint32_t b) const {
  const auto it = middle_of_edge_.find(edge_key(a, b));
  return it == middle_of_edge_.end() ? kNone : it->second;
}

uint32_t MeshBuilder::edge_middle(uint32_t a, uint32_t b, uint32_t element) {
  const uint32_t known = middle(a, b);
  if (known != kNone) return known;
  MeshVertex vertex;
  vertex.parents[0] = std::min(a, b);
  vertex.parents[1] = std::max(a, b);
  vertex.position =
      0.5 * (mesh_.vertices[vertex.parents[0]].position + mesh_.vertices[vertex.parents[1]].position);
  return middle_of_edge_[edge_key(a, b)] = add_vertex(vertex, element);
}

void MeshBuilder::split(uint32_t element) {
  const Element parent = mesh_.elements[element];
  const int n = parent.corner_count();
  const uint32_t* v = parent.vertices;
  uint32_t m[4];  // m[i]: middle of the edge from corner i to the next
  for (int i = 0; i < n; ++i) m[i] = edge_middle(v[i], v[(i + 1) % n], element);
  Element children[4];
  if (n == 4) {
    MeshVertex centre;
    for (int i = 0; i < 4; ++i) {
      centre.parents[i] = v[i];
      centre.position += 0.25 * mesh_.vertices[v[i]].position;
    }
    const uint32_t mid = add_vertex(centre, element);
    children[0] = {{v[0], m[0], mid, m[3]}};
    children[1] = {{m[0], v[1], m[1], mid}};
    children[2] = {{mid, m[1], v[2], m[2]}};
    children[3] = {{m[3], mid, m[2], v[3]}};
  } else {
    children[0] = {{v[0], m[0], m[2], kNone}};
    children[1] = {{m[0], v[1], m[1], kNone}};
    children[2] = {{m[2], m[1], v[2], kNone}};
    children[3] = {{m[1], m[2], m[0], kNone}};
  }
  mesh_.elements[element].first_child = static_cast<uint32_t>(mesh_.elements.size());
  for (const Element& child : children) add_element(child, face_of_element_[element], element);
}

int MeshBuilder::middles(uint32_t element, uint32_t* vertices) const {
  const Element& e = mesh_.elements[element];
  const int n = e.corner_count();
  for (int i = 0; i < n; ++i) vertices[i] = middle(e.vertices[i], e.vertices[(i + 1) % n]);
  if (n == 3) return 3;
  vertices[4] = mesh_.elements[e.first_child].vertices[2];
  return 5;
}

void MeshBuilder::mark_hanging(uint32_t a, uint32_t b, std::vector<bool>* hanging) const {
  const uint32_t m = middle(a, b);
  if (m == kNone) return;
  (*hanging)[m] = true;
  mark_hanging(a, m, hanging);
  mark_hanging(m, b, hanging);
}

std::vector<bool> MeshBuilder::hanging_vertices() const {
  std::vector<bool> hanging(mesh_.vertices.size(), false);
  for (const Element& e : mesh_.elements) {
    if (e.first_child != kNone) continue;
    const int n = e.corner_count();
    for (int i = 0; i < n; ++i) mark_hanging(e.vertices[i], e.vertices[(i + 1) % n], &hanging);
  }
  return hanging;
}

}  // namespace strad
