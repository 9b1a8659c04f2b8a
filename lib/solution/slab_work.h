// Counts of the work that the solve of a slab took, in an ancillary chunk `work` before the solution.
//
// They are the same for any number of threads. Times are not among them; `strad-solve --stats` has these.
#pragma once

#include <vector>

#include "solution/solution.h"
#include "stream/chunk.h"

namespace strad {

constexpr ChunkType kWorkChunk = chunk_type("work");

struct SlabWork {
  double begin = 0, end = 0;  // s, of the slab
  uint64_t clusters = 0, links = 0, links_refined_in_time = 0, links_refined_in_space = 0;
  uint64_t kernel_evaluations = 0, rays = 0, iterations = 0;
};

Chunk encode_work(const SlabWork& work);
// Throws BadInput.
SlabWork decode_work(ByteSpan content, const std::string& place);

// Removes the entries of slabs that no longer exist.
void drop_work(std::vector<Chunk>* chunks);

}  // namespace strad
