// The point about which a body turns.
#pragma once

#include <span>

#include "base/pose.h"

namespace strad {

// The rest point whose path through the poses has the least sum of bends (lengths of second differences). For
// a body that turns about an axis, which may itself move evenly or in straight pieces, a point of the axis,
// nearest to `centre`. (0, 0, 0) for one that does not turn.
Vec3 pivot_of(std::span<const Pose> poses, Vec3 centre);

}  // namespace strad
