// OBJ files with their MTL files and textures, as scenes.
#pragma once

#include <string>

#include "import/import.h"

namespace strad {

// `path` "-" is standard input; MTL files are then looked for in the working directory. Each combination of
// an object name and a group name becomes one object of the scene. Materials keep their names; those that no
// face uses are dropped. Throws IoError or BadInput, which name file and line.
Scene import_obj(const std::string& path, const ImportOptions& options, ImportReport* report);

}  // namespace strad
