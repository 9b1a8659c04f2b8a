// The materials that an OBJ file uses, read from its MTL files.
#pragma once

#include <string>
#include <vector>

#include "import/obj/scan.h"

namespace strad {

// Where a material's texture lies: coordinates are multiplied by the scale, and then moved by the offset.
struct TexturePlacement {
  Vec2 scale{1, 1}, offset{0, 0};
  bool is_usual() const { return scale == Vec2{1, 1} && offset == Vec2{0, 0}; }
};

// Fills scene->materials, one for each of scan.materials in that order, and their textures. `path` is the OBJ
// file's. Throws IoError or BadInput. Missing files and materials are errors too, unless
// options.skip_missing. Returns where the texture of each material lies.
std::vector<TexturePlacement> load_obj_materials(const ObjScan& scan, const std::string& path,
                                                 const ImportOptions& options, ImportReport* report,
                                                 Scene* scene);

}  // namespace strad
