// Where an instant lies among the keys of anything that is keyed over time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace strad {

// Between keys[key] and keys[key + 1], at fraction `u` of the way; u = 0 where the value is held.
struct KeyPlace {
  size_t key = 0;
  double u = 0;     // [0, 1)
  double span = 0;  // s from keys[key] to keys[key + 1]; 0 where the value is held
};

// The last of two keys at one time wins, so that the value after a step holds at that very time.
// REQUIRES: `keys` is not empty and ordered by time.
template <class Key>
KeyPlace place_among(const std::vector<Key>& keys, double time) {
  const auto later =
      std::upper_bound(keys.begin(), keys.end(), time, [](double t, const Key& key) { return t < key.time; });
  if (later == keys.begin()) return {0, 0, 0};
  const size_t key = static_cast<size_t>(later - keys.begin()) - 1;
  if (later == keys.end()) return {key, 0, 0};
  const double span = later->time - keys[key].time;
  return {key, (time - keys[key].time) / span, span};
}

}  // namespace strad
