// POV-Ray's round objects, boxes, polygons and planes as flat facets. Fronts look outwards.
#pragma once

#include <vector>

#include "import/pov/scene_values.h"

namespace strad {

// Closed objects have their inside as solids.
PovObject pov_box(Vec3 corner, Vec3 opposite);

// `sides` facets around, half as many from pole to pole. Corners lie on the sphere.
PovObject pov_sphere(Vec3 centre, double radius, int sides);

// A cylinder if both radii are equal. Corners lie on the surface.
PovObject pov_cone(Vec3 base, double base_radius, Vec3 cap, double cap_radius, int sides, bool open);

PovObject pov_disc(Vec3 centre, Vec3 normal, double radius, double hole_radius, int sides);

// A flat polygon of several closed rings, as one or more facets. A point is inside if an odd number of rings
// is around it. Holes are joined to the ring around them by bridges.
PovObject pov_polygon(const std::vector<std::vector<Vec3>>& rings);

// The same of rings that do not cross, outlines counter-clockwise about the normal and holes clockwise. They
// may touch.
PovObject pov_oriented_polygon(const std::vector<std::vector<Vec3>>& rings, Vec3 normal);

// A plane as a large square, which is endless, and all behind it.
PovObject pov_plane(const PovPlane& plane);

// REQUIRES: it has an inverse.
PovTransform inverse_of(const PovTransform& of);

// Transforms an object with all its points, lights and planes.
void move_object(PovObject* object, const PovTransform& by);

}  // namespace strad
