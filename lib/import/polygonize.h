// Polygons of any outline cut into planar convex pieces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace strad {

// Twice the area of an outline times the normal of its best plane (Newell), pointing to where its corners run
// counter-clockwise.
Vec3 doubled_area(std::span<const Vec3> outline);

// Positions in the outline, in its winding; the last is -1 for a triangle.
struct OutlinePiece {
  int corners[4] = {-1, -1, -1, -1};
};

enum class Outline {
  kWhole,       // the pieces are all of it
  kDegenerate,  // no area: no pieces
  kCrossing,    // it crosses itself: the pieces are as much as could be made
};

// The time grows with the square of the corners, to a second for this many: callers refuse more.
constexpr size_t kMaxCorners = 5000;

// Appends the pieces of `outline` to `pieces`. A planar convex quad stays one; all else becomes triangles by
// ear clipping (Meisters 1975), joined again where two make a good planar convex quad. Holes come as bridges:
// edges walked both ways. Corners on a straight edge are left out. REQUIRES: 3 to kMaxCorners finite corners,
// counter-clockwise seen from the front.
Outline polygonize(std::span<const Vec3> outline, std::vector<OutlinePiece>* pieces);

}  // namespace strad
