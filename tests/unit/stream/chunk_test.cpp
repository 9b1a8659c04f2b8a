// The framing of a stream: what was written is read back; damaged input is refused before memory is taken.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.h"
#include "stream/reader.h"
#include "stream/writer.h"

// g++ says by macros which sanitizers a build has, clang by features.
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define STRAD_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define STRAD_SANITIZED
#endif

namespace strad {
namespace {

constexpr ChunkType kCritical = chunk_type("TEST");
constexpr ChunkType kAncillary = chunk_type("note");

Bytes small_stream() {
  Bytes stream;
  StreamWriter writer([&stream](ByteSpan bytes) { stream.insert(stream.end(), bytes.begin(), bytes.end()); });
  writer.add(kCritical, Bytes{1, 2, 3});
  writer.add(kAncillary, Bytes(1000, 7));
  writer.close();
  return stream;
}

std::vector<Chunk> read_all(const Bytes& stream) {
  StreamReader reader(stream, "test");
  std::vector<Chunk> chunks;
  while (const auto chunk = reader.next()) chunks.push_back({chunk->type, reader.content(*chunk)});
  return chunks;
}

// The text of BadInput, or "" if the stream is accepted.
std::string fault_of(const Bytes& stream) {
  try {
    read_all(stream);
    return "";
  } catch (const BadInput& fault) {
    return fault.what();
  }
}

// A stream of one chunk with the payload as given.
Bytes stream_of(const Bytes& payload) {
  Bytes stream;
  StreamWriter writer([&stream](ByteSpan bytes) { stream.insert(stream.end(), bytes.begin(), bytes.end()); });
  writer.add_stored(kCritical, payload);
  writer.close();
  return stream;
}

// Makes the checksum of the chunk at `offset` fit again.
void mend(Bytes* stream, size_t offset) {
  const size_t length = get_u64(*stream, offset + 4);
  const ByteSpan summed = ByteSpan(*stream).subspan(offset, kChunkHeaderSize + length);
  Bytes sum;
  put_u64(&sum, checksum(summed));
  std::copy(sum.begin(), sum.end(), stream->begin() + static_cast<ptrdiff_t>(offset + summed.size()));
}

TEST(Chunks, ComeBack) {
  const std::vector<Chunk> chunks = read_all(small_stream());
  ASSERT_EQ(chunks.size(), 2u);
  EXPECT_EQ(chunks[0].type, kCritical);
  EXPECT_EQ(chunks[0].content, (Bytes{1, 2, 3}));
  EXPECT_EQ(chunks[1].type, kAncillary);
  EXPECT_EQ(chunks[1].content, Bytes(1000, 7));
}

TEST(Chunks, LettersTellWhatIsCritical) {
  EXPECT_TRUE(is_critical(kCritical));
  EXPECT_FALSE(is_critical(kAncillary));
}

TEST(Chunks, EveryTruncationIsRefusedWithItsOffset) {
  const Bytes stream = small_stream();
  for (size_t length = 0; length < stream.size(); ++length) {
    const std::string fault =
        fault_of(Bytes(stream.begin(), stream.begin() + static_cast<ptrdiff_t>(length)));
    EXPECT_NE(fault.find("byte " + std::to_string(length) + ":"), std::string::npos)
        << length << ": " << fault;
  }
}

TEST(Chunks, EveryFlippedBitIsRefused) {
  const Bytes stream = small_stream();
  for (size_t bit = 0; bit < 8 * stream.size(); ++bit) {
    Bytes flipped = stream;
    flipped[bit / 8] = static_cast<uint8_t>(flipped[bit / 8] ^ 1u << bit % 8);
    const std::string fault = fault_of(flipped);
    EXPECT_NE(fault.find("byte "), std::string::npos) << "bit " << bit << ": " << fault;
  }
}

TEST(Chunks, AnExtraTailIsRefused) {
  Bytes stream = small_stream();
  const size_t size = stream.size();
  stream.push_back(0);
  EXPECT_EQ(fault_of(stream), "test: byte " + std::to_string(size) + ": found bytes after the closing chunk");
}

TEST(Chunks, AForeignFileIsRefused) {
  EXPECT_EQ(fault_of(Bytes(100, 'x')), "test: byte 0: this is no strad stream");
  EXPECT_EQ(fault_of({}), "test: byte 0: found nothing, expected a strad stream");
}

TEST(Chunks, AnotherVersionIsRefused) {
  Bytes stream = small_stream();
  stream[8] = 2;
  EXPECT_EQ(fault_of(stream), "test: byte 8: found stream version 2, expected 1");
}

TEST(Chunks, ALyingLengthIsRefused) {
  for (const uint8_t top : {uint8_t{0x00}, uint8_t{0x7f}, uint8_t{0xff}}) {
    Bytes stream = small_stream();
    stream[kPreludeSize + 4 + 6] = 0xff;
    stream[kPreludeSize + 4 + 7] = top;
    EXPECT_NE(fault_of(stream), "");
  }
}

TEST(Chunks, ACountOfChunksThatLiesIsRefused) {
  Bytes stream = small_stream();
  const size_t done = stream.size() - kDoneSize;
  stream[done + kChunkHeaderSize + 8] = 3;
  mend(&stream, done);
  EXPECT_EQ(fault_of(stream), "test: byte " + std::to_string(done) + ": found 2 chunks, expected 3");
}

TEST(Chunks, APayloadThatIsNoZstdFrameIsRefused) {
  EXPECT_NE(fault_of(stream_of({})).find("no zstd frame"), std::string::npos);
  EXPECT_NE(fault_of(stream_of({1, 2, 3, 4, 5, 6, 7, 8})).find("no zstd frame"), std::string::npos);
}

TEST(Chunks, APayloadWithATailIsRefused) {
  Bytes payload = compress(Bytes(100, 1));
  payload.push_back(0);
  EXPECT_NE(fault_of(stream_of(payload)).find("1 bytes after the zstd frame"), std::string::npos);
}

TEST(Chunks, EveryTruncatedPayloadIsRefused) {
  Bytes content;
  for (int i = 0; i < 500; ++i) put_u8(&content, static_cast<uint8_t>(i * i));
  const Bytes payload = compress(content);
  for (size_t length = 0; length < payload.size(); ++length)
    EXPECT_NE(fault_of(stream_of(Bytes(payload.begin(), payload.begin() + static_cast<ptrdiff_t>(length)))),
              "");
}

// A frame header alone: magic, one segment with an 8-byte content size, and the size.
Bytes frame_that_claims(uint64_t size) {
  Bytes payload{0x28, 0xb5, 0x2f, 0xfd, 0xe0};
  put_u64(&payload, size);
  return payload;
}

TEST(Chunks, AContentSizeThatNoFrameOfThatLengthHoldsIsRefused) {
  EXPECT_NE(fault_of(stream_of(frame_that_claims(uint64_t{1} << 50))).find("content size"),
            std::string::npos);
}

// 16 MiB of payload that claim 256 GiB. A zstd frame of that size could hold as much, so the claim is found
// false only by unpacking. With 1 GiB of address space, reserving what is claimed would give bad_alloc
// instead of BadInput.
TEST(Chunks, MemoryIsNotTakenAtTheWordOfAFrame) {
#ifdef STRAD_SANITIZED
  GTEST_SKIP() << "sanitizers reserve terabytes of address space, so it cannot be limited to 1 GiB";
#endif
  Bytes payload = frame_that_claims(uint64_t{1} << 38);
  payload.resize(16 << 20);  // one raw block without content, then zeros
  const Bytes stream = stream_of(payload);
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  const rlimit tight{rlim_t{1} << 30, limit.rlim_max};
  setrlimit(RLIMIT_AS, &tight);
  const std::string fault = fault_of(stream);
  setrlimit(RLIMIT_AS, &limit);
  EXPECT_NE(fault.find("chunk TEST at byte 12"), std::string::npos) << fault;
}

TEST(Chunks, AFileIsReadByOffset) {
  const Bytes stream = small_stream();
  StreamReader reader(stream, "test");
  EXPECT_EQ(reader.at(kPreludeSize).type, kCritical);
  EXPECT_EQ(reader.index_offset(), 0u);
  EXPECT_THROW(reader.at(kPreludeSize + 1), BadInput);
  EXPECT_THROW(reader.at(stream.size() + 5), BadInput);
}

TEST(Chunks, AFileWithATailOrWithoutItsEndHasNoIndex) {
  Bytes stream = small_stream();
  stream.push_back(0);
  EXPECT_THROW(StreamReader(stream, "test").index_offset(), BadInput);
  stream.resize(stream.size() - 2);
  EXPECT_THROW(StreamReader(stream, "test").index_offset(), BadInput);
  stream.resize(kPreludeSize);
  EXPECT_THROW(StreamReader(stream, "test").index_offset(), BadInput);
}

}  // namespace
}  // namespace strad
