// Chunks into a stream.
#include "stream/writer.h"

namespace strad {

void StreamWriter::put_prelude() {
  Bytes prelude(std::begin(kMagic), std::end(kMagic));
  put_u32(&prelude, kStreamVersion);
  put(prelude);
}

void StreamWriter::put(ByteSpan bytes) {
  sink_(bytes);
  position_ += bytes.size();
}

uint64_t StreamWriter::add(ChunkType type, ByteSpan content) { return add_stored(type, compress(content)); }

uint64_t StreamWriter::add_stored(ChunkType type, ByteSpan payload) {
  if (position_ == 0) put_prelude();
  const uint64_t offset = position_;
  Bytes chunk(type.begin(), type.end());
  put_u64(&chunk, payload.size());
  chunk.insert(chunk.end(), payload.begin(), payload.end());
  put_u64(&chunk, checksum(chunk));
  put(chunk);
  ++chunks_;
  return offset;
}

void StreamWriter::close(uint64_t index_offset) {
  Bytes payload;
  put_u64(&payload, index_offset);
  put_u64(&payload, chunks_);
  add_stored(kDone, payload);
}

}  // namespace strad
