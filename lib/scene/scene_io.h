// A scene to chunks and back; strad(5) has the tables.
#pragma once

#include <vector>

#include "scene/normals_io.h"
#include "scene/scene.h"
#include "stream/reader.h"
#include "stream/writer.h"

namespace strad {

// All chunks of a scene in their fixed order, provenance first.
std::vector<Chunk> encode_scene(const Scene& scene);

// Builds a scene from its chunks, given one by one.
class SceneDecoder {
 public:
  // False if the chunk does not belong to a scene. `place` names the chunk in errors. Throws BadInput.
  bool add(ChunkType type, ByteSpan content, const std::string& place);
  // Throws BadInput if a chunk is missing or validate() fails. `place` names the stream.
  Scene finish(const std::string& place);

  static bool knows(ChunkType type);

 private:
  Scene scene_;
  std::vector<ChunkType> seen_;
  std::vector<bool> clamps_;        // of the textures
  std::vector<Opacity> opacities_;  // likewise
  StoredNormals normals_;
  std::vector<Finish> finishes_;
};

}  // namespace strad
