// A polygon of a scene cut into convex pieces.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace strad {

// A corner of a piece.
struct PieceCorner {
  Vec3 position;
  Vec2 uv;
};
using Piece = std::vector<PieceCorner>;

// The polygon as a single piece.
Piece uncut_piece(const Scene& scene, const Polygon& polygon);

// The parts of a convex piece below and above the plane normal . x = offset (normal of length 1); either may
// be empty. Corners within `tolerance` of the plane belong to both. Corners on the cut are moved away from
// the plane by `gap`, to their own side.
struct Halves {
  Piece below, above;
};
Halves split(const Piece& piece, Vec3 normal, double offset, double tolerance, double gap);

// The pieces as triangles and quads with the object and material of `polygon`. Adds their corners to the
// scene, rounded to float as in a stream.
std::vector<Polygon> polygons_of(const std::vector<Piece>& pieces, const Polygon& polygon, Scene* scene);

}  // namespace strad
