// Reflectances without textures, for light transport.
#pragma once

#include "scene/scene.h"

namespace strad {

// The scene without colours of textures, but with their holes. The reflectance of a polygon is the mean over
// the part of the texture that it shows; of an emitting polygon, the mean over the texture. Materials keep
// their numbers. New materials for single polygons follow them, one for each reflectance that differs
// visibly.
Scene with_mean_reflectances(Scene scene);

}  // namespace strad
