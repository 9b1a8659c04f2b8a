// What a stream holds, as named values in a fixed order, printed as text or JSON.
#pragma once

#include <string>
#include <vector>

#include "solution/fact_values.h"
#include "solution/stream_io.h"

namespace strad {

// A chunk as it stands in the stream.
struct ChunkFacts {
  ChunkType type{};
  uint64_t offset = 0;
  uint64_t stored = 0, content = 0;  // bytes of payload, compressed and not
};

// Reads a stream, as read_stream does, and lists its chunks.
Stream read_with_chunks(StreamReader& reader, std::vector<ChunkFacts>* chunks);

// Long lists, which are made only where they are asked for.
struct FactChoice {
  bool chunks = false;   // each chunk with its offset
  bool objects = false;  // each object, and what materials and bodies have of the surfaces
};

// All facts about scene and solution.
Fact describe(const Stream& stream, const std::vector<ChunkFacts>& chunks, const FactChoice& choice = {});

std::string to_json(const Fact& fact);
// One value per line, groups indented.
std::string to_text(const Fact& fact);

}  // namespace strad
