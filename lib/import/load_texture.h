// Pictures named in files of other programs, as textures.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace strad {

struct TextureSource {
  std::string path;
  std::string name;     // as the file spells it
  bool linear = false;  // its numbers are linear, not on the sRGB curve
  std::string file;     // the file that names the picture, and the line, for errors
  uint32_t line = 0;
};

// Its holes are those of the picture's alpha, if it has any. Throws BadInput at source.file and source.line.
Texture load_texture(const TextureSource& source);

// A picture that says how opaque a surface is: by its alpha, or if it has none by its first channel.
Opacity load_opacity(const TextureSource& source);

}  // namespace strad
