// As few keys as say the same as one key a frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace strad {

// Indices of the keys that stay: each as far from the one before as it may be. straight(a, b): whether all
// between the keys a and b follow from these two; asked only of a < b.
template <class Straight>
std::vector<size_t> few_indices(size_t count, Straight straight) {
  std::vector<size_t> kept{0};
  const size_t end = count - 1;
  for (size_t at = 0; at < end;) {
    size_t good = at + 1, step = 1;
    while (good < end && straight(at, std::min(good + step, end))) {
      good = std::min(good + step, end);
      step *= 2;
    }
    for (; step > 0; step /= 2)
      while (good + step <= end && straight(at, good + step)) good += step;
    at = good;
    kept.push_back(at);
  }
  return kept;
}

// The keys that stay. follows(a, b, key): whether `key`, between keys a and b, follows from them; same(a, b):
// whether they differ in time only. Of keys that are all the same one is left.
template <class Key, class Follows, class Same>
std::vector<Key> few_keys(const std::vector<Key>& all, Follows follows, Same same) {
  std::vector<Key> keys;
  for (const size_t i : few_indices(all.size(), [&](size_t a, size_t b) {
         for (size_t k = a + 1; k < b; ++k)
           if (!follows(all[a], all[b], all[k])) return false;
         return true;
       }))
    keys.push_back(all[i]);
  while (keys.size() > 1 && same(keys[keys.size() - 1], keys[keys.size() - 2])) keys.pop_back();
  return keys;
}

}  // namespace strad
