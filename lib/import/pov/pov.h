// POV-Ray scene files, as scenes.
#pragma once

#include <string>

#include "import/import.h"

namespace strad {

// `path` "-" is standard input. Directives, expressions and includes are evaluated as in POV-Ray. POV-Ray's
// space is left-handed: z is mirrored, so that pictures match, unless the file's camera is right-handed.
// Throws IoError or BadInput, which name file and line.
Scene import_pov(const std::string& path, const ImportOptions& options, ImportReport* report);

}  // namespace strad
