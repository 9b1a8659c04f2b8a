// A scene's motion as a motion file.
#pragma once

#include <string>

#include "scene/scene.h"

namespace strad {

// The motion file that gives `scene` its motion: applied to it, it changes nothing, not a bit of any number.
// Throws BadInput if a name cannot be written in one, because it has quotes or ends of lines in it.
std::string print_motion(const Scene& scene);

// The pattern of `parts` that means the object of this name alone.
std::string pattern_of(const std::string& name);

}  // namespace strad
