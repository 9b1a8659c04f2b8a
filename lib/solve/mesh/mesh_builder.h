// Grows the mesh of the solution: faces, their elements split on demand, vertices shared along edges.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"
#include "solution/mesh.h"
#include "solve/mesh/polygon_joints.h"

namespace strad {

class MeshBuilder {
 public:
  explicit MeshBuilder(const Scene& scene);  // keeps a reference

  const Mesh& mesh() const { return mesh_; }

  // The face of that side of a polygon; made with a single element when it is first asked for.
  uint32_t face(uint32_t polygon, uint32_t side);
  // Makes the faces of all sides with reached[2 * polygon + side]. Faces with no edge as long as `small` (m)
  // are undivided: they are never split. An undivided face is uniform if it is part of a curved surface or
  // smaller than half of `small`; otherwise it has vertices of its own at its corners. Small faces that share
  // most of their corners with neighbours in one plane are not undivided.
  void add_faces(const std::vector<bool>& reached, double small);
  // Undivided faces and their vertices come first: those with indices below these numbers, in the same order.
  uint32_t undivided_faces() const { return undivided_faces_; }
  uint32_t undivided_vertices() const { return undivided_vertices_; }
  // By uniform face: the neighbours across its edges, if there is one at a small angle across each of them;
  // else none.
  std::vector<std::vector<uint32_t>> curved_neighbours() const;
  // By the longest edge of a face, how exact its light must be: 1 for large faces, down to 1/5 for small
  // ones, whose errors show less.
  double accuracy_share(uint32_t face) const;
  // Makes the four children of a leaf; their new vertices go to the end of the list.
  void split(uint32_t element);

  uint32_t face_of(uint32_t element) const { return face_of_element_[element]; }
  uint32_t parent_of(uint32_t element) const { return parent_of_element_[element]; }
  // A point of the surface, in rest coordinates, close to the vertex but inside the element that made the
  // vertex. So it never lies on an edge of its polygon. For a vertex of an undivided face: the middle of the
  // part of the face that is nearest to it. And the face of that element.
  Vec3 sample_point(uint32_t vertex) const { return sample_points_[vertex]; }
  uint32_t face_of_vertex(uint32_t vertex) const { return face_of_vertex_[vertex]; }

  // Middle of the edge between two vertices, or kNone while no element has split it.
  uint32_t middle(uint32_t a, uint32_t b) const;
  // The five (quad) or three (triangle) vertices that splitting has added inside and around a split element.
  int middles(uint32_t element, uint32_t* vertices) const;

  // Vertices that lie in the middle of an edge of a larger leaf (hanging vertices). Their values must be the
  // means of their parents' values, or light would jump across the edge. One flag per vertex.
  std::vector<bool> hanging_vertices() const;

  Mesh take() { return std::move(mesh_); }

 private:
  uint32_t begin_face(uint32_t polygon, uint32_t side);
  uint32_t add_face(uint32_t polygon, uint32_t side);
  void add_uniform_face(uint32_t polygon, uint32_t side);
  void add_undivided_face(uint32_t polygon, uint32_t side);
  uint32_t corner_vertex(uint32_t polygon, uint32_t side, int corner);
  uint32_t add_corner(uint32_t polygon, uint32_t face, int corner);
  uint32_t add_vertex(MeshVertex vertex, uint32_t element);
  uint32_t edge_middle(uint32_t a, uint32_t b, uint32_t element);
  uint32_t add_element(const Element& element, uint32_t face, uint32_t parent);
  void mark_hanging(uint32_t a, uint32_t b, std::vector<bool>* hanging) const;
  Vec3 centre_of(uint32_t element) const;

  const Scene& scene_;
  Mesh mesh_;
  double large_ = 0;  // m
  uint32_t undivided_faces_ = 0, undivided_vertices_ = 0;
  std::vector<uint32_t> face_of_element_, parent_of_element_, face_of_vertex_;
  std::vector<Vec3> sample_points_;
  std::unordered_map<uint64_t, uint32_t> middle_of_edge_;  // looked up only, never iterated
  PolygonJoints joints_;
  std::unordered_map<CornerKey, uint32_t, CornerHash> corners_;  // vertices; looked up only
};

}  // namespace strad
