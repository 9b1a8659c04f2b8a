// Emitting polygons in groups, each of connected or like-named ones: the parts of direct light that the
// renderer weighs and samples apart.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace strad {

// An edge of a facet, and of the facet beside it that has the same edge the other way round.
struct GroupEdge {
  uint32_t from = 0, to = 0;     // vertices of the group, in the order of `left`
  uint32_t left = 0, right = 0;  // facets; as many as there are facets: none is beside it
};

// Emitting polygons of one material and body that belong to one object or touch: one area light, lit and
// shadowed as such however many facets it has.
struct EmitterGroup {
  uint32_t material = 0, body = 0;
  std::vector<uint32_t> polygons;  // the facets, in the order of a k-d tree: near ones follow each other
  std::vector<std::array<uint32_t, 4>> corners;  // per facet, in `vertices`
  std::vector<Vec3> vertices;                    // rest
  std::vector<GroupEdge> edges;
};
std::vector<EmitterGroup> emitter_groups(const Scene& scene);

}  // namespace strad
