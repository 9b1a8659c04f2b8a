// A slab of a solution to chunks and back.
#include "solution/solution_io.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "solution/light_code.h"
#include "solution/mesh_io.h"

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
    chunks->push_back({type, encode_bucket(bucket, field.order, exponent)});
}

}  // namespace

std::vector<Chunk> encode_slab(const Scene& scene, const Slab& slab) {
  std::vector<Chunk> chunks(1);
  chunks[0].type = kSlabChunk;
  put_grid(&chunks[0].content, slab.grid);
  put_mesh(&chunks[0].content, scene, slab.mesh);
  const int exponent = slab.quantum ? *slab.quantum : quantum_exponent(slab);
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
