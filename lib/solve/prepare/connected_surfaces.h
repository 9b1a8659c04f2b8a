// Connected surfaces: the sides of polygons, joined across the edges that they share.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace strad {

// A side is 2 * polygon + (0 front, 1 back). Polygons about an edge part space into wedges, and the two sides
// that bound one wedge belong to one surface. Winding does not matter.
class ConnectedSurfaces {
 public:
  explicit ConnectedSurfaces(const Scene& scene);

  uint32_t count() const { return static_cast<uint32_t>(first_.size() - 1); }
  uint32_t surface_of(uint32_t side) const { return surface_of_side_[side]; }
  // The sides of a surface, ascending.
  const uint32_t* begin(uint32_t surface) const { return sides_.data() + first_[surface]; }
  const uint32_t* end(uint32_t surface) const { return sides_.data() + first_[surface + 1]; }
  // Has it no open edge, and does it face the space that it encloses? Then no light comes through it.
  bool encloses(uint32_t surface) const { return encloses_[surface]; }

 private:
  std::vector<uint32_t> surface_of_side_, first_{0}, sides_;
  std::vector<bool> encloses_;
};

}  // namespace strad
