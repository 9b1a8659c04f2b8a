// How many links arrive at each leaf, also as a mesh to be looked at.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solve/links/link_table.h"
#include "solve/links/nodes.h"

namespace strad {

// By node: the links that bring light to it, its own and those of its ancestors, which are pushed down to it.
// A link whose kernel changes counts once for each interval that it was split into.
std::vector<uint32_t> arriving_links(const NodeTree& tree, const LinkTable& links);

// The leaves of the hierarchy at the start of the animation as a PLY mesh, binary little-endian: each with
// corners of its own in false colours (heat_map) of the logarithm of its links over the largest one, and the
// number of its links as property `links` of its face.
std::string links_as_ply(const NodeTree& tree, const LinkTable& links);

}  // namespace strad
