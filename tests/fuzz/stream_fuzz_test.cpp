// Damaged streams whose checksums fit: each is accepted or refused with BadInput, none does anything else.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "base/rng.h"
#include "solution/stream_io.h"

namespace strad {
namespace {

constexpr uint64_t kRounds = 4000;

Bytes golden_bytes() {
  std::ifstream file(STRAD_SOURCE_DIR "/tests/golden/stream-1.hex");
  Bytes bytes;
  for (std::string line; std::getline(file, line);)
    for (size_t i = 0; !line.starts_with('#') && i + 1 < line.size(); i += 2)
      bytes.push_back(static_cast<uint8_t>(std::stoul(line.substr(i, 2), nullptr, 16)));
  return bytes;
}

// One to four bytes set, lengthened or cut away, at places that depend on `seed` alone.
void mutate(Bytes* content, uint64_t seed) {
  for (uint64_t edit = 0; edit <= hash_of(seed) % 4 && !content->empty(); ++edit) {
    const uint64_t random = hash_of(seed, edit, 1);
    const auto at = content->begin() + static_cast<ptrdiff_t>(random % content->size());
    const uint8_t extremes[] = {0, 1, 0x7f, 0x80, 0xff, static_cast<uint8_t>(random >> 40)};
    switch (random >> 32 & 7) {
      case 0:
        content->insert(at, extremes[random >> 50 & 3]);
        break;
      case 1:
        content->erase(at);
        break;
      case 2:
        content->erase(at, content->end());
        break;
      default:
        *at = extremes[(random >> 50) % 6];
    }
  }
}

TEST(StreamFuzz, DamagedContentIsAcceptedOrRefused) {
  const Bytes golden = golden_bytes();
  StreamReader golden_reader(golden, "golden");
  std::vector<Chunk> chunks;
  while (const auto chunk = golden_reader.next())
    chunks.push_back({chunk->type, golden_reader.content(*chunk)});

  uint64_t refused = 0;
  for (uint64_t round = 0; round < kRounds; ++round) {
    std::vector<Chunk> damaged = chunks;
    mutate(&damaged[hash_of(round, 7) % damaged.size()].content, round);
    if (round % 16 == 0)
      std::swap(damaged[round / 16 % damaged.size()], damaged[round / 256 % damaged.size()]);
    Bytes stream;
    StreamWriter writer([&stream](ByteSpan more) { stream.insert(stream.end(), more.begin(), more.end()); });
    for (const Chunk& chunk : damaged)
      if (chunk.type != kIndexChunk) writer.add(chunk);
    writer.close(writer.add(damaged.back()));
    try {
      StreamReader reader(stream, "damaged");
      read_stream(reader);
    } catch (const BadInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, kRounds / 4);
}

TEST(StreamFuzz, DamagedFramesAreRefused) {
  const Bytes golden = golden_bytes();
  ASSERT_FALSE(golden.empty());
  for (uint64_t round = 0; round < kRounds; ++round) {
    Bytes damaged = golden;
    mutate(&damaged, round);
    if (damaged == golden) continue;
    EXPECT_THROW(
        {
          StreamReader reader(damaged, "damaged");
          read_stream(reader);
        },
        BadInput)
        << round;
  }
}

}  // namespace
}  // namespace strad
