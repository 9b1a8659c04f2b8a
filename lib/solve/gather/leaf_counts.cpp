#include "solve/gather/leaf_counts.h"

#include "base/rng.h"

namespace strad {

// Where the leaf is in the table, or would be: linear probing.
size_t LeafCounts::place_of(uint32_t leaf) const {
  const size_t mask = table_.size() - 1;
  size_t place = mix64(leaf) & mask;
  while (table_[place] != kFree && leaves_[table_[place]] != leaf) place = (place + 1) & mask;
  return place;
}

size_t LeafCounts::row_of(uint32_t leaf) {
  const size_t place = place_of(leaf);
  if (table_[place] != kFree) return table_[place];
  const auto row = static_cast<uint32_t>(leaves_.size());
  table_[place] = row;
  leaves_.push_back(leaf);
  counts_.resize(counts_.size() + looks_);
  if (2 * leaves_.size() > table_.size()) {
    table_.assign(2 * table_.size(), kFree);
    for (uint32_t r = 0; r < leaves_.size(); ++r) table_[place_of(leaves_[r])] = r;
  }
  return row;
}

}  // namespace strad
