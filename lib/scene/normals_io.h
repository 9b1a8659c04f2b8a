// The ancillary chunk of normals of smooth surfaces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "stream/bytes.h"
#include "stream/chunk.h"

namespace strad {

// Ancillary: light is computed on flat facets, and who does not know the chunk shows these as they are.
constexpr ChunkType kNormalsChunk = chunk_type("norm");

// What the chunk holds; polygons and vertices, by which it is understood, may come after it.
struct StoredNormals {
  std::vector<Vec3> normals;
  std::vector<uint32_t> corners;  // a number for each polygon that is flat, one for each corner of the others
};

void put_normals(Bytes* to, const Scene& scene);
StoredNormals get_normals(ByteReader* from);  // throws BadInput
// Throws BadInput "PLACE: ..." unless they fit the polygons of `scene`.
void apply_normals(StoredNormals stored, const std::string& place, Scene* scene);

}  // namespace strad
