// POV-Ray scene files, as scenes.
#pragma once

#include <string>

#include "import/import.h"

namespace strad {

// `path` "-" is standard input. Reads what POV-Ray would, without rendering: directives, expressions,
// includes. POV-Ray's space is left-handed: unless the file's camera is a right-handed one, z is mirrored, so
// that pictures match. Throws IoError or BadInput, which name file and line.
Scene import_pov(const std::string& path, const ImportOptions& options, ImportReport* report);

}  // namespace strad
