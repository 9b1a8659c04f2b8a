// OBJ files with their MTL files and textures, as scenes.
#pragma once

#include <string>

#include "import/import.h"

namespace strad {

// `path` "-" is standard input; MTL files are then looked for in the working directory. Groups and objects
// become objects of one name each; materials in use keep their names. Throws IoError or BadInput, which name
// file and line.
Scene import_obj(const std::string& path, const ImportOptions& options, ImportReport* report);

}  // namespace strad
