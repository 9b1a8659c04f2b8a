// The facets of an emitter group as a mesh: which corners and edges they share.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/none.h"
#include "base/vec.h"

namespace strad {

// An edge of a facet, and of the facet beside it that has the same edge the other way round.
struct GroupEdge {
  uint32_t from = 0, to = 0;     // vertices of the group, in the order of `left`
  uint32_t left = 0, right = 0;  // facets; as many as there are facets: none is beside it
};

struct FacetMesh {
  std::vector<Vec3> vertices;                    // rest
  std::vector<std::array<uint32_t, 4>> corners;  // per facet, in `vertices`; the last is kNone on triangles
  std::vector<GroupEdge> edges;
};

}  // namespace strad
