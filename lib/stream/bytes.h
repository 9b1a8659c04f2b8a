// Numbers and text to bytes and back, little-endian, for all chunks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace strad {

using Bytes = std::vector<uint8_t>;
using ByteSpan = std::span<const uint8_t>;

void put_u8(Bytes* to, uint8_t value);
void put_u32(Bytes* to, uint32_t value);
void put_u64(Bytes* to, uint64_t value);
void put_f32(Bytes* to, float value);        // IEEE 754 bits
void put_f64(Bytes* to, double value);       // IEEE 754 bits
void put_varint(Bytes* to, uint64_t value);  // LEB128: 7 bits per byte, low ones first; high bit: more follow
void put_signed(Bytes* to, int64_t value);   // zigzag (0, -1, 1, -2 ...) as a varint
void put_text(Bytes* to, std::string_view text);  // varint length, then the bytes

uint32_t get_u32(ByteSpan from, size_t at);  // REQUIRES: at + 4 <= from.size()
uint64_t get_u64(ByteSpan from, size_t at);  // REQUIRES: at + 8 <= from.size()

constexpr uint64_t zigzag(int64_t value) {
  return (static_cast<uint64_t>(value) << 1) ^ static_cast<uint64_t>(value >> 63);
}
constexpr int64_t unzigzag(uint64_t value) {
  return static_cast<int64_t>(value >> 1) ^ -static_cast<int64_t>(value & 1);
}

// Reads what the `put` functions wrote. Throws BadInput "PLACE: byte N: ..." instead of reading past the end.
class ByteReader {
 public:
  // `place` says what `bytes` are, for errors. Keeps the span.
  ByteReader(ByteSpan bytes, std::string place) : bytes_(bytes), place_(std::move(place)) {}

  uint8_t u8();
  uint32_t u32();
  uint64_t u64();
  float f32();   // finite
  double f64();  // finite
  uint64_t varint();
  int64_t signed_varint();
  std::string text();
  ByteSpan bytes(uint64_t count);

  // A varint of at most `most`.
  uint32_t number(uint64_t most, const char* what);
  // A count of items that take at least `bytes_each` bytes each. Refused if the bytes left cannot hold them.
  size_t count(size_t bytes_each, const char* what);

  const std::string& place() const { return place_; }
  size_t remaining() const { return bytes_.size() - at_; }
  void finish() const;  // throws unless all was read
  [[noreturn]] void fail(const std::string& fault) const;

 private:
  void need(uint64_t count) const;

  ByteSpan bytes_;
  std::string place_;
  size_t at_ = 0;
};

// Values as planes of bytes: byte 0 of every value, then byte 1 of every value, and so on. Similar bytes then
// lie together, which zstd compresses well. `width` is the bytes per value, 1..8.
void put_planes(Bytes* to, std::span<const uint64_t> values, int width);
std::vector<uint64_t> get_planes(ByteReader* from, size_t count, int width);

}  // namespace strad
