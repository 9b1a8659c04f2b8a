// The leaves of the solution's mesh that its pictures need. The solver refines for all light at all times,
// and more than the eye does; an export can leave out what would not show in it.
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

  // True for elements that are shown whole; the elements below are not.
  bool is_leaf(uint32_t element) const { return !split_[element]; }
  // Corners of a leaf and the vertices of smaller leaves on its edges, in order.
  std::vector<uint32_t> outline(uint32_t element) const;
  // Two triangles would show a quad wrongly: at its centre, too far from the mean of its corners.
  bool twisted(uint32_t element) const { return twisted_[element]; }
  // No other leaf has any of its corners.
  bool alone(uint32_t element) const;

 private:
  void mark_split(const std::vector<float>& surplus, float tolerance);
  void mark_used(uint32_t element);
  void mark_twisted(const std::vector<Rgb>& irradiance, float tolerance);
  void add_edge(uint32_t a, uint32_t b, std::vector<uint32_t>* vertices) const;

  const Mesh& mesh_;
  std::vector<bool> split_, twisted_;                      // per element
  std::vector<uint32_t> users_;                            // leaves that have it, per vertex
  std::unordered_map<uint64_t, uint32_t> middle_of_edge_;  // of used vertices; looked up only, never iterated
};

}  // namespace strad
