// Reads and writes streams with all that they hold.
#include "solution/stream_io.h"

#include "base/error.h"
#include "scene/scene_io.h"

namespace strad {
namespace {

// Gathers a stream chunk by chunk: first the scene, then the slabs, each with its buckets, then the index.
class Gatherer {
 public:
  explicit Gatherer(const StreamReader& reader) : reader_(reader) {}

  void add(const ChunkView& chunk) {
    const Bytes content = reader_.content(chunk);
    const std::string place = reader_.place(chunk);
    if (SceneDecoder::knows(chunk.type)) {
      if (scene_complete_) throw BadInput(place + ": it comes after the solution");
      scene_.add(chunk.type, content, place);
    } else if (chunk.type == kSlabChunk) {
      add_slab(chunk, content, place);
    } else if (chunk.type == kDirectChunk || chunk.type == kIndirectChunk) {
      if (slabs_.empty() || index_seen_) throw BadInput(place + ": no slab comes before it");
      auto& buckets = chunk.type == kDirectChunk ? direct_ : indirect_;
      buckets.push_back(decode_bucket(slabs_.back(), content, place));
      slabs_.back().quantum = buckets.back().quantum;
      index_.push_back(bucket_entry(chunk.type, chunk.offset, content, place));
    } else if (chunk.type == kIndexChunk) {
      if (index_seen_ || slabs_.empty() || content != encode_index(index_))
        throw BadInput(place + ": it is not the index of this stream");
      index_seen_ = true;
    } else if (is_critical(chunk.type)) {
      refuse(reader_, chunk);
    } else {
      stream_.others.push_back({chunk.type, content});
    }
  }

  Stream finish() {
    if (!scene_complete_) finish_scene();
    if (slabs_.empty()) return std::move(stream_);
    if (!index_seen_) throw BadInput(reader_.name() + ": the solution has no index");
    finish_slab();
    stream_.solution = Solution{std::move(slabs_)};
    try {
      validate(stream_.scene, *stream_.solution);
    } catch (const BadInput& fault) {
      throw BadInput(reader_.name() + ": " + fault.what());
    }
    return std::move(stream_);
  }

 private:
  void add_slab(const ChunkView& chunk, const Bytes& content, const std::string& place) {
    if (index_seen_) throw BadInput(place + ": it comes after the index");
    if (!scene_complete_) finish_scene();
    if (!slabs_.empty()) finish_slab();
    slabs_.push_back(decode_slab(stream_.scene, content, place));
    index_.push_back(slab_entry(chunk.offset, slabs_.back()));
  }

  void finish_scene() {
    stream_.scene = scene_.finish(reader_.name());
    scene_complete_ = true;
  }

  void finish_slab() {
    const std::string place = reader_.name() + ": slab " + std::to_string(slabs_.size() - 1);
    slabs_.back().direct = assemble_field(slabs_.back(), direct_, place + ": direct light");
    slabs_.back().indirect = assemble_field(slabs_.back(), indirect_, place + ": indirect light");
    direct_.clear();
    indirect_.clear();
  }

  const StreamReader& reader_;
  Stream stream_;
  SceneDecoder scene_;
  bool scene_complete_ = false, index_seen_ = false;
  std::vector<Slab> slabs_;
  std::vector<Bucket> direct_, indirect_;  // of the last slab
  std::vector<IndexEntry> index_;
};

}  // namespace

void refuse(const StreamReader& reader, const ChunkView& chunk) {
  throw BadInput(reader.place(chunk) +
                 ": this version of strad does not know it, and it must not be left out");
}

Stream read_stream(StreamReader& reader, const std::function<void(const ChunkView&)>& see) {
  Gatherer gatherer(reader);
  while (const auto chunk = reader.next()) {
    if (see) see(*chunk);
    gatherer.add(*chunk);
  }
  return gatherer.finish();
}

Stream read_stream(const std::string& path) {
  StreamReader reader(path);
  return read_stream(reader);
}

void write_stream(const Stream& stream, StreamWriter& writer) {
  for (const Chunk& chunk : encode_scene(stream.scene)) writer.add(chunk);
  for (const Chunk& chunk : stream.others) writer.add(chunk);
  if (!stream.solution || stream.solution->slabs.empty()) return writer.close();
  std::vector<IndexEntry> index;
  for (const Slab& slab : stream.solution->slabs) {
    for (const Chunk& chunk : encode_slab(stream.scene, slab)) {
      const uint64_t offset = writer.add(chunk);
      index.push_back(chunk.type == kSlabChunk ? slab_entry(offset, slab)
                                               : bucket_entry(chunk.type, offset, chunk.content, "bucket"));
    }
  }
  writer.close(writer.add(kIndexChunk, encode_index(index)));
}

}  // namespace strad
