// Polygons of any outline cut into planar convex pieces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace strad {

// The normal of an outline's best plane (Newell), times twice its area. Corners are counter-clockwise seen
// from where it points.
Vec3 doubled_area(std::span<const Vec3> outline);

// A piece as positions of its corners in the outline, wound as the outline is. The last is -1 for a triangle.
struct OutlinePiece {
  int corners[4] = {-1, -1, -1, -1};
};

enum class Outline {
  kWhole,       // the pieces are all of it
  kDegenerate,  // it has no area: no pieces
  kCrossing,    // it crosses itself: the pieces are only a part of it
};

// The time grows with the square of the number of corners; it is about a second for this many. Callers refuse
// more.
constexpr size_t kMaxCorners = 5000;

// Appends the pieces of `outline` to `pieces`. A planar convex quad stays one. Other outlines become
// triangles by ear clipping (Meisters 1975); two of them are joined if they make a good planar convex quad.
// An outline with holes has bridges to them: edges that are walked both ways. Corners on a straight edge are
// left out. REQUIRES: 3 to kMaxCorners finite corners, counter-clockwise seen from the front.
Outline polygonize(std::span<const Vec3> outline, std::vector<OutlinePiece>* pieces);

}  // namespace strad
