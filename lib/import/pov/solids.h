// What is inside a POV-Ray object, and what of a plane lies in it.
#pragma once

#include <vector>

#include "import/pov/ring_sets.h"
#include "import/pov/scene_values.h"

namespace strad {

// The solid that all facets of a closed object bound.
PovSolid solid_of_facets(const PovObject& object);
// Everything behind a plane.
PovSolid solid_behind(const PovPlane& plane);
PovSolid solid_of(PovSolid::Kind kind, std::vector<PovSolid> parts);

void move_solid(PovSolid* solid, const PovTransform& by);
PovPlane moved_plane(const PovPlane& plane, const PovTransform& by);
// The same solid, whose hulls are where they are placed. All that follows wants it so.
PovSolid settled(const PovSolid& solid);
// The box of its hulls.
Box box_of_hulls(const PovSolid& solid);
// REQUIRES: the solid is settled.
bool is_inside(const PovSolid& solid, Vec3 point);

// A plane with a grid on it. Its points are origin + step (i tangent + j bitangent).
struct PovSheet {
  Vec3 origin;
  Frame frame;
  double step = 1;
  double touch = 0;  // what is nearer than this counts as on the plane

  RingPoint grid(Vec3 p) const;
  Vec3 point(RingPoint at) const;
};
// How many steps of the grid a sheet's largest distance from its origin takes: room is left for what is
// beyond.
constexpr double kSheetSteps = 144115188075855872.0;  // 2^57

// The side of a sheet that counts where a solid's own surface lies on it: that to which the sheet's normal
// points, or the other.
enum class PovSide { kAbove, kBelow };

// The part of `region` that lies in the solid. `around`: a box that holds the region.
// REQUIRES: the solid is settled, and the sheet has room for its hulls.
RingSet part_inside(const RingSet& region, const PovSolid& solid, const PovSheet& sheet, PovSide side,
                    const Box& around);

}  // namespace strad
