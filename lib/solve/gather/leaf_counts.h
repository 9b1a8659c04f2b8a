// How many rays of a receiver see each leaf, at each of several looks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace strad {

// Each ray counts by its weight (see Seen).
class LeafCounts {
 public:
  explicit LeafCounts(size_t looks) : looks_(looks), table_(256, kFree) {}

  void add(uint32_t leaf, size_t look, float weight) { counts_[row_of(leaf) * looks_ + look] += weight; }

  // In the order in which they were seen first.
  const std::vector<uint32_t>& leaves() const { return leaves_; }
  // One number for each look.
  const float* counts(size_t row) const { return counts_.data() + row * looks_; }

 private:
  static constexpr uint32_t kFree = 0xffffffffu;

  size_t row_of(uint32_t leaf);
  size_t place_of(uint32_t leaf) const;

  size_t looks_;
  std::vector<uint32_t> leaves_;
  std::vector<float> counts_;
  std::vector<uint32_t> table_;  // rows, by hash of their leaf; at most half full
};

}  // namespace strad
