// What light transport sees of textures.
#pragma once

#include "scene/scene.h"

namespace strad {

// The scene without textures: each polygon reflects the mean of the part of the texture that it shows, an
// emitting one that of the whole. Materials keep their numbers; those of single polygons follow, one for each
// colour that can be told apart.
Scene with_mean_reflectances(Scene scene);

}  // namespace strad
