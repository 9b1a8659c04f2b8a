// Solutions read only as far as an instant needs.
#include "solution/solution_file.h"

#include <algorithm>

#include "base/error.h"
#include "scene/scene_io.h"

namespace strad {
namespace {

// Does a sorted list have a cell in [first, end)?
bool has_cell_in(const std::vector<uint32_t>& cells, uint32_t first, uint32_t end) {
  const auto cell = std::lower_bound(cells.begin(), cells.end(), first);
  return cell != cells.end() && *cell < end;
}

}  // namespace

SolutionFile::SolutionFile(const std::string& path) : reader_(std::make_unique<StreamReader>(path)) {
  if (reader_->seekable()) {
    read_file();
    return;
  }
  Stream stream = read_stream(*reader_);
  if (!stream.solution)
    throw BadInput(reader_->name() + ": found no solution, expected one from strad-solve");
  scene_ = std::move(stream.scene);
  whole_ = std::move(stream.solution);
}

void SolutionFile::read_file() {
  const uint64_t index_offset = reader_->index_offset();
  if (index_offset == 0)
    throw BadInput(reader_->name() + ": found no solution, expected one from strad-solve");
  SceneDecoder decoder;
  for (auto chunk = reader_->next(); chunk && chunk->type != kSlabChunk; chunk = reader_->next()) {
    if (!SceneDecoder::knows(chunk->type) && is_critical(chunk->type)) refuse(*reader_, *chunk);
    decoder.add(chunk->type, reader_->content(*chunk), reader_->place(*chunk));
  }
  scene_ = decoder.finish(reader_->name());

  const ChunkView index = reader_->at(index_offset);
  if (index.type != kIndexChunk) throw BadInput(reader_->place(index) + ": expected the index");
  index_ = decode_index(reader_->content(index), reader_->place(index));
  for (size_t i = 0; i < index_.size(); ++i) {
    if (index_[i].type == kSlabChunk) places_.push_back({i, i});
    places_.back().end = i + 1;
  }
}

double SolutionFile::begin() const {
  return whole_ ? slab_begin(whole_->slabs.front()) : index_[places_.front().first].begin;
}

double SolutionFile::end() const {
  return whole_ ? slab_end(whole_->slabs.back()) : index_[places_.back().first].end;
}

size_t SolutionFile::place_of(double time) const {
  size_t place = 0;
  while (place + 1 < places_.size() && time >= index_[places_[place].first].end) ++place;
  return place;
}

const Slab& SolutionFile::slab_for(double begin, double end, LightParts parts) {
  if (whole_) return whole_->slabs[strad::slab_at(*whole_, begin)];
  const size_t place = place_of(begin);
  if (loaded_place_ != place) load_mesh(place);
  load_buckets(place, begin, end, parts);
  return slab_;
}

void SolutionFile::load_mesh(size_t place) {
  const IndexEntry& entry = index_[places_[place].first];
  const ChunkView chunk = reader_->at(entry.offset);
  if (chunk.type != kSlabChunk) throw BadInput(reader_->place(chunk) + ": expected a slab");
  loaded_place_.reset();
  slab_ = decode_slab(scene_, reader_->content(chunk), reader_->place(chunk));
  if (slab_begin(slab_) != entry.begin || slab_end(slab_) != entry.end)
    throw BadInput(reader_->place(chunk) + ": the index promised another interval of time");
  loaded_place_ = place;
  loaded_entries_.clear();
}

void SolutionFile::load_buckets(size_t place, double begin, double end, LightParts parts) {
  const std::vector<uint32_t> cells = cells_needed(slab_.grid, begin, std::max(begin, end));
  std::vector<size_t> needed;
  for (size_t i = places_[place].first + 1; i < places_[place].end; ++i)
    if ((parts == LightParts::kAll || index_[i].type != kDirectChunk) &&
        has_cell_in(cells, index_[i].first_cell, index_[i].end_cell))
      needed.push_back(i);
  if (needed == loaded_entries_) return;

  std::vector<Bucket> direct, indirect;
  for (const size_t i : needed) {
    const ChunkView chunk = reader_->at(index_[i].offset);
    if (chunk.type != index_[i].type)
      throw BadInput(reader_->place(chunk) + ": the index promised another type");
    auto& buckets = chunk.type == kDirectChunk ? direct : indirect;
    buckets.push_back(decode_bucket(slab_, reader_->content(chunk), reader_->place(chunk)));
  }
  slab_.direct = assemble_field(slab_, direct, reader_->name() + ": direct light");
  slab_.indirect = assemble_field(slab_, indirect, reader_->name() + ": indirect light");
  loaded_entries_ = std::move(needed);
}

}  // namespace strad
