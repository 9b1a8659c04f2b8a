// Which way a receiver's light comes from, as rays have found it, to send more rays there.
//
// Rays by the cosine alone meet a gap of a door or a small bright patch rarely, and what they bring is noise.
// Leaves near each other look the same way. So the rays of many leaves, counted by direction, tell where the
// rays of one should go (path guiding: Jensen 1995). Some go everywhere, and each counts by the inverse of
// its density, so the mean stays what it is.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/rng.h"
#include "solve/links/nodes.h"

namespace strad {

// Directions as points of the unit square that is mapped onto the hemisphere by the cosine (see rays_of).
constexpr int kDirectionRows = 8;  // of equal bins, and as many columns
constexpr size_t kDirectionBins = size_t{kDirectionRows} * kDirectionRows;
size_t direction_bin(Point2 xi);

// What rays have brought, by direction.
struct DirectionCounts {
  std::array<float, kDirectionBins> rays{}, sums{}, squares{};  // sums: of what rays brought

  // Means over time of what a ray brought and of its square.
  void add(Point2 xi, double brought, double square);
  DirectionCounts& operator+=(const DirectionCounts& other);
};

// A density of directions, constant in each bin; its mean is 1.
class DirectionDensity {
 public:
  DirectionDensity();  // 1 everywhere
  // At least half everywhere, more where few rays were counted; the rest as what rays bring asks for (the
  // root mean square in each bin).
  explicit DirectionDensity(const DirectionCounts& counts);

  // Maps points of uniform density to points of this one, keeping strata. `*density`: there.
  Point2 warp(Point2 xi, float* density) const;
  // The standard deviation of what a ray of this density brings by its weight, relative to the mean; 1 where
  // nothing was counted.
  float deviation() const { return deviation_; }

 private:
  using Row = std::array<float, kDirectionRows>;
  Row row_density_;                              // mean of each row
  std::array<Row, kDirectionRows> bin_density_;  // [row][column]
  float deviation_ = 1;
};

class DirectionGuide {
 public:
  DirectionGuide() : densities_(1) {}  // knows nothing
  // `of_leaves`: by node, of leaf patches.
  DirectionGuide(const NodeTree& tree, std::vector<DirectionCounts> of_leaves);

  // Where the rays of a leaf should go, by its node: as the smallest patch around it says that has had enough
  // of them, or the largest. kNone: everywhere.
  const DirectionDensity& density(uint32_t node) const;

 private:
  std::vector<DirectionDensity> densities_;  // the first is 1 everywhere
  std::vector<uint32_t> density_of_;         // [node]
};

}  // namespace strad
