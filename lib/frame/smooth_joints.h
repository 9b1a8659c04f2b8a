// Where facets of a smooth surface meet, and light that is one sheet over them.
//
// The solution has irradiance on flat facets, which differs where two of them meet. A point between two
// facets has a normal between theirs, and irradiance changes about in proportion to that: where facets meet
// it is the mean of theirs, and between the middle of a facet and its edges it is interpolated.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "frame/reconstruction.h"
#include "scene/scene.h"
#include "solution/mesh.h"

namespace strad {

class SmoothJoints {
 public:
  // Keeps references.
  SmoothJoints(const Scene& scene, const Mesh& mesh, const Reconstruction& reconstruction);

  // Sets the values of vertices where facets meet to their means, and those of vertices on a common edge that
  // only one of two facets has to what lies between their neighbours, as the other facet shows it. Returns
  // the values at the corners of smooth facets that have one vertex for all of their light, four for each.
  std::vector<Rgb> join(std::vector<Rgb>* vertex_values) const;

  // The values of join() for a face, null if it is interpolated between its vertices.
  const Rgb* corners_of(uint32_t face, const std::vector<Rgb>& corner_values) const {
    return slots_.empty() || slots_[face] == kNone ? nullptr : &corner_values[4 * size_t{slots_[face]}];
  }
  Rgb between(uint32_t face, const Rgb* corners, Vec2 at) const;

 private:
  struct Member {
    uint32_t target;  // a vertex of the mesh, or with `is_corner` 4 * slot + corner
    uint32_t source;  // the vertex whose value counts
    float weight;     // the facet's angle at a corner, radians; 1 on an edge
    bool is_corner;
  };
  struct Hanging {
    uint32_t vertex, before, after;  // on an edge, coarse ones first
  };
  class Builder;

  const Scene& scene_;
  const Mesh& mesh_;
  std::vector<Member> members_;  // group after group, each to have one value
  std::vector<size_t> groups_;   // where each begins, and the end
  std::vector<Hanging> hanging_;
  std::vector<uint32_t> slots_;  // by face: its place among those with a single vertex, or kNone; empty: none
  uint32_t slot_count_ = 0;
};

}  // namespace strad
