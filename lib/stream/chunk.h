// The frame of a stream in the manner of PNG: a magic with a version, chunks, a closing chunk. No meaning.
//
//   magic       8 bytes  89 53 54 52 0d 0a 1a 0a   ("\x89STR", line ends that a text transfer would spoil)
//   version     u32      1
//   chunks      type (4 letters), length (u64), payload (length bytes), checksum (u64)
//
// The checksum is XXH64 (seed 0) of type, length and payload. A payload is one zstd frame that states its
// content size, but for the closing chunk DONE: offset of the index chunk (u64, 0: none), chunks before DONE
// (u64). A type that starts with a capital is critical: who does not know it must refuse the stream.
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
// Throws BadInput "PLACE: ..." for anything but one whole zstd frame. Memory grows with what really comes
// out.
Bytes decompress(ByteSpan payload, const std::string& place);
// What the frame says it holds, without unpacking it. The same errors for a frame that says nothing.
uint64_t content_size(ByteSpan payload, const std::string& place);

}  // namespace strad
