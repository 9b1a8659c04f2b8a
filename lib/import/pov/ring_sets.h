// Sets of points of a plane, bounded by rings: what two of them have in common, and what one has alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace strad {

// Coordinates on a grid, whole numbers within +-2^60.
using RingPoint = std::array<int64_t, 2>;
using Ring = std::vector<RingPoint>;
// A point is inside if the rings wind around it more often counter-clockwise than clockwise, or as often but
// not none: if the winding number is not 0.
using RingSet = std::vector<Ring>;

enum class RingOperation { kBoth, kEither, kFirstAlone };

// Outer rings come back counter-clockwise, holes clockwise; none crosses itself.
RingSet combined(RingOperation operation, const RingSet& a, const RingSet& b);

// Twice the area, in units of the grid.
double doubled_area(const RingSet& rings);

}  // namespace strad
