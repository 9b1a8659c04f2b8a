// Pictures that files of other programs name, as textures.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace strad {

struct TextureSource {
  std::string path;
  std::string name;     // as the file spells it
  bool linear = false;  // its numbers are light, not on the sRGB curve
  std::string file;     // where it is named
  uint32_t line = 0;
};

// Throws BadInput, which names where it is named.
Texture load_texture(const TextureSource& source);

}  // namespace strad
