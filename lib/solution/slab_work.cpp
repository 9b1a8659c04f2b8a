#include "solution/slab_work.h"

#include <algorithm>

namespace strad {
namespace {

// The counts of a chunk, in the order in which they are stored.
template <typename Work, typename Visit>
void for_counts(Work& work, Visit visit) {
  for (auto* count : {&work.clusters, &work.links, &work.links_refined_in_time, &work.links_refined_in_space,
                      &work.kernel_evaluations, &work.rays, &work.iterations})
    visit(*count);
}

}  // namespace

Chunk encode_work(const SlabWork& work) {
  Chunk chunk{kWorkChunk, {}};
  put_f64(&chunk.content, work.begin);
  put_f64(&chunk.content, work.end);
  for_counts(work, [&](uint64_t count) { put_varint(&chunk.content, count); });
  return chunk;
}

SlabWork decode_work(ByteSpan content, const std::string& place) {
  ByteReader from(content, place);
  SlabWork work;
  work.begin = from.f64();
  work.end = from.f64();
  for_counts(work, [&](uint64_t& count) { count = from.varint(); });
  from.finish();
  return work;
}

void drop_work(std::vector<Chunk>* chunks) {
  std::erase_if(*chunks, [](const Chunk& chunk) { return chunk.type == kWorkChunk; });
}

}  // namespace strad
