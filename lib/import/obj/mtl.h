// Materials of MTL files, behind a guard as strict as that of OBJ files.
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

  struct Ignored {
    std::string what;
    uint32_t line = 0;
  };
  std::vector<Ignored> ignored;  // what the file says of it that strad does not show
};

// Throws IoError or BadInput, at the first fault.
std::vector<MtlMaterial> read_mtl(const std::string& path);

}  // namespace strad
