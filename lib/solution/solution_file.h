// A stream with a solution, read one instant after another.
//
// From a file only the scene, one mesh and the buckets of the instant are read; from a pipe everything.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solution/stream_io.h"

namespace strad {

class SolutionFile {  // not thread-safe
 public:
  // Throws BadInput, also when the stream has no solution. "" or "-": standard input.
  explicit SolutionFile(const std::string& path);

  const Scene& scene() const { return scene_; }
  double begin() const;  // s: the time that the solution covers
  double end() const;

  // The slab that holds `begin` (clamped to the solution's time), with all pieces of `parts` that are needed
  // at times in [begin, end] of that slab. Other pieces may be missing. Valid until the next call. Throws
  // BadInput when a chunk is damaged.
  const Slab& slab_for(double begin, double end, LightParts parts = LightParts::kAll);
  const Slab& slab_at(double time) { return slab_for(time, time); }

 private:
  struct Place {  // a slab's entries in the index
    size_t first = 0, end = 0;
  };

  void read_file();
  size_t place_of(double time) const;
  void load_mesh(size_t place);
  void load_buckets(size_t place, double begin, double end, LightParts parts);

  std::unique_ptr<StreamReader> reader_;
  Scene scene_;
  std::optional<Solution> whole_;  // where the stream is a pipe
  std::vector<IndexEntry> index_;
  std::vector<Place> places_;
  std::optional<size_t> loaded_place_;
  std::vector<size_t> loaded_entries_;
  Slab slab_;
};

}  // namespace strad
