// The mesh of a slab to bytes and back.
//
// Elements are written in order, as events: a root, or the four children of an element that is split. The
// vertices of an event are predicted: the middle of an edge that was split before is the same vertex as then,
// any other point is a new vertex with the next number. Writer and reader grow the same mesh by the same
// events (`Grower`). They differ only in where the true vertex numbers come from.
#include "solution/mesh_io.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "base/error.h"

namespace strad {
namespace {

// Which of a split's points are the corners of each child: corners 0..3, middles 4..7 (of the edge from
// corner 0..3 on), centre 8.
constexpr int kQuadChildren[4][4] = {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}};
constexpr int kTriangleChildren[4][3] = {{0, 4, 6}, {4, 1, 5}, {6, 5, 2}, {5, 6, 4}};

// Returns the true vertex at a corner of an element, given the prediction.
using VertexSource = std::function<uint32_t(uint32_t element, int corner, uint32_t predicted)>;

class Grower {
 public:
  Grower(const Scene& scene, size_t vertex_count, VertexSource source)
      : scene_(scene), source_(std::move(source)), seen_(vertex_count) {
    mesh_.vertices.resize(vertex_count);
  }

  void add_root(uint32_t polygon_index) {
    const Polygon& polygon = scene_.polygons[polygon_index];
    Element root;
    for (int c = 0; c < polygon.corner_count(); ++c) {
      const uint32_t vertex = root.vertices[c] = source_(element_count(), c, next_);
      if (see(vertex)) mesh_.vertices[vertex].position = scene_.vertices[polygon.corners[c]];
    }
    mesh_.elements.push_back(root);
  }

  // REQUIRES: `parent` is a leaf.
  void split(uint32_t parent) {
    const uint32_t first = mesh_.elements[parent].first_child = element_count();
    const Element element = mesh_.elements[parent];
    const int corners = element.corner_count();
    uint32_t points[9];
    std::copy_n(element.vertices, 4, points);
    for (int i = 0; i < corners; ++i) {
      const int j = (i + 1) % corners;  // middle i is corner j of child i
      points[4 + i] = middle(element.vertices[i], element.vertices[j], first + static_cast<uint32_t>(i), j);
    }
    if (corners == 4) points[8] = centre(element, first);
    for (int child = 0; child < 4; ++child) {
      Element grown;
      for (int i = 0; i < corners; ++i)
        grown.vertices[i] = points[corners == 4 ? kQuadChildren[child][i] : kTriangleChildren[child][i]];
      mesh_.elements.push_back(grown);
    }
  }

  uint32_t element_count() const { return static_cast<uint32_t>(mesh_.elements.size()); }
  bool is_leaf(uint32_t element) const { return mesh_.elements[element].first_child == kNone; }
  bool all_seen() const {
    return next_ == seen_.size() && std::find(seen_.begin(), seen_.end(), false) == seen_.end();
  }
  Mesh take() { return std::move(mesh_); }

 private:
  // Returns true when it is first called for a vertex.
  bool see(uint32_t vertex) {
    if (seen_[vertex]) return false;
    seen_[vertex] = true;
    next_ = std::max(next_, vertex + 1);
    return true;
  }

  uint32_t middle(uint32_t a, uint32_t b, uint32_t child, int corner) {
    const auto [low, high] = std::minmax(a, b);
    const uint64_t edge = edge_key(low, high);
    const auto known = middle_of_edge_.find(edge);
    const uint32_t vertex = source_(child, corner, known == middle_of_edge_.end() ? next_ : known->second);
    middle_of_edge_.try_emplace(edge, vertex);
    if (see(vertex)) {
      auto& vertices = mesh_.vertices;
      vertices[vertex] = {{low, high, kNone, kNone},
                          0.5 * (vertices[low].position + vertices[high].position)};
    }
    return vertex;
  }

  uint32_t centre(const Element& element, uint32_t first_child) {
    const uint32_t vertex = source_(first_child, 2, next_);
    if (!see(vertex)) return vertex;
    MeshVertex& v = mesh_.vertices[vertex];
    for (int i = 0; i < 4; ++i) {
      v.parents[i] = element.vertices[i];
      v.position += 0.25 * mesh_.vertices[element.vertices[i]].position;
    }
    return vertex;
  }

  const Scene& scene_;
  VertexSource source_;
  Mesh mesh_;
  std::vector<bool> seen_;
  uint32_t next_ = 0;
  std::unordered_map<uint64_t, uint32_t> middle_of_edge_;  // looked up only, never iterated
};

void put_faces(Bytes* to, const Mesh& mesh) {
  put_varint(to, mesh.faces.size());
  Face previous;
  for (const Face& face : mesh.faces) {
    put_signed(to, int64_t{face.polygon} - previous.polygon);
    put_u8(to, static_cast<uint8_t>(face.side));
    put_signed(to, int64_t{face.element} - previous.element);
    previous = face;
  }
}

std::vector<Face> get_faces(ByteReader* from, const Scene& scene) {
  std::vector<Face> faces(from->count(3, "faces"));
  Face previous;
  for (Face& face : faces) {
    const int64_t polygon = previous.polygon + from->signed_varint();
    if (polygon < 0 || polygon >= static_cast<int64_t>(scene.polygons.size()))
      from->fail("found a face of polygon " + std::to_string(polygon) + ", but the scene has " +
                 std::to_string(scene.polygons.size()));
    face.polygon = static_cast<uint32_t>(polygon);
    face.side = from->number(1, "a side");
    const int64_t element = previous.element + from->signed_varint();
    if (element < 0 || element >= kNone) from->fail("found a root out of range");
    face.element = static_cast<uint32_t>(element);
    previous = face;
  }
  return faces;
}

std::vector<uint32_t> faces_of_sides(const std::vector<Face>& faces, const Scene& scene,
                                     const ByteReader* from) {
  std::vector<uint32_t> face_of_side(2 * scene.polygons.size(), kNone);
  for (uint32_t f = 0; f < faces.size(); ++f) {
    uint32_t& face = face_of_side[2 * faces[f].polygon + faces[f].side];
    if (face != kNone) from->fail("found two faces for one side of a polygon");
    face = f;
  }
  return face_of_side;
}

bool same(const Mesh& a, const Mesh& b) {
  const auto same_vertex = [](const MeshVertex& v, const MeshVertex& w) {
    return std::equal(v.parents, v.parents + 4, w.parents) && v.position == w.position;
  };
  const auto same_element = [](const Element& e, const Element& f) {
    return std::equal(e.vertices, e.vertices + 4, f.vertices) && e.first_child == f.first_child;
  };
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    same_vertex) &&
         std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(), same_element);
}

// The code of an event: 0 for a root, else 1 + zigzag(d), where d is the element that is split minus the one
// after the element split before.
void put_events(const Scene& scene, const Mesh& mesh, Bytes* events, Bytes* numbers) {
  std::vector<uint32_t> face_of_root(mesh.elements.size(), kNone),
      parent_of_first(mesh.elements.size(), kNone);
  for (uint32_t f = 0; f < mesh.faces.size(); ++f) face_of_root[mesh.faces[f].element] = f;
  for (uint32_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.elements[e].first_child != kNone) parent_of_first[mesh.elements[e].first_child] = e;

  Grower grower(scene, mesh.vertices.size(), [&](uint32_t element, int corner, uint32_t predicted) {
    const uint32_t vertex = mesh.elements[element].vertices[corner];
    put_signed(numbers, int64_t{vertex} - predicted);
    return vertex;
  });
  int64_t likely_parent = 0;
  while (grower.element_count() < mesh.elements.size()) {
    const uint32_t e = grower.element_count(), parent = parent_of_first[e], face = face_of_root[e];
    if (parent != kNone) {
      grower.split(parent);
      put_varint(events, 1 + zigzag(parent - likely_parent));
      likely_parent = int64_t{parent} + 1;
    } else if (face != kNone) {
      grower.add_root(mesh.faces[face].polygon);
      put_varint(events, 0);
    } else {
      throw BadInput("mesh: element " + std::to_string(e) + " belongs to no face");
    }
  }
  if (!same(grower.take(), mesh)) throw BadInput("mesh: expected elements that are split in regular fashion");
}

void put_column(Bytes* to, const Bytes& column) {
  put_varint(to, column.size());
  to->insert(to->end(), column.begin(), column.end());
}

ByteSpan get_column(ByteReader* from) { return from->bytes(from->count(1, "bytes")); }

}  // namespace

void put_mesh(Bytes* to, const Scene& scene, const Mesh& mesh) {
  Bytes events, numbers;
  put_events(scene, mesh, &events, &numbers);
  put_faces(to, mesh);
  put_column(to, events);
  put_varint(to, mesh.vertices.size());
  put_column(to, numbers);
}

Mesh get_mesh(ByteReader* from, const Scene& scene) {
  std::vector<Face> faces = get_faces(from, scene);
  std::vector<uint32_t> face_of_side = faces_of_sides(faces, scene, from);
  std::unordered_map<uint32_t, uint32_t> face_of_root;  // looked up only
  for (uint32_t f = 0; f < faces.size(); ++f)
    if (!face_of_root.try_emplace(faces[f].element, f).second) from->fail("found two faces with one root");

  ByteReader events(get_column(from), from->place());
  const size_t vertex_count = from->count(1, "vertices");  // each is named by a byte or more
  ByteReader numbers(get_column(from), from->place());
  if (vertex_count > numbers.remaining()) from->fail("found more vertices than numbers of vertices");

  Grower grower(scene, vertex_count, [&](uint32_t, int, uint32_t predicted) {
    const int64_t vertex = predicted + numbers.signed_varint();
    if (vertex < 0 || vertex >= static_cast<int64_t>(vertex_count)) from->fail("found a vertex out of range");
    return static_cast<uint32_t>(vertex);
  });
  int64_t likely_parent = 0;
  size_t roots = 0;
  while (events.remaining() > 0) {
    const uint64_t event = events.varint();
    if (event == 0) {
      const auto face = face_of_root.find(grower.element_count());
      if (face == face_of_root.end()) from->fail("found a root that belongs to no face");
      grower.add_root(faces[face->second].polygon);
      ++roots;
      continue;
    }
    const int64_t parent = likely_parent + unzigzag(event - 1);
    if (parent < 0 || parent >= grower.element_count() || !grower.is_leaf(static_cast<uint32_t>(parent)))
      from->fail("found a split of something that is no leaf");
    grower.split(static_cast<uint32_t>(parent));
    likely_parent = parent + 1;
  }
  numbers.finish();
  if (roots != faces.size()) from->fail("found a face without a root");
  if (!grower.all_seen()) from->fail("found a vertex that is in no element");

  Mesh mesh = grower.take();
  mesh.faces = std::move(faces);
  mesh.face_of_side = std::move(face_of_side);
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v)
    for (const uint32_t parent : mesh.vertices[v].parents)
      if (parent != kNone && parent >= v) from->fail("a parent of a vertex does not come before it");
  return mesh;
}

}  // namespace strad
