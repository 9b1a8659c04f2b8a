// The index of a solution: where its chunks stand in a file and which time they cover.
#pragma once

#include <vector>

#include "solution/solution_io.h"

namespace strad {

struct IndexEntry {
  ChunkType type{};                       // SLAB, DLIT or ILIT; buckets follow their slab
  uint64_t offset = 0;                    // in the stream
  double begin = 0, end = 0;              // s, of a slab
  uint32_t first_cell = 0, end_cell = 0;  // of a bucket
};

IndexEntry slab_entry(uint64_t offset, const Slab& slab);
// `content`: of a DLIT or ILIT chunk. Throws BadInput.
IndexEntry bucket_entry(ChunkType type, uint64_t offset, ByteSpan content, const std::string& place);

Bytes encode_index(const std::vector<IndexEntry>& entries);
// Throws BadInput unless entries ascend, begin with a slab, and slabs are adjacent in time.
std::vector<IndexEntry> decode_index(ByteSpan content, const std::string& place);

}  // namespace strad
