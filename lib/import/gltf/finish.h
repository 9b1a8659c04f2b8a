// Finishes of glTF's materials: metals are mirrors, and what transmits is glass.
#pragma once

#include <string>

#include "import/gltf/model.h"
#include "import/import.h"
#include "scene/scene.h"

namespace strad {

// Sets the reflectance and the finish of `material`, of which the emission is set. `mean`: of its texture,
// which the finish takes in its place. `file`: for notes. Throws BadInput.
void set_finish(const GltfMaterial& from, Rgb mean, Material* material, const std::string& file,
                ImportReport* report);

}  // namespace strad
