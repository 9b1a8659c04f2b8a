// Numbers as glTF stores them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace strad {

// The format's codes of component types.
enum GltfComponent {
  kGltfByte = 5120,
  kGltfUnsignedByte = 5121,
  kGltfShort = 5122,
  kGltfUnsignedShort = 5123,
  kGltfUnsignedInt = 5125,
  kGltfFloat = 5126
};

// 0 for a type that the format does not have.
inline size_t bytes_of_component(int type) {
  switch (type) {
    case kGltfByte:
    case kGltfUnsignedByte:
      return 1;
    case kGltfShort:
    case kGltfUnsignedShort:
      return 2;
    case kGltfUnsignedInt:
    case kGltfFloat:
      return 4;
    default:
      return 0;
  }
}

template <class Number>
double stored_number(const unsigned char* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

// REQUIRES: a type that the format has, and as many bytes.
inline double component_at(const unsigned char* bytes, int type) {
  switch (type) {
    case kGltfByte:
      return stored_number<int8_t>(bytes);
    case kGltfUnsignedByte:
      return stored_number<uint8_t>(bytes);
    case kGltfShort:
      return stored_number<int16_t>(bytes);
    case kGltfUnsignedShort:
      return stored_number<uint16_t>(bytes);
    case kGltfUnsignedInt:
      return stored_number<uint32_t>(bytes);
    default:
      return stored_number<float>(bytes);
  }
}

// Normalized integers as the format says (section 3.11): a quotient, not below -1.
inline double normalized_value(double value, int type) {
  switch (type) {
    case kGltfByte:
      return std::max(value / 127, -1.0);
    case kGltfUnsignedByte:
      return value / 255;
    case kGltfShort:
      return std::max(value / 32767, -1.0);
    case kGltfUnsignedShort:
      return value / 65535;
    default:
      return value;
  }
}

}  // namespace strad
