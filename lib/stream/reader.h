// Chunks out of a stream, in order or by offset.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "stream/chunk.h"
#include "stream/source.h"

namespace strad {

class StreamReader {
 public:
  // Checks magic and version. "" or "-": standard input.
  explicit StreamReader(const std::string& path);
  StreamReader(ByteSpan bytes, std::string name);  // keeps the span

  const std::string& name() const { return source_->name(); }
  bool seekable() const { return source_->seekable(); }

  // The next chunk, valid until the next call; nothing after the closing chunk, which must end the stream.
  std::optional<ChunkView> next();

  // The chunk at `offset`. REQUIRES: seekable().
  ChunkView at(uint64_t offset);
  // Offset of the index chunk that the closing chunk names; 0 where there is none. REQUIRES: seekable().
  uint64_t index_offset();

  Bytes content(const ChunkView& chunk) const { return decompress(chunk.payload, place(chunk)); }
  // "FILE: chunk TYPE at byte N", for errors.
  std::string place(const ChunkView& chunk) const;

 private:
  void check_prelude();
  void check_done(const ChunkView& done);

  std::unique_ptr<Source> source_;
  uint64_t position_ = kPreludeSize;
  uint64_t chunks_ = 0;
  bool done_ = false;
};

}  // namespace strad
