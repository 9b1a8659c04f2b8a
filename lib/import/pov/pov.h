// POV-Ray scene files, as scenes.
#pragma once

#include <string>

#include "base/progress.h"
#include "import/import.h"
#include "import/pov/animation.h"

namespace strad {

// `path` "-" is standard input. Directives, expressions and includes are evaluated as in POV-Ray. POV-Ray's
// space is left-handed: z is mirrored, so that pictures match, unless the file's camera is right-handed.
// Throws IoError or BadInput, which name file and line.
// An animation is evaluated at the clock of each of its frames, which begin at 0 s. What moves becomes
// bodies, and lights and cameras get keys; the mirroring is that of the first frame's camera.
Scene import_pov(const std::string& path, const ImportOptions& options, ImportReport* report,
                 const PovAnimation& animation = {}, const Progress& progress = {});

}  // namespace strad
