// Finishes of materials to a chunk and back.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "stream/bytes.h"
#include "stream/chunk.h"

namespace strad {

// Critical: who does not know it would take glass for an opaque wall.
constexpr ChunkType kFinishesChunk = chunk_type("FNSH");

// Of all materials in order.
void put_finishes(Bytes* to, const std::vector<Material>& materials);
std::vector<Finish> get_finishes(ByteReader* from);

// Gives them to the scene's materials. Throws BadInput, which names `place`, unless there are as many.
void apply_finishes(const std::vector<Finish>& finishes, const std::string& place, Scene* scene);

}  // namespace strad
