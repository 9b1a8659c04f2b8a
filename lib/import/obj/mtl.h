// Materials of MTL files, read as strictly as OBJ files are.
#pragma once

#include <cstdint>
#include <optional>
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
  // What makes mirrors and glass, where illum says so: 3 and 5 mirrors, 4, 6, 7 and 9 glass.
  int illum = 0;
  std::optional<Rgb> specular, filter;  // Ks, Tf
  std::optional<float> dissolve;        // d, or 1 - Tr
  float exponent = 0, ior = 1.5f;       // Ns, Ni
  bool is_mirror() const { return illum == 3 || illum == 5; }
  bool is_glass() const { return illum == 4 || illum == 6 || illum == 7 || illum == 9; }

  struct Ignored {
    std::string what;
    uint32_t line = 0;
  };
  std::vector<Ignored> ignored;    // properties that have no effect in strad
  std::vector<Ignored> of_finish;  // those that have none unless illum makes a mirror or glass
};

// Throws IoError or BadInput, at the first fault.
std::vector<MtlMaterial> read_mtl(const std::string& path);

}  // namespace strad
