// Numbers and text to bytes and back, little-endian.
#include "stream/bytes.h"

#include <bit>
#include <cmath>

#include "base/error.h"

namespace strad {
namespace {

void put_low_bytes(Bytes* to, uint64_t value, int count) {
  for (int k = 0; k < count; ++k) to->push_back(static_cast<uint8_t>(value >> (8 * k)));
}

uint64_t get_low_bytes(ByteSpan from, size_t at, int count) {
  uint64_t value = 0;
  for (int k = 0; k < count; ++k) value |= static_cast<uint64_t>(from[at + k]) << (8 * k);
  return value;
}

}  // namespace

void put_u8(Bytes* to, uint8_t value) { to->push_back(value); }
void put_u32(Bytes* to, uint32_t value) { put_low_bytes(to, value, 4); }
void put_u64(Bytes* to, uint64_t value) { put_low_bytes(to, value, 8); }
void put_f32(Bytes* to, float value) { put_u32(to, std::bit_cast<uint32_t>(value)); }
void put_f64(Bytes* to, double value) { put_u64(to, std::bit_cast<uint64_t>(value)); }

void put_varint(Bytes* to, uint64_t value) {
  for (; value >= 0x80; value >>= 7) to->push_back(static_cast<uint8_t>(value | 0x80));
  to->push_back(static_cast<uint8_t>(value));
}

void put_signed(Bytes* to, int64_t value) { put_varint(to, zigzag(value)); }

void put_text(Bytes* to, std::string_view text) {
  put_varint(to, text.size());
  to->insert(to->end(), text.begin(), text.end());
}

uint32_t get_u32(ByteSpan from, size_t at) { return static_cast<uint32_t>(get_low_bytes(from, at, 4)); }
uint64_t get_u64(ByteSpan from, size_t at) { return get_low_bytes(from, at, 8); }

void ByteReader::fail(const std::string& fault) const {
  throw BadInput(place_ + ": content byte " + std::to_string(at_) + ": " + fault);
}

void ByteReader::need(uint64_t count) const {
  if (count > remaining())
    fail("found " + std::to_string(remaining()) + " more bytes, expected " + std::to_string(count));
}

ByteSpan ByteReader::bytes(uint64_t count) {
  need(count);
  const ByteSpan result = bytes_.subspan(at_, count);
  at_ += count;
  return result;
}

uint8_t ByteReader::u8() { return bytes(1)[0]; }
uint32_t ByteReader::u32() { return get_u32(bytes(4), 0); }
uint64_t ByteReader::u64() { return get_u64(bytes(8), 0); }

float ByteReader::f32() {
  const float value = std::bit_cast<float>(u32());
  if (!std::isfinite(value)) fail("found a number that is not finite");
  return value;
}

double ByteReader::f64() {
  const double value = std::bit_cast<double>(u64());
  if (!std::isfinite(value)) fail("found a number that is not finite");
  return value;
}

uint64_t ByteReader::varint() {
  uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const uint8_t byte = u8();
    if (shift == 63 && byte > 1) break;  // more than 64 bits
    value |= static_cast<uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  fail("found a number of more than 64 bits");
}

int64_t ByteReader::signed_varint() { return unzigzag(varint()); }

uint32_t ByteReader::number(uint64_t most, const char* what) {
  const uint64_t value = varint();
  if (value > most)
    fail("found " + std::to_string(value) + " for " + what + ", expected at most " + std::to_string(most));
  return static_cast<uint32_t>(value);
}

size_t ByteReader::count(size_t bytes_each, const char* what) {
  const uint64_t value = varint();
  if (value > remaining() / bytes_each)
    fail("found a count of " + std::to_string(value) + " " + what + ", more than the " +
         std::to_string(remaining()) + " bytes left can hold");
  return static_cast<size_t>(value);
}

std::string ByteReader::text() {
  const ByteSpan letters = bytes(count(1, "letters"));
  return {letters.begin(), letters.end()};
}

void ByteReader::finish() const {
  if (remaining() > 0) fail("found " + std::to_string(remaining()) + " bytes more than expected");
}

void put_planes(Bytes* to, std::span<const uint64_t> values, int width) {
  for (int k = 0; k < width; ++k)
    for (const uint64_t value : values) to->push_back(static_cast<uint8_t>(value >> (8 * k)));
}

std::vector<uint64_t> get_planes(ByteReader* from, size_t count, int width) {
  if (count > from->remaining() / width)
    from->bytes(from->remaining() + 1);  // refused before memory is taken
  std::vector<uint64_t> values(count);
  for (int k = 0; k < width; ++k) {
    const ByteSpan plane = from->bytes(count);
    for (size_t i = 0; i < count; ++i) values[i] |= static_cast<uint64_t>(plane[i]) << (8 * k);
  }
  return values;
}

}  // namespace strad
