// Irradiance anywhere on a face from the values at the vertices of its mesh: continuous, without cracks where
// a leaf meets smaller ones.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/rgb.h"
#include "solution/mesh.h"

namespace strad {

struct VertexWeight {
  uint32_t vertex = kNone;
  float weight = 0;
};

class Reconstruction {
 public:
  explicit Reconstruction(const Mesh& mesh);  // keeps a reference

  // Bilinear on quads and linear on triangles, plus what the vertices of smaller neighbours on the leaf's
  // edges deviate from that, fading linearly towards the opposite side (a Coons patch of the deviations,
  // Coons 1967).
  Rgb smooth(const std::vector<Rgb>& vertex_values, uint32_t face, Vec2 uv) const;

  // The leaf's mean: the elements as they are.
  Rgb flat(const std::vector<Rgb>& vertex_values, uint32_t face, Vec2 uv, uint32_t* leaf) const;

  // The vertex in the middle of the edge between two, kNone if it has none.
  uint32_t middle_of(uint32_t a, uint32_t b) const;

  // Where `smooth` and `flat` take their values from; a vertex may be there twice.
  std::vector<VertexWeight> smooth_sources(uint32_t face, Vec2 uv) const;
  std::vector<VertexWeight> flat_sources(uint32_t face, Vec2 uv) const;

 private:
  // Calls add(vertex, weight).
  template <typename Add>
  void visit(uint32_t face, Vec2 uv, const Add& add) const;
  template <typename Add>
  void visit_deviation(uint32_t a, uint32_t b, uint32_t middle, double s, double scale, const Add& add) const;

  const Mesh& mesh_;
  std::unordered_map<uint64_t, uint32_t> middles_;  // of edges, by their ends
  std::vector<uint32_t> edge_middles_;  // [4 * element + edge]: on a leaf, the vertex that hangs there
  std::vector<bool> hanging_;           // per element: any of its edges has one
};

}  // namespace strad
