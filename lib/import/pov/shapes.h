// POV-Ray's round and boxy objects as flat facets, outside outwards.
#pragma once

#include <vector>

#include "import/pov/scene_values.h"

namespace strad {

PovObject pov_box(Vec3 corner, Vec3 opposite);

// `sides` facets around, half as many from pole to pole; its corners lie on the sphere.
PovObject pov_sphere(Vec3 centre, double radius, int sides);

// A cylinder where both radii are equal. Its corners lie on it.
PovObject pov_cone(Vec3 base, double base_radius, Vec3 cap, double cap_radius, int sides, bool open);

PovObject pov_disc(Vec3 centre, Vec3 normal, double radius, double hole_radius, int sides);

// A flat outline of several closed rings, inside where it is within an odd number of them, as one or more
// facets. Rings that lie in others are joined to them by bridges.
PovObject pov_polygon(const std::vector<std::vector<Vec3>>& rings);

// What of the plane lies within `bounds`, a convex object such as a box.
PovObject pov_bounded_plane(const PovPlane& plane, const PovObject& bounds);

// Moves an object and all it holds.
void move_object(PovObject* object, const PovTransform& by);

}  // namespace strad
