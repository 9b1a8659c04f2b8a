// Constructive solid geometry of POV-Ray objects: what of their surfaces bounds an intersection or a
// difference.
#pragma once

#include <vector>

#include "import/pov/cut_cache.h"
#include "import/pov/scene_values.h"

namespace strad {

// The surface and the inside of what all objects have in common. Surfaces that lie in one plane and face the
// same way count once. `cache`: of what was cut before; may be null.
PovObject pov_intersection(std::vector<PovObject> objects, PovCutCache* cache);
// The inside out.
PovObject pov_inverse(PovObject object);
// The facets of `object` as far as they are in all of `solids`, without new ones where it is cut open.
void pov_clip(PovObject* object, const std::vector<PovSolid>& solids, PovCutCache* cache);

// Cuts the facets of an endless object. Each becomes part of a square around `centre`, of a half width of
// `reach` times `size`, or times its distance from the centre if that is more.
void pov_cut_endless(PovObject* object, Vec3 centre, double size, double reach);

}  // namespace strad
