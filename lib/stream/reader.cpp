// Chunks out of a stream.
#include "stream/reader.h"

#include <algorithm>

#include "base/error.h"

namespace strad {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

[[noreturn]] void fail(const std::string& name, uint64_t offset, const std::string& fault) {
  throw BadInput(name + ": byte " + std::to_string(offset) + ": " + fault);
}

}  // namespace

StreamReader::StreamReader(const std::string& path) : source_(std::make_unique<Source>(path)) {
  check_prelude();
}

StreamReader::StreamReader(ByteSpan bytes, std::string name)
    : source_(std::make_unique<Source>(bytes, std::move(name))) {
  check_prelude();
}

void StreamReader::check_prelude() {
  if (source_->ends_at(0)) fail(name(), 0, "found nothing, expected a strad stream");
  const ByteSpan magic = source_->at(0, sizeof kMagic);
  if (!std::equal(magic.begin(), magic.end(), kMagic)) fail(name(), 0, "this is no strad stream");
  const uint32_t version = get_u32(source_->at(sizeof kMagic, 4), 0);
  if (version != kStreamVersion)
    fail(name(), sizeof kMagic,
         "found stream version " + std::to_string(version) + ", expected " + std::to_string(kStreamVersion));
}

ChunkView StreamReader::at(uint64_t offset) {
  const ByteSpan header = source_->at(offset, kChunkHeaderSize);
  ChunkType type;
  std::copy_n(header.begin(), type.size(), type.begin());
  if (!std::all_of(type.begin(), type.end(), is_letter)) fail(name(), offset, "expected a chunk's type");
  const uint64_t length = get_u64(header, type.size());
  if (length > UINT64_MAX / 2) fail(name(), offset + type.size(), "found an absurd chunk length");
  const ByteSpan all = source_->at(offset, kChunkHeaderSize + length + kChecksumSize);
  const ByteSpan summed = all.first(kChunkHeaderSize + length);
  if (get_u64(all, summed.size()) != checksum(summed))
    fail(name(), offset, "chunk " + name_of(type) + " is damaged: its checksum does not fit");
  return {type, offset, summed.subspan(kChunkHeaderSize)};
}

std::optional<ChunkView> StreamReader::next() {
  if (done_) return std::nullopt;
  const ChunkView chunk = at(position_);
  if (chunk.type == kDone) {
    check_done(chunk);
    return std::nullopt;
  }
  position_ += kChunkHeaderSize + chunk.payload.size() + kChecksumSize;
  ++chunks_;
  return chunk;
}

void StreamReader::check_done(const ChunkView& done) {
  done_ = true;
  if (done.payload.size() != 16) fail(name(), done.offset, "chunk DONE has not its 16 bytes");
  if (get_u64(done.payload, 8) != chunks_)
    fail(
        name(), done.offset,
        "found " + std::to_string(chunks_) + " chunks, expected " + std::to_string(get_u64(done.payload, 8)));
  const uint64_t end = done.offset + kDoneSize;
  if (!source_->ends_at(end)) fail(name(), end, "found bytes after the closing chunk");
}

uint64_t StreamReader::index_offset() {
  if (source_->size() < kPreludeSize + kDoneSize) source_->at(source_->size(), 1);  // throws: the stream ends
  const uint64_t offset = source_->size() - kDoneSize;
  const ByteSpan type = source_->at(offset, kDone.size());
  if (!std::equal(type.begin(), type.end(), kDone.begin()))
    fail(name(), offset, "expected the closing chunk: the stream is incomplete or has an extra tail");
  const uint64_t index = get_u64(at(offset).payload, 0);
  if (index >= offset) fail(name(), offset, "the index chunk lies after the end");
  return index;
}

std::string StreamReader::place(const ChunkView& chunk) const {
  return name() + ": chunk " + name_of(chunk.type) + " at byte " + std::to_string(chunk.offset);
}

}  // namespace strad
