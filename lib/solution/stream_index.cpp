// The index of a solution to bytes and back.
#include "solution/stream_index.h"

#include <algorithm>

namespace strad {

IndexEntry slab_entry(uint64_t offset, const Slab& slab) {
  return {kSlabChunk, offset, slab_begin(slab), slab_end(slab), 0, 0};
}

IndexEntry bucket_entry(ChunkType type, uint64_t offset, ByteSpan content, const std::string& place) {
  ByteReader from(content, place);
  const uint32_t first = from.number(kNone, "a cell");
  return {type, offset, 0, 0, first, from.number(kNone, "a cell")};
}

Bytes encode_index(const std::vector<IndexEntry>& entries) {
  Bytes content;
  put_varint(&content, entries.size());
  for (const IndexEntry& entry : entries) {
    content.insert(content.end(), entry.type.begin(), entry.type.end());
    put_u64(&content, entry.offset);
    if (entry.type == kSlabChunk) {
      put_f64(&content, entry.begin);
      put_f64(&content, entry.end);
    } else {
      put_varint(&content, entry.first_cell);
      put_varint(&content, entry.end_cell);
    }
  }
  return content;
}

std::vector<IndexEntry> decode_index(ByteSpan content, const std::string& place) {
  ByteReader from(content, place);
  std::vector<IndexEntry> entries(from.count(14, "entries"));
  uint64_t offset = 0;
  const IndexEntry* slab = nullptr;
  for (IndexEntry& entry : entries) {
    const ByteSpan letters = from.bytes(entry.type.size());
    std::copy(letters.begin(), letters.end(), entry.type.begin());
    entry.offset = from.u64();
    if (entry.offset <= offset) from.fail("found an offset that does not ascend");
    offset = entry.offset;
    if (entry.type == kSlabChunk) {
      entry.begin = from.f64();
      entry.end = from.f64();
      if (entry.end < entry.begin || (slab && entry.begin != slab->end))
        from.fail("found a slab of time that does not begin where the last one ends");
      slab = &entry;
    } else if (slab && (entry.type == kDirectChunk || entry.type == kIndirectChunk)) {
      entry.first_cell = from.number(kNone, "a cell");
      entry.end_cell = from.number(kNone, "a cell");
    } else {
      from.fail("found an entry of another type than SLAB, DLIT, ILIT, or no slab before it");
    }
  }
  if (entries.empty()) from.fail("found no entry, expected a slab");
  from.finish();
  return entries;
}

}  // namespace strad
