// What a scene says that can hardly be meant, to be told to whoever made it.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace strad {

// Whether anything ever emits: a polygon, or a spotlight.
bool is_lit(const Scene& scene);

// Materials whose glow changes nothing, for they emit nothing.
std::vector<std::string> dark_glows(const Scene& scene);

}  // namespace strad
