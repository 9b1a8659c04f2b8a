// The framing of a stream, as in PNG: magic, version, chunks, a closing chunk. What chunks mean is defined
// elsewhere.
//
//   magic       8 bytes  89 53 54 52 0d 0a 1a 0a   ("\x89STR", line ends that a text transfer would spoil)
//   version     u32      1
//   chunks      type (4 letters), length (u64), payload (length bytes), checksum (u64)
//
// The checksum is XXH64 (seed 0) of type, length and payload. A payload is one zstd frame that states its
// content size. Only the closing chunk DONE is stored as it is: offset of the index chunk (u64, 0: none) and
// number of chunks before DONE (u64). A type that starts with a capital is critical: a reader that does not
// know it must refuse the stream.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "stream/bytes.h"

namespace strad {

using ChunkType = std::array<char, 4>;
constexpr ChunkType chunk_type(const char (&name)[5]) { return {name[0], name[1], name[2], name[3]}; }
inline std::string name_of(ChunkType type) { return {type.begin(), type.end()}; }
constexpr bool is_critical(ChunkType type) { return type[0] >= 'A' && type[0] <= 'Z'; }

constexpr ChunkType kDone = chunk_type("DONE");
constexpr uint8_t kMagic[8] = {0x89, 'S', 'T', 'R', 0x0d, 0x0a, 0x1a, 0x0a};
constexpr uint32_t kStreamVersion = 1;
constexpr size_t kPreludeSize = 12;      // magic, version
constexpr size_t kChunkHeaderSize = 12;  // type, length
constexpr size_t kChecksumSize = 8;
constexpr size_t kDoneSize = kChunkHeaderSize + 16 + kChecksumSize;

// A chunk with its content unpacked.
struct Chunk {
  ChunkType type{};
  Bytes content;
};

// A chunk as it stands in a stream; its checksum has been verified.
struct ChunkView {
  ChunkType type{};
  uint64_t offset = 0;  // of its type, from the start of the stream
  ByteSpan payload;     // as stored
};

uint64_t checksum(ByteSpan bytes);

Bytes compress(ByteSpan content);
// Throws BadInput "PLACE: ..." for anything but one complete zstd frame. Takes memory only for bytes that are
// really unpacked, whatever size the frame claims.
Bytes decompress(ByteSpan payload, const std::string& place);
// The content size that the frame states, without unpacking it. Throws BadInput if it states none.
uint64_t content_size(ByteSpan payload, const std::string& place);

}  // namespace strad
