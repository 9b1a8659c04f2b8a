// Mirrors and glass of MTL files.
#pragma once

#include "import/obj/mtl.h"

namespace strad {

// Gives `material`, which has its reflectance, the finish that `from` asks for, and takes from the
// reflectance what is mirrored or goes through instead. Throws BadInput.
void set_finish(const MtlMaterial& from, Material* material, ImportReport* report);

}  // namespace strad
