// A slab of a solution to chunks and back.
#include "solve/solution_io.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "solve/light_code.h"
#include "solve/mesh_io.h"

namespace strad {
namespace {

constexpr int kDeepestBucket = 5;  // 1/32 of the slab
constexpr uint32_t kMostLog2Cells = 30;

// The smallest node of the binary tree over `cell_count` cells that holds `piece`.
std::pair<uint32_t, uint32_t> bucket_of(uint32_t cell_count, Interval piece) {
  const uint64_t count = cell_count, piece_end = uint64_t{piece.cell} + piece.cell_count();
  uint64_t node = 0;
  int depth = 0;
  const auto begin_of = [&](uint64_t n, int d) { return count * n >> d; };
  while (depth < kDeepestBucket) {
    const uint64_t middle = begin_of(2 * node + 1, depth + 1);
    if (piece.cell < middle && middle < piece_end) break;
    node = 2 * node + (piece.cell >= middle ? 1 : 0);
    ++depth;
  }
  return {static_cast<uint32_t>(begin_of(node, depth)), static_cast<uint32_t>(begin_of(node + 1, depth))};
}

struct InTreeOrder {  // parents before children, then by time
  bool operator()(std::pair<uint32_t, uint32_t> a, std::pair<uint32_t, uint32_t> b) const {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  }
};

std::vector<Bucket> buckets_of(const TimeGrid& grid, const Field& field) {
  std::map<std::pair<uint32_t, uint32_t>, Bucket, InTreeOrder> buckets;
  const uint32_t cell_count = grid.cell_count();
  for (uint32_t row = 0; row < field.row_count(); ++row) {
    for (uint32_t p = field.first_piece[row]; p < field.first_piece[row + 1]; ++p) {
      const auto range = bucket_of(cell_count, field.pieces[p]);
      Bucket& bucket = buckets[range];
      bucket.first_cell = range.first;
      bucket.end_cell = range.second;
      bucket.rows.push_back(row);
      bucket.pieces.push_back(field.pieces[p]);
      const auto first = field.coefficients.begin() + p * static_cast<ptrdiff_t>(field.order);
      bucket.coefficients.insert(bucket.coefficients.end(), first, first + field.order);
    }
  }
  std::vector<Bucket> list;
  for (auto& [range, bucket] : buckets) list.push_back(std::move(bucket));
  return list;
}

// Does the piece go on where the one before it in the bucket ended?
bool continues(const Bucket& bucket, size_t i) {
  return i > 0 && bucket.rows[i] == bucket.rows[i - 1] &&
         bucket.pieces[i].cell == bucket.pieces[i - 1].cell + bucket.pieces[i - 1].cell_count();
}

// Green as it is, red and blue as differences from it, since most light is nearly white; 16 bits, wrapping.
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

// What coefficient k of piece i is likely to be: what was last, in the piece or in the one that it continues.
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

Bytes encode_bucket(const Bucket& bucket, int order, double quantum, int exponent) {
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
  put_light(&content, bucket, order, quantum);
  return content;
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

void put_grid(Bytes* to, const TimeGrid& grid) {
  put_u8(to, static_cast<uint8_t>(grid.order));
  put_varint(to, grid.spans.size());
  put_f64(to, grid.spans.front().begin);
  for (const Span& span : grid.spans) {
    put_f64(to, span.end);
    put_u8(to, static_cast<uint8_t>(span.log2_cells));
  }
}

TimeGrid get_grid(ByteReader* from) {
  TimeGrid grid;
  grid.order = static_cast<int>(from->number(kMaxOrder, "an order"));
  if (grid.order < 1) from->fail("found order 0, expected 1 to 3");
  grid.spans.resize(from->count(9, "spans"));
  if (grid.spans.empty()) from->fail("found no span of time, expected at least one");
  double begin = from->f64();
  uint64_t cells = 0;
  for (Span& span : grid.spans) {
    span.begin = begin;
    span.end = begin = from->f64();
    if (span.end < span.begin) from->fail("found a span that ends before it begins");
    span.log2_cells = from->number(kMostLog2Cells, "cells");
    span.first_cell = static_cast<uint32_t>(cells);
    cells += uint64_t{1} << span.log2_cells;
    if (cells > uint64_t{1} << kMostLog2Cells) from->fail("found too many cells");
  }
  return grid;
}

void add_field(const Slab& slab, const Field& field, ChunkType type, int exponent,
               std::vector<Chunk>* chunks) {
  for (const Bucket& bucket : buckets_of(slab.grid, field))
    chunks->push_back({type, encode_bucket(bucket, field.order, std::ldexp(1.0, exponent), exponent)});
}

}  // namespace

std::vector<Chunk> encode_slab(const Scene& scene, const Slab& slab) {
  std::vector<Chunk> chunks(1);
  chunks[0].type = kSlabChunk;
  put_grid(&chunks[0].content, slab.grid);
  put_mesh(&chunks[0].content, scene, slab.mesh);
  const int exponent = quantum_exponent(slab);
  add_field(slab, slab.direct, kDirectChunk, exponent, &chunks);
  add_field(slab, slab.indirect, kIndirectChunk, exponent, &chunks);
  return chunks;
}

Slab decode_slab(const Scene& scene, ByteSpan content, const std::string& place) {
  ByteReader from(content, place);
  Slab slab;
  slab.grid = get_grid(&from);
  slab.mesh = get_mesh(&from, scene);
  from.finish();
  for (Field* field : {&slab.direct, &slab.indirect}) {
    field->order = slab.grid.order;
    field->first_piece.assign(slab.mesh.vertices.size() + 1, 0);
  }
  return slab;
}

Bucket decode_bucket(const Slab& slab, ByteSpan content, const std::string& place) {
  ByteReader from(content, place);
  Bucket bucket;
  bucket.first_cell = from.number(slab.grid.cell_count(), "a cell");
  bucket.end_cell = from.number(slab.grid.cell_count(), "a cell");
  const int64_t exponent = from.signed_varint();
  if (exponent < kLowestExponent || exponent > kHighestExponent) from.fail("found a quantum out of range");
  get_pieces(&from, slab, &bucket);
  get_light(&from, slab.grid.order, std::ldexp(1.0, static_cast<int>(exponent)), &bucket);
  from.finish();
  return bucket;
}

Field assemble_field(const Slab& slab, const std::vector<Bucket>& buckets, const std::string& place) {
  struct Place {
    const Bucket* bucket;
    size_t piece;
    uint32_t cell() const { return bucket->pieces[piece].cell; }
  };
  Field field;
  field.order = slab.grid.order;
  field.first_piece.assign(slab.mesh.vertices.size() + 1, 0);
  for (const Bucket& bucket : buckets)
    for (const uint32_t row : bucket.rows) ++field.first_piece[row + 1];
  for (size_t row = 0; row < slab.mesh.vertices.size(); ++row)
    field.first_piece[row + 1] += field.first_piece[row];

  std::vector<Place> places(field.first_piece.back());
  std::vector<uint32_t> next(field.first_piece.begin(), field.first_piece.end() - 1);
  for (const Bucket& bucket : buckets)
    for (size_t i = 0; i < bucket.rows.size(); ++i) places[next[bucket.rows[i]]++] = {&bucket, i};
  for (size_t row = 0; row < slab.mesh.vertices.size(); ++row)
    std::sort(places.begin() + field.first_piece[row], places.begin() + field.first_piece[row + 1],
              [](const Place& a, const Place& b) { return a.cell() < b.cell(); });

  for (const auto& [bucket, piece] : places) {
    field.pieces.push_back(bucket->pieces[piece]);
    const auto first = bucket->coefficients.begin() + static_cast<ptrdiff_t>(piece) * field.order;
    field.coefficients.insert(field.coefficients.end(), first, first + field.order);
  }
  for (size_t row = 0; row < slab.mesh.vertices.size(); ++row)
    for (uint32_t p = field.first_piece[row] + 1; p < field.first_piece[row + 1]; ++p)
      if (field.pieces[p].cell < field.pieces[p - 1].cell + field.pieces[p - 1].cell_count())
        throw BadInput(place + ": two pieces of vertex " + std::to_string(row) + " overlap in time");
  return field;
}

std::vector<uint32_t> cells_needed(const TimeGrid& grid, double begin, double end) {
  std::vector<uint32_t> cells;
  for (uint32_t cell = cell_at(grid, begin); cell <= cell_at(grid, end); ++cell) {
    cells.push_back(cell);
    const Span& span = grid.spans[span_of_cell(grid, cell)];
    for (uint32_t log2 = 0; log2 < span.log2_cells; ++log2) {
      const uint32_t first = ((cell - span.first_cell) >> log2 << log2) + span.first_cell;
      if (first > span.first_cell) cells.push_back(first - 1);
      const uint32_t after = first + (1u << log2);
      if (after < span.first_cell + (1u << span.log2_cells)) cells.push_back(after);
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace strad
