// Results of constructive solid geometry, kept for when the same is asked again: in the next frame of an
// animation, or by a macro.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "import/pov/scene_values.h"

namespace strad {

// The facets that a cut leaves. Their surfaces are those of the facets that they come from, whose textures
// are read anew each time.
struct PovCut {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  std::vector<PovFacet> facets;                        // without surfaces
  std::vector<std::pair<uint32_t, uint32_t>> sources;  // of each: an object, a facet of it
};

class PovCutCache {
 public:
  // 128 bits: that two different ones are equal will not happen.
  using Key = std::array<uint64_t, 2>;
  // Of the geometry of objects, and of what they are cut by.
  static Key key_of(std::span<const PovObject> objects, std::span<const PovSolid> solids);

  std::shared_ptr<const PovCut> find(const Key& key);
  void keep(const Key& key, std::shared_ptr<const PovCut> cut) { now_[key] = std::move(cut); }
  // What was not asked for since the last call is forgotten.
  void next_frame();

 private:
  std::map<Key, std::shared_ptr<const PovCut>> now_, before_;
};

}  // namespace strad
