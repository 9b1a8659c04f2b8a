// The mesh of the solution: one for all instants, in rest coordinates.
//
// A polygon is divided into elements where its light varies at any time of the animation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "scene/polygon_geometry.h"
#include "scene/scene.h"

namespace strad {

// Vertices carry hierarchical surpluses (Yserentant 1986): value = mean of the parents' values + the vertex's
// own function. Parents come before their children.
struct MeshVertex {
  uint32_t parents[4] = {kNone, kNone, kNone, kNone};
  Vec3 position;  // rest, m

  // 0 for a corner of a polygon, 2 for the middle of an edge, 4 for the middle of a quad.
  int parent_count() const { return parents[0] == kNone ? 0 : parents[2] == kNone ? 2 : 4; }
};

// The key of the edge between two vertices, the same in both directions.
inline uint64_t edge_key(uint32_t a, uint32_t b) { return uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

// A quad (vertices counter-clockwise seen from the front of its polygon) or a triangle (vertices[3] ==
// kNone). Children: child c holds corner c; the fourth child of a triangle is the middle one. With m01 the
// middle of the edge from vertex 0 to vertex 1:
//   quad      (v0, m01, mid, m30) (m01, v1, m12, mid) (mid, m12, v2, m23) (m30, mid, m23, v3)
//   triangle  (v0, m01, m20) (m01, v1, m12) (m20, m12, v2) (m12, m20, m01)
struct Element {
  uint32_t vertices[4] = {kNone, kNone, kNone, kNone};
  uint32_t first_child = kNone;  // four in a row; kNone: a leaf
  int corner_count() const { return vertices[3] == kNone ? 3 : 4; }
};

// A uniform face has the same light everywhere. All corners of its only element are one vertex.
inline bool is_uniform(const Element& element) {
  return element.vertices[0] == element.vertices[1] && element.vertices[1] == element.vertices[2];
}

// One side of a polygon that light reaches at some time.
struct Face {
  uint32_t polygon = 0;
  uint32_t side = 0;     // 0 front, 1 back
  uint32_t element = 0;  // root
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<Element> elements;
  std::vector<Face> faces;
  std::vector<uint32_t>
      face_of_side;  // [2 * polygon + side]: the face, or kNone for a side that no light reaches
};

// The child of a split quad or triangle that holds `uv`, which becomes the position in the child.
uint32_t quad_child(Vec2* uv);
uint32_t triangle_child(Vec2* uv);

// Corners in rest coordinates of an element of `polygon`; returns their number.
int corners_of(const Scene& scene, const Polygon& polygon, const Mesh& mesh, const Element& element,
               Vec3* corners);

// A point of the mesh: the leaf that holds it, and the vertices (at most four) whose weighted values give the
// value there. The weights add up to 1.
struct MeshPoint {
  uint32_t element = kNone;
  uint32_t vertices[4] = {kNone, kNone, kNone, kNone};
  float weights[4] = {0, 0, 0, 0};
};
MeshPoint locate(const Mesh& mesh, uint32_t face, Vec2 uv);

}  // namespace strad
