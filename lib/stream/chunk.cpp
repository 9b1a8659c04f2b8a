// Checksums and compression of chunks: the only user of zstd and xxhash.
#include "stream/chunk.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

#include "base/error.h"

namespace strad {
namespace {

// Level 12 writes the solution of a 600-frame scene in about a second; 19 takes ten times as long for 2 %
// less.
constexpr int kLevel = 12;
// A zstd block of 4 bytes can stand for at most 128 KiB: no frame holds more than this for each of its bytes.
constexpr uint64_t kMostExpansion = (128 << 10) / 4;

[[noreturn]] void fail(const std::string& place, const std::string& fault) {
  throw BadInput(place + ": " + fault);
}

using Decompressor = std::unique_ptr<ZSTD_DCtx, size_t (*)(ZSTD_DCtx*)>;

}  // namespace

uint64_t checksum(ByteSpan bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

Bytes compress(ByteSpan content) {
  Bytes payload(ZSTD_compressBound(content.size()));
  const size_t size = ZSTD_compress(payload.data(), payload.size(), content.data(), content.size(), kLevel);
  if (ZSTD_isError(size)) throw IoError(std::string("zstd: ") + ZSTD_getErrorName(size));
  payload.resize(size);
  return payload;
}

uint64_t content_size(ByteSpan payload, const std::string& place) {
  const unsigned long long size = ZSTD_getFrameContentSize(payload.data(), payload.size());
  if (size == ZSTD_CONTENTSIZE_ERROR) fail(place, "found no zstd frame in the payload");
  if (size == ZSTD_CONTENTSIZE_UNKNOWN) fail(place, "found a zstd frame without its content size");
  if (size / kMostExpansion > payload.size())
    fail(place, "found a content size of " + std::to_string(size) + ", more than " +
                    std::to_string(payload.size()) + " bytes can hold");
  return size;
}

Bytes decompress(ByteSpan payload, const std::string& place) {
  const uint64_t declared = content_size(payload, place);
  const Decompressor context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();

  Bytes content;
  ZSTD_inBuffer in{payload.data(), payload.size(), 0};
  for (size_t left = 1; left != 0;) {
    // The buffer doubles as content is unpacked, so that a frame with a false size costs only what it holds.
    const size_t done = content.size();
    const uint64_t room = std::max<uint64_t>(64 << 10, std::max<uint64_t>(done, 4 * payload.size()));
    content.resize(static_cast<size_t>(std::min(declared, done + room)));
    ZSTD_outBuffer out{content.data(), content.size(), done};
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left)) fail(place, std::string("damaged zstd frame: ") + ZSTD_getErrorName(left));
    const bool stuck = out.pos == done && in.pos == in.size;
    content.resize(out.pos);
    if (left != 0 && stuck) fail(place, "the zstd frame is incomplete");
  }
  if (in.pos != in.size)
    fail(place, "found " + std::to_string(in.size - in.pos) + " bytes after the zstd frame");
  if (content.size() != declared) fail(place, "the zstd frame holds another size than it states");
  return content;
}

}  // namespace strad
