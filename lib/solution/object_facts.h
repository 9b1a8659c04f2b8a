// The objects of a scene, and what its materials and bodies have of the surfaces: where things are, for
// whoever writes motion files.
#pragma once

#include "scene/scene.h"
#include "solution/fact_values.h"

namespace strad {

// All at rest: areas in m^2, bounds in m.
Fact object_facts(const Scene& scene);

}  // namespace strad
