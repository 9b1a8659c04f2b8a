// Materials of MTL files, read as strictly as OBJ files are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "import/import.h"

namespace strad {

// A statement that names a picture: map_Kd or map_d.
struct MtlPicture {
  std::string file;  // as the statement spells it; "": none
  uint32_t line = 0;
  // Texture coordinates are multiplied by the scale (-s), and then moved by the offset (-o).
  Vec2 scale{1, 1}, offset{0, 0};
  bool clamp = false;  // -clamp on
};

struct MtlMaterial {
  std::string name, file;
  uint32_t line = 0;              // of newmtl
  uint32_t reflectance_line = 0;  // of Kd; 0: none
  Rgb reflectance, emission;
  MtlPicture texture, opacity;

  struct Ignored {
    std::string what;
    uint32_t line = 0;
  };
  std::vector<Ignored> ignored;  // properties that have no effect in strad
};

// Throws IoError or BadInput, at the first fault.
std::vector<MtlMaterial> read_mtl(const std::string& path);

}  // namespace strad
