// Emitting polygons in groups, each of connected or like-named ones.
//
// The renderer finds the unoccluded irradiance and the visible fraction of each group separately.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/facet_mesh.h"
#include "frame/group_views.h"
#include "scene/scene.h"

namespace strad {

// Emitting polygons of one material and body that belong to one object, or that have an edge in common and do
// not face each other across it: one area light, lit and shadowed as such however many facets it has.
struct EmitterGroup : FacetMesh {
  uint32_t material = 0, body = 0;
  std::vector<uint32_t> polygons;  // the facets, in the order of a k-d tree: near ones follow each other
  GroupViews views;
};
std::vector<EmitterGroup> emitter_groups(const Scene& scene);

}  // namespace strad
