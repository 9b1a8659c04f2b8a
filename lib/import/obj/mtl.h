// Materials of MTL files, read as strictly as OBJ files are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "import/import.h"

namespace strad {

struct MtlMaterial {
  std::string name, file;
  uint32_t line = 0;              // of newmtl
  uint32_t reflectance_line = 0;  // of Kd; 0: none
  Rgb reflectance, emission;
  std::string texture;  // as map_Kd spells it; "": none
  uint32_t texture_line = 0;
  // Texture coordinates are multiplied by the scale (-s), and then moved by the offset (-o).
  Vec2 texture_scale{1, 1}, texture_offset{0, 0};
  bool texture_clamp = false;  // -clamp on

  struct Ignored {
    std::string what;
    uint32_t line = 0;
  };
  std::vector<Ignored> ignored;  // properties that have no effect in strad
};

// Throws IoError or BadInput, at the first fault.
std::vector<MtlMaterial> read_mtl(const std::string& path);

}  // namespace strad
