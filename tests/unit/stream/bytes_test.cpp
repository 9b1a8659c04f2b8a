// Numbers and text as bytes: every value is read back; truncated input and false counts are refused.
#include "stream/bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"

namespace strad {
namespace {

TEST(Bytes, LieLittleEndian) {
  Bytes bytes;
  put_u32(&bytes, 0x04030201);
  put_u64(&bytes, 0x0c0b0a0908070605);
  put_f32(&bytes, 1.0f);
  EXPECT_EQ(bytes, (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0x80, 0x3f}));
}

TEST(Bytes, VarintsTakeSevenBitsAByte) {
  Bytes bytes;
  put_varint(&bytes, 127);
  put_varint(&bytes, 300);
  put_signed(&bytes, -1);
  EXPECT_EQ(bytes, (Bytes{0x7f, 0xac, 0x02, 0x01}));
}

TEST(Bytes, EveryVarintComesBack) {
  for (const int64_t value : {int64_t{0}, int64_t{1}, int64_t{-1}, int64_t{63}, int64_t{64}, int64_t{-65},
                              std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::min()}) {
    Bytes bytes;
    put_signed(&bytes, value);
    ByteReader reader(bytes, "test");
    EXPECT_EQ(reader.signed_varint(), value);
    reader.finish();
  }
}

TEST(Bytes, PlanesComeBack) {
  const std::vector<uint64_t> values{0, 1, 256, 65535};
  Bytes bytes;
  put_planes(&bytes, values, 2);
  EXPECT_EQ(bytes, (Bytes{0, 1, 0, 255, 0, 0, 1, 255}));
  ByteReader reader(bytes, "test");
  EXPECT_EQ(get_planes(&reader, values.size(), 2), values);
}

TEST(Bytes, ShortInputIsRefusedWithItsPlace) {
  const Bytes bytes{1, 2, 3, 4, 5};
  ByteReader reader(bytes, "room.strad: chunk VERT");
  reader.u8();
  reader.u8();
  try {
    reader.u32();
    FAIL() << "expected BadInput";
  } catch (const BadInput& fault) {
    EXPECT_STREQ(fault.what(), "room.strad: chunk VERT: content byte 2: found 3 more bytes, expected 4");
  }
}

TEST(Bytes, LyingCountsAreRefused) {
  Bytes bytes;
  put_varint(&bytes, uint64_t{1} << 60);
  put_u64(&bytes, 0);
  EXPECT_THROW(ByteReader(bytes, "test").count(1, "things"), BadInput);
  EXPECT_THROW(ByteReader(bytes, "test").text(), BadInput);
  ByteReader reader(bytes, "test");
  EXPECT_THROW(get_planes(&reader, size_t{1} << 60, 8), BadInput);
}

TEST(Bytes, OverlongVarintsAreRefused) {
  const Bytes bytes(11, 0xff);
  EXPECT_THROW(ByteReader(bytes, "test").varint(), BadInput);
  const Bytes bits65{0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x02};
  EXPECT_THROW(ByteReader(bits65, "test").varint(), BadInput);
}

TEST(Bytes, NumbersThatAreNotFiniteAreRefused) {
  Bytes bytes;
  put_f32(&bytes, std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(ByteReader(bytes, "test").f32(), BadInput);
  bytes.clear();
  put_f64(&bytes, std::numeric_limits<double>::infinity());
  EXPECT_THROW(ByteReader(bytes, "test").f64(), BadInput);
}

TEST(Bytes, WhatIsLeftOverIsRefused) {
  const Bytes bytes{1, 2};
  ByteReader reader(bytes, "test");
  reader.u8();
  EXPECT_THROW(reader.finish(), BadInput);
}

}  // namespace
}  // namespace strad
