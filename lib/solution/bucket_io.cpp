#include "solution/bucket_io.h"

#include <cmath>

#include "base/error.h"
#include "solution/light_code.h"

namespace strad {
namespace {

constexpr uint32_t kMostLog2Cells = 30;

// Does the piece begin where the piece before it in the bucket ends, in the same row?
bool continues(const Bucket& bucket, size_t i) {
  return i > 0 && bucket.rows[i] == bucket.rows[i - 1] &&
         bucket.pieces[i].cell == bucket.pieces[i - 1].cell + bucket.pieces[i - 1].cell_count();
}

// Green as it is, red and blue as differences from it modulo 2^16, since most light is nearly white.
struct Codes {
  uint16_t channel[3];
};

Codes codes_of(Rgb light, double quantum) {
  const int g = light_code(light.g, quantum);
  return {{static_cast<uint16_t>(g), static_cast<uint16_t>(light_code(light.r, quantum) - g),
           static_cast<uint16_t>(light_code(light.b, quantum) - g)}};
}

Rgb light_of(Codes codes, double quantum) {
  const auto channel = [&](int code) { return strad::light_of(static_cast<int16_t>(code), quantum); };
  return {channel(codes.channel[0] + codes.channel[1]), channel(codes.channel[0]),
          channel(codes.channel[0] + codes.channel[2])};
}

// The prediction for coefficient k of piece i: the one before it, in this piece or in the piece that it
// continues.
Codes predicted(const Bucket& bucket, const std::vector<Codes>& codes, size_t i, int k, int order) {
  const size_t at = i * static_cast<size_t>(order) + static_cast<size_t>(k);
  return k > 0 || continues(bucket, i) ? codes[at - 1] : Codes{{0, 0, 0}};
}

uint16_t zigzag16(uint16_t difference) {
  return static_cast<uint16_t>(zigzag(static_cast<int16_t>(difference)));
}

void put_light(Bytes* to, const Bucket& bucket, int order, double quantum) {
  std::vector<Codes> codes;
  for (const Rgb& light : bucket.coefficients) codes.push_back(codes_of(light, quantum));
  std::vector<uint64_t> column(bucket.pieces.size());
  for (int k = 0; k < order; ++k) {
    for (int c = 0; c < 3; ++c) {
      for (size_t i = 0; i < column.size(); ++i) {
        const size_t at = i * static_cast<size_t>(order) + static_cast<size_t>(k);
        const Codes guess = predicted(bucket, codes, i, k, order);
        column[i] = zigzag16(static_cast<uint16_t>(codes[at].channel[c] - guess.channel[c]));
      }
      put_planes(to, column, 2);
    }
  }
}

void get_light(ByteReader* from, int order, double quantum, Bucket* bucket) {
  const size_t pieces = bucket->pieces.size();
  std::vector<std::vector<uint64_t>> columns;
  for (int column = 0; column < 3 * order; ++column) columns.push_back(get_planes(from, pieces, 2));
  std::vector<Codes> codes(pieces * static_cast<size_t>(order));
  bucket->coefficients.resize(codes.size());
  for (size_t i = 0; i < pieces; ++i) {
    for (int k = 0; k < order; ++k) {
      const size_t at = i * static_cast<size_t>(order) + static_cast<size_t>(k);
      const Codes guess = predicted(*bucket, codes, i, k, order);
      for (int c = 0; c < 3; ++c) {
        const int64_t difference = unzigzag(columns[static_cast<size_t>(3 * k + c)][i]);
        codes[at].channel[c] = static_cast<uint16_t>(guess.channel[c] + difference);
      }
      bucket->coefficients[at] = light_of(codes[at], quantum);
      if (!is_finite(bucket->coefficients[at])) from->fail("found light that is not finite");
    }
  }
}

void check_piece(const ByteReader* from, const TimeGrid& grid, const Bucket& bucket, uint64_t cell,
                 uint32_t log2) {
  if (cell + (uint64_t{1} << log2) > bucket.end_cell) from->fail("found a piece beyond its bucket");
  const Span& span = grid.spans[span_of_cell(grid, static_cast<uint32_t>(cell))];
  if (log2 > span.log2_cells || (cell - span.first_cell) % (uint64_t{1} << log2) != 0)
    from->fail("found a piece that is no dyadic interval");
}

void get_pieces(ByteReader* from, const Slab& slab, Bucket* bucket) {
  const size_t count = from->count(3, "pieces");
  uint64_t row = 0;
  for (size_t i = 0; i < count; ++i) {
    row += from->number(slab.mesh.vertices.size(), "a vertex");
    if (row >= slab.mesh.vertices.size()) from->fail("found a vertex out of range");
    bucket->rows.push_back(static_cast<uint32_t>(row));
  }
  bucket->pieces.resize(count);
  for (Interval& piece : bucket->pieces)
    piece.log2_cells = from->number(kMostLog2Cells, "the length of a piece");
  for (size_t i = 0; i < count; ++i) {
    const bool same_row = i > 0 && bucket->rows[i] == bucket->rows[i - 1];
    const uint64_t likely =
        same_row ? bucket->pieces[i - 1].cell + bucket->pieces[i - 1].cell_count() : bucket->first_cell;
    const uint64_t cell = likely + from->number(kNone, "a cell");
    check_piece(from, slab.grid, *bucket, cell, bucket->pieces[i].log2_cells);
    bucket->pieces[i].cell = static_cast<uint32_t>(cell);
  }
}

}  // namespace

Bytes encode_bucket(const Bucket& bucket, int order, int exponent) {
  Bytes content;
  put_varint(&content, bucket.first_cell);
  put_varint(&content, bucket.end_cell);
  put_signed(&content, exponent);
  put_varint(&content, bucket.pieces.size());
  uint32_t row = 0;
  for (const uint32_t next : bucket.rows) {
    put_varint(&content, next - row);
    row = next;
  }
  for (const Interval& piece : bucket.pieces) put_varint(&content, piece.log2_cells);
  for (size_t i = 0; i < bucket.pieces.size(); ++i) {
    const bool same_row = i > 0 && bucket.rows[i] == bucket.rows[i - 1];
    const uint32_t likely =
        same_row ? bucket.pieces[i - 1].cell + bucket.pieces[i - 1].cell_count() : bucket.first_cell;
    put_varint(&content, bucket.pieces[i].cell - likely);
  }
  put_light(&content, bucket, order, std::ldexp(1.0, exponent));
  return content;
}

Bucket decode_bucket(const Slab& slab, ByteSpan content, const std::string& place) {
  ByteReader from(content, place);
  Bucket bucket;
  bucket.first_cell = from.number(slab.grid.cell_count(), "a cell");
  bucket.end_cell = from.number(slab.grid.cell_count(), "a cell");
  const int64_t exponent = from.signed_varint();
  if (exponent < kLowestExponent || exponent > kHighestExponent) from.fail("found a quantum out of range");
  bucket.quantum = static_cast<int>(exponent);
  get_pieces(&from, slab, &bucket);
  get_light(&from, slab.grid.order, std::ldexp(1.0, bucket.quantum), &bucket);
  from.finish();
  return bucket;
}

}  // namespace strad
