// A stream with all that it holds, read and written at once. To read single instants see solution_file.h.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solution/solution.h"
#include "solution/stream_index.h"
#include "stream/reader.h"
#include "stream/writer.h"

namespace strad {

struct Stream {
  Scene scene;                       // its provenance is the stream's
  std::optional<Solution> solution;  // what strad-solve added
  std::vector<Chunk> others;         // ancillary chunks that strad does not know, carried through
};

// Throws BadInput, IoError. "" or "-": standard input.
Stream read_stream(const std::string& path);
Stream read_stream(StreamReader& reader,
                   const std::function<void(const ChunkView&)>& see = {});  // sees each chunk
// REQUIRES: scene and solution pass validate().
void write_stream(const Stream& stream, StreamWriter& writer);

// A critical chunk that is neither a scene's nor a solution's. Throws BadInput.
[[noreturn]] void refuse(const StreamReader& reader, const ChunkView& chunk);

}  // namespace strad
