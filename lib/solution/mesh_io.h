// The mesh of a slab to bytes and back.
//
// Only how elements were split is stored; the rest follows from the scene.
#pragma once

#include "solution/mesh.h"
#include "stream/bytes.h"

namespace strad {

// REQUIRES: the mesh passed validate(), every element is the root of a face or a child, and splits, parents
// and positions are those that mesh.h describes (parents of a middle in ascending order). Throws BadInput for
// another mesh.
void put_mesh(Bytes* to, const Scene& scene, const Mesh& mesh);
// Throws BadInput; what it returns passes validate().
Mesh get_mesh(ByteReader* from, const Scene& scene);

}  // namespace strad
