// How finely the sides of polygons may be divided: which are faces with elements of any size, and which are
// too small for that.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/mesh/polygon_joints.h"

namespace strad {

// Sides, 2 * polygon + side, ascending.
struct FaceKinds {
  std::vector<uint32_t> uniform;    // one value for the whole face
  std::vector<uint32_t> undivided;  // values of its own at its corners
  std::vector<uint32_t> divided;    // split on demand
};

// Of the sides that are `reached`. See MeshBuilder::add_faces().
FaceKinds face_kinds(const Scene& scene, const PolygonJoints& joints, const std::vector<bool>& reached,
                     double small);

double longest_edge(const Scene& scene, const Polygon& polygon);  // m

}  // namespace strad
