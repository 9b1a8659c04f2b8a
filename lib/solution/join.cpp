#include "solution/join.h"

#include <algorithm>

#include "base/error.h"
#include "scene/scene_io.h"
#include "solution/stream_io.h"

namespace strad {
namespace {

struct StoredChunk {
  ChunkType type{};
  Bytes payload;  // as stored
  IndexEntry entry;
};

struct StoredSlab {
  std::string place;
  std::vector<StoredChunk> chunks;
  double begin() const { return chunks[0].entry.begin; }
  double end() const { return chunks[0].entry.end; }
};

struct Part {
  std::string name;
  Scene scene;
  std::vector<Chunk> scene_chunks, others;
  std::vector<StoredSlab> slabs;
};

// Reads and checks one stream like any other, and keeps the bytes of its slabs as stored.
Part read_part(const std::string& path) {
  StreamReader reader(path);
  Part part;
  part.name = reader.name();
  const auto keep = [&](const ChunkView& chunk) {
    const bool is_slab = chunk.type == kSlabChunk;
    const bool is_light = chunk.type == kDirectChunk || chunk.type == kIndirectChunk;
    if (is_slab) part.slabs.push_back({reader.place(chunk), {}});
    if (SceneDecoder::knows(chunk.type)) part.scene_chunks.push_back({chunk.type, reader.content(chunk)});
    if (!is_slab && (!is_light || part.slabs.empty())) return;
    StoredChunk stored{chunk.type, Bytes(chunk.payload.begin(), chunk.payload.end()), {}};
    if (is_light) stored.entry = bucket_entry(chunk.type, 0, reader.content(chunk), reader.place(chunk));
    part.slabs.back().chunks.push_back(std::move(stored));
  };
  Stream stream = read_stream(reader, keep);
  if (!stream.solution) throw BadInput(part.name + ": found no solution, expected one from strad-solve");
  for (size_t i = 0; i < part.slabs.size(); ++i)
    part.slabs[i].chunks[0].entry = slab_entry(0, stream.solution->slabs[i]);
  part.scene = std::move(stream.scene);
  part.others = std::move(stream.others);
  return part;
}

bool same(const Chunk& a, const Chunk& b) { return a.type == b.type && a.content == b.content; }

void check_same_scene(const Part& first, const Part& part) {
  const auto is_scene = [](const Chunk& chunk) {
    return is_critical(chunk.type);
  };  // provenance is ancillary
  auto a = std::find_if(first.scene_chunks.begin(), first.scene_chunks.end(), is_scene);
  auto b = std::find_if(part.scene_chunks.begin(), part.scene_chunks.end(), is_scene);
  for (; a != first.scene_chunks.end() && b != part.scene_chunks.end(); ++a, ++b)
    if (!same(*a, *b))
      throw BadInput(part.name + ": its scene differs from that of " + first.name + " in chunk " +
                     name_of(b->type));
  if (a != first.scene_chunks.end() || b != part.scene_chunks.end())
    throw BadInput(part.name + ": its scene has not as many chunks as that of " + first.name);
}

// Every line or chunk once, in order of first appearance.
template <typename Item, typename Same>
void add_new(const std::vector<Item>& from, std::vector<Item>* to, Same same) {
  for (const Item& item : from)
    if (std::none_of(to->begin(), to->end(), [&](const Item& other) { return same(item, other); }))
      to->push_back(item);
}

void check_adjacent(const std::vector<StoredSlab>& slabs) {
  for (size_t i = 1; i < slabs.size(); ++i) {
    const double end = slabs[i - 1].end(), begin = slabs[i].begin();
    if (begin == end) continue;
    throw BadInput(slabs[i].place + ": it begins at " + std::to_string(begin) + " s, which leaves " +
                   (begin > end ? "a gap" : "an overlap") + ": expected " + std::to_string(end) +
                   " s, where " + slabs[i - 1].place + " ends");
  }
}

}  // namespace

void join(const std::vector<std::string>& paths, const std::string& provenance, StreamWriter& writer) {
  Part all;
  for (size_t i = 0; i < paths.size(); ++i) {
    Part part = read_part(paths[i]);
    if (i == 0) {
      all = std::move(part);
      continue;
    }
    check_same_scene(all, part);
    add_new(part.scene.provenance, &all.scene.provenance, std::equal_to<>());
    add_new(part.others, &all.others, same);
    std::move(part.slabs.begin(), part.slabs.end(), std::back_inserter(all.slabs));
  }
  std::stable_sort(all.slabs.begin(), all.slabs.end(),
                   [](const StoredSlab& a, const StoredSlab& b) { return a.begin() < b.begin(); });
  check_adjacent(all.slabs);

  all.scene.provenance.push_back(provenance);
  for (const Chunk& chunk : encode_scene(all.scene)) writer.add(chunk);
  for (const Chunk& chunk : all.others) writer.add(chunk);
  std::vector<IndexEntry> index;
  for (const StoredSlab& slab : all.slabs) {
    for (const StoredChunk& chunk : slab.chunks) {
      index.push_back(chunk.entry);
      index.back().offset = writer.add_stored(chunk.type, chunk.payload);
    }
  }
  writer.close(writer.add(kIndexChunk, encode_index(index)));
}

}  // namespace strad
