// Lamps that lie exactly on one another: copies of a lamp, left by mistake, whose light adds up.
#pragma once

#include <string>

#include "import/report.h"
#include "scene/scene.h"

namespace strad {

// Adds a note to `report` if emitting polygons have the same corners and face the same way. `name` is the
// file's.
void tell_coincident_lamps(const Scene& scene, const std::string& name, ImportReport* report);

}  // namespace strad
