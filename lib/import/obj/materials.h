// The materials that an OBJ file uses, read from its MTL files.
#pragma once

#include <string>
#include <vector>

#include "import/obj/scan.h"

namespace strad {

// Fills scene->materials, one for each of scan.materials in that order, and their textures. `path` is the OBJ
// file's. Throws IoError or BadInput. Missing files and materials are errors too, unless
// options.skip_missing.
void load_obj_materials(const ObjScan& scan, const std::string& path, const ImportOptions& options,
                        ImportReport* report, Scene* scene);

}  // namespace strad
