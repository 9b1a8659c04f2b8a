// Walls that stand on the middle of a floor.
//
// An element of the mesh that lay partly in one room and partly in the next would carry the light of one into
// the other: under the wall, and along links as far as that room goes. So such polygons are cut.
#pragma once

#include "scene/scene.h"

namespace strad {

// The scene with all polygons at rest cut where a wall at rest stands on them or goes through them, no
// shorter than a twentieth of the scene's diagonal and no lower than a fiftieth: a surface that light reaches
// on both sides, one with a dark room behind it, or the side of a solid thinner than a fiftieth. What
// furniture stands on stays whole.
Scene cut_under_walls(Scene scene);

}  // namespace strad
