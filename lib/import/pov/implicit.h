// Surfaces where a function of space is 0, as flat facets.
#pragma once

#include <optional>

#include "import/pov/scene_values.h"

namespace strad {

// The part of the surface inside `box`, closed where it leaves the box, from a grid of about `cells` cells
// along the box's longest side.
PovObject pov_implicit(const PovField& field, const Box& box, int cells);

// A box around a surface that is nowhere farther than `reach` from the origin; nothing if it goes on beyond,
// or if there is none.
std::optional<Box> box_of_field(const PovField& field, double reach);

// Makes facets of what is pending in an object, inside `box`, or where it is if there is no box. A surface
// that has no end then becomes a problem of the object.
void pov_make_pending(PovObject* object, const std::optional<Box>& box, int cells);

}  // namespace strad
