// Where polygons of a scene meet: by the positions of their corners, whatever vertices they name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace strad {

// Equal for corners of neighbours in one plane, on the same side and body.
struct CornerKey {
  uint32_t position, body, side;
  int normal[3];
  bool operator==(const CornerKey&) const = default;
};
struct CornerHash {
  size_t operator()(const CornerKey& key) const;
};

class PolygonJoints {
 public:
  explicit PolygonJoints(const Scene& scene);  // keeps a reference

  CornerKey corner(uint32_t polygon, uint32_t side, int corner) const;
  // A key of the edge from that corner to the next; equal for edges with the same ends.
  uint64_t edge(uint32_t polygon, int corner) const;
  // Are two polygons that meet parts of one surface: of one body, at a small angle?
  bool continues(uint32_t polygon, uint32_t other) const;

 private:
  const Scene& scene_;
  std::vector<uint32_t> position_of_vertex_;  // by vertex of the scene: the first vertex at the same place
};

}  // namespace strad
