// A solution to chunks and back; strad(5) has the tables.
//
// A slab is one SLAB chunk (time grid and mesh) followed by its buckets, DLIT for direct and ILIT for
// indirect light. Buckets are the nodes of a binary tree of depth five over the slab's cells. A piece is
// stored in the smallest bucket that contains its interval, so the light at an instant is in few buckets.
#pragma once

#include <vector>

#include "solution/bucket_io.h"
#include "solution/solution.h"
#include "stream/chunk.h"

namespace strad {

constexpr ChunkType kSlabChunk = chunk_type("SLAB");
constexpr ChunkType kDirectChunk = chunk_type("DLIT");
constexpr ChunkType kIndirectChunk = chunk_type("ILIT");
constexpr ChunkType kIndexChunk = chunk_type("INDX");

// The SLAB chunk, then the buckets, direct before indirect, in order of time.
// REQUIRES: validate(scene, ...) passed.
std::vector<Chunk> encode_slab(const Scene& scene, const Slab& slab);

// Grid and mesh; the fields have the right order and number of rows, and no pieces.
Slab decode_slab(const Scene& scene, ByteSpan content, const std::string& place);

// The field of all `buckets`. Throws BadInput when two pieces of a row overlap.
Field assemble_field(const Slab& slab, const std::vector<Bucket>& buckets, const std::string& place);

// The cells whose pieces may be needed to evaluate light in [begin, end], ascending: those of that time, and
// for the correction at boundaries the cells next to each dyadic interval that contains one of them.
std::vector<uint32_t> cells_needed(const TimeGrid& grid, double begin, double end);

}  // namespace strad
