// POV-Ray's objects that are outlines turned about an axis or drawn along one, as flat facets.
#pragma once

#include <string>
#include <vector>

#include "import/pov/scene_values.h"

namespace strad {

// Points on a curve through, or with bezier_spline between, control points. `kind`: linear_spline,
// quadratic_spline, cubic_spline or bezier_spline. A curved piece becomes `steps` straight ones.
std::vector<Vec2> pov_curve(const std::string& kind, const std::vector<Vec2>& controls, int steps);

// The surface that `profile` (distance from the y axis, height) draws, turned about the y axis.
PovObject pov_turned(std::vector<Vec2> profile, int sides);

PovObject pov_torus(double major, double minor, int sides);

// `controls` of a surface of revolution: the first and the last only give slopes.
PovObject pov_sor(const std::vector<Vec2>& controls, int sides, bool open);

PovObject pov_superellipsoid(double east, double north, int sides);

// What lies between two outlines of as many rings, of as many points, in parallel planes.
PovObject pov_drawn(const std::vector<std::vector<Vec3>>& from, const std::vector<std::vector<Vec3>>& to,
                    bool open);

}  // namespace strad
