// POV-Ray's .ini files: which file is rendered, and at which clocks.
#pragma once

#include <string>

#include "import/pov/animation.h"
#include "import/report.h"

namespace strad {

struct PovIni {
  std::string scene;  // path of Input_File_Name
  PovAnimation animation;
};

// Reads the settings that say what is in the pictures; those of how they are drawn and stored are left out.
// Throws IoError, or BadInput with file and line, also for settings that POV-Ray does not know, unless
// options.skip_unknown.
PovIni read_pov_ini(const std::string& path, const SkipOptions& options, ImportReport* report);

}  // namespace strad
