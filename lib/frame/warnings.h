// What is probably a mistake in a scene and its motion.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace strad {

// One line for each: no light, keys after the end, a spotlight or a camera inside a solid, a camera that sees
// nothing, bodies that go through each other. Only some instants are looked at, the first and the last among
// them.
std::vector<std::string> warnings_of(const Scene& scene);

}  // namespace strad
