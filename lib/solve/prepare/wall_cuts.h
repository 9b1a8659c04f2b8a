// Cuts floors along the walls that stand on them.
//
// If an element of the mesh lay partly in one room and partly in the next, light of one room would be
// interpolated into the other, and links would carry it through that room. So a polygon is cut where a wall
// stands on it.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace strad {

struct CutScene {
  Scene scene;
  // [2 * polygon + side]: sides that no light reaches at any time, known from the scene before it was cut,
  // where the surfaces that enclose a space were whole. Empty where nothing was looked at.
  std::vector<bool> dark;
};

// The scene with polygons at rest cut where a wall at rest stands on them or passes through them. The polygon
// must measure at least a twentieth of the scene's diagonal. The contact must be at least a fiftieth of it
// long, or part the polygon; the wall must be a fiftieth of it high. A wall is a surface that light reaches
// on both sides, a surface with a dark room behind it, or a side of a solid thinner than a fiftieth of the
// diagonal. Polygons are not cut along furniture.
CutScene cut_under_walls(Scene scene);

}  // namespace strad
