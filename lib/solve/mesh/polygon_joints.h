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
  // Equal for edges of the same ends. From that corner to the next.
  uint64_t edge(uint32_t polygon, int corner) const;
  // Do two polygons that meet belong to one surface, with little of a bend between them?
  bool continues(uint32_t polygon, uint32_t other) const;

 private:
  const Scene& scene_;
  std::vector<uint32_t> position_of_vertex_;  // scene vertex: index of the first at the same place
};

}  // namespace strad
