// A bucket to bytes and back: the pieces of a field that lie in one stretch of time.
#pragma once

#include <string>
#include <vector>

#include "solution/solution.h"
#include "stream/bytes.h"

namespace strad {

struct Bucket {
  uint32_t first_cell = 0, end_cell = 0;  // all its pieces lie in [first_cell, end_cell)
  std::vector<uint32_t> rows;             // per piece, ascending
  std::vector<Interval> pieces;           // in order of row, then time
  std::vector<Rgb> coefficients;
  int quantum = 0;  // of what was decoded: the exponent of its light code's quantum
};

// The quantum of the light code is 2^exponent W / m^2 (light_code.h).
Bytes encode_bucket(const Bucket& bucket, int order, int exponent);
// Throws BadInput. REQUIRES: `slab` came from decode_slab.
Bucket decode_bucket(const Slab& slab, ByteSpan content, const std::string& place);

}  // namespace strad
