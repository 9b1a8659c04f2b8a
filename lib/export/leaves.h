// The leaves of the solution's mesh that an export needs. The solver refines the mesh more finely than shows
// in pictures, so an export merges the children of an element where this makes no visible difference.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "solution/solution.h"

namespace strad {

enum class ExportLight { kAll, kIndirect };

class ExportLeaves {
 public:
  ExportLeaves(const Slab& slab, ExportLight light);  // keeps a reference

  // Whether `element` is exported in one piece. REQUIRES: it is not below an exported element.
  bool is_leaf(uint32_t element) const { return !split_[element]; }
  // Corners of a leaf and the vertices of smaller leaves on its edges, in order.
  std::vector<uint32_t> outline(uint32_t element) const;
  // Whether a quad drawn as two triangles would be too far off at its centre from the mean of its corners.
  bool twisted(uint32_t element) const { return twisted_[element]; }
  // Whether no other exported leaf shares a corner with `element`.
  bool alone(uint32_t element) const;

 private:
  void mark_split(const std::vector<float>& surplus, float tolerance);
  void mark_used(uint32_t element);
  void mark_twisted(const std::vector<Rgb>& irradiance, float tolerance);
  void add_edge(uint32_t a, uint32_t b, std::vector<uint32_t>* vertices) const;

  const Mesh& mesh_;
  std::vector<bool> split_, twisted_;                      // per element
  std::vector<uint32_t> users_;                            // number of exported leaves at it, per vertex
  std::unordered_map<uint64_t, uint32_t> middle_of_edge_;  // of vertices of exported leaves; looked up only
};

}  // namespace strad
