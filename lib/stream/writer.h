// Chunks into a stream.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "stream/chunk.h"

namespace strad {

class StreamWriter {
 public:
  // Receives the bytes in order. Throws IoError.
  using Sink = std::function<void(ByteSpan)>;
  // Magic and version are written with the first chunk, so that a failure before it writes nothing.
  explicit StreamWriter(Sink sink) : sink_(std::move(sink)) {}

  // Returns the offset at which the chunk stands.
  uint64_t add(ChunkType type, ByteSpan content);
  uint64_t add(const Chunk& chunk) { return add(chunk.type, chunk.content); }
  // A payload that is compressed already.
  uint64_t add_stored(ChunkType type, ByteSpan payload);
  // Writes the closing chunk; without it every reader refuses the stream.
  void close(uint64_t index_offset = 0);

 private:
  void put_prelude();
  void put(ByteSpan bytes);

  Sink sink_;
  uint64_t position_ = 0;
  uint64_t chunks_ = 0;
};

}  // namespace strad
