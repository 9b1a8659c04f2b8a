// What a stream holds, as named values in a fixed order, printed as text or JSON.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solution/stream_io.h"

namespace strad {

struct Fact;
struct NamedFact;
using FactList = std::vector<Fact>;
using FactGroup = std::vector<NamedFact>;
struct Fact {
  std::variant<double, std::string, FactList, FactGroup> value;
};
struct NamedFact {
  std::string name;
  Fact fact;
};

// A chunk as it stands in the stream.
struct ChunkFacts {
  ChunkType type{};
  uint64_t offset = 0;
  uint64_t stored = 0, content = 0;  // bytes of payload, compressed and not
};

// Reads a stream, as read_stream does, and lists its chunks.
Stream read_with_chunks(StreamReader& reader, std::vector<ChunkFacts>* chunks);

// All facts about scene and solution; with `list_chunks` also each chunk with its offset.
Fact describe(const Stream& stream, const std::vector<ChunkFacts>& chunks, bool list_chunks);

std::string to_json(const Fact& fact);
// One value per line, groups indented.
std::string to_text(const Fact& fact);

}  // namespace strad
