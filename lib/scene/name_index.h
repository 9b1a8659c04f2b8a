// Where things of given names are in a list, found at once.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/none.h"

namespace strad {

// The first of a name counts. Keeps the pointer; things are added by `put` only.
template <class Thing>
class NameIndex {
 public:
  using NameOf = const std::string& (*)(const Thing&);

  NameIndex(std::vector<Thing>* things, NameOf name_of) : things_(things), name_of_(name_of) {
    for (size_t i = 0; i < things->size(); ++i)
      at_.try_emplace(name_of((*things)[i]), static_cast<uint32_t>(i));
  }
  // kNone if there is none.
  uint32_t find(const std::string& name) const {
    const auto found = at_.find(name);
    return found == at_.end() ? kNone : found->second;
  }
  // Replaces the thing of that name, or appends it if there is none. Returns its index.
  uint32_t put(Thing thing) {
    const auto [found, is_new] = at_.try_emplace(name_of_(thing), static_cast<uint32_t>(things_->size()));
    if (is_new)
      things_->push_back(std::move(thing));
    else
      (*things_)[found->second] = std::move(thing);
    return found->second;
  }

 private:
  std::vector<Thing>* things_;
  NameOf name_of_;
  std::unordered_map<std::string, uint32_t> at_;
};

// Of things that have a `name`.
template <class Named>
NameIndex<Named> index_of_names(std::vector<Named>* things) {
  return {things, [](const Named& thing) -> const std::string& { return thing.name; }};
}

}  // namespace strad
