// Poses at the frames of an animation as a body with few keys.
#pragma once

#include <span>
#include <vector>

#include "import/poses/follow.h"
#include "scene/scene.h"

namespace strad {

// What moves, and how exactly the keys must tell it.
struct Moved {
  Box bounds;            // at rest
  double tolerance = 0;  // m; no point within the bounds may be further from its place at any frame
};

// Pivot, axis, easing and keys of a body on the world that is at `poses`, scene from rest, at `times`: as few
// keys as keep to the tolerance. The pivot is the point whose path has the fewest bends, so that turns about
// a fixed or an evenly moving axis need no keys between their ends; the easing is the one that needs fewer
// keys. A motion that is already under way at the first or the last frame has, with smooth easing, a key
// before or after it. REQUIRES: as many times, ascending, as poses; at least one.
Body body_with_keys(std::span<const Pose> poses, std::span<const double> times, const Moved& moved);

// The same for what a follower has found of the pieces of a group. Each is told to within kKeyTolerance of
// its own size, or what the precision of the file leaves open. REQUIRES: not the first group, which never
// moved.
Body body_of_group(const PoseFollower& follower, size_t group, std::span<const double> times);

}  // namespace strad
