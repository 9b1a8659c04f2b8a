// An OBJ file as it was read, and as a scene.
#pragma once

#include <string>
#include <vector>

#include "import/obj/parse.h"
#include "import/obj/scan.h"

namespace strad {

struct ObjFile {
  std::string path, name;  // the name is that of messages
  ObjScan scan;            // without its text
  ParsedObj obj;
};

// Throws IoError or BadInput.
ObjFile read_obj(const std::string& path, const ImportOptions& options, ImportReport* report);

// The scene of a file, before finish_import. `bodies`: of each of scan.objects, or none; `moving`: the bodies
// from 1 on.
Scene scene_of(ObjFile file, const std::vector<uint32_t>& bodies, std::vector<Body> moving,
               const ImportOptions& options, ImportReport* report);

}  // namespace strad
