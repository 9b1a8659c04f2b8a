// OBJ files with their MTL files and textures, as scenes.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "import/import.h"

namespace strad {

// `path` "-" is standard input; MTL files are then looked for in the working directory. Each combination of
// an object name and a group name becomes one object of the scene. Materials keep their names; those that no
// face uses are dropped. Throws IoError or BadInput, which name file and line.
Scene import_obj(const std::string& path, const ImportOptions& options, ImportReport* report);

// Numbered files of one animation, such as walk.%04d.obj, one a frame.
struct ObjFrames {
  std::string pattern;
  std::vector<int> numbers;  // of the files, at least one; the first is the scene at rest, at 0 s
  double rate = 25;          // files per second
};

// All files have the same objects, faces and materials as the first, which alone is looked at for materials.
// Objects that move become bodies; those that move alike are one. Throws IoError or BadInput, also for an
// object that does not move rigidly, unless options.skip_unknown: then it stays as in the first file, which
// is reported.
Scene import_obj_frames(const ObjFrames& frames, const ImportOptions& options, ImportReport* report,
                        const Progress& progress = {});

}  // namespace strad
