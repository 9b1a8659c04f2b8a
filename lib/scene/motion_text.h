// The motion language of strad-motion(5), compiled onto a scene.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace strad {

// Later statements win: `time`, `rate` and blocks of a name that the scene already has replace what it has;
// all else of the scene's motion stays. `file` is the name used in messages. Throws BadInput, "file:line:
// found ..., expected ..."; the scene must then not be used any more.
void apply_motion(std::string_view text, const std::string& file, Scene& scene);

// A camera that does not move, from the words of a camera's key: "from 0 1 5 to 0 1 0 fov 40". `name` is its
// name, and the one used in messages. Throws BadInput.
Camera parse_camera(const std::string& name, const std::string& text);

}  // namespace strad
