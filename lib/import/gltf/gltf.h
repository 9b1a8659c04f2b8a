// glTF 2.0 files, as scenes.
#pragma once

#include <string>

#include "import/import.h"

namespace strad {

struct GltfOptions {
  std::string animation;         // its name; "": all, which must not move the same things
  double rate = 25;              // frames per second of an animation, which begins at 0 s
  double lumens_per_watt = 683;  // intensities in candela are divided by it
};

// Nodes that move become bodies with their parents, spotlights and point lights ride on them, cameras get
// keys. Throws IoError or BadInput, which name what cannot be taken.
Scene import_gltf(const std::string& path, const ImportOptions& options, const GltfOptions& gltf,
                  ImportReport* report);

}  // namespace strad
