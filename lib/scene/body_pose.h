// A rigid body's own motion: the pose in its parent's frame, interpolated between keys.
#pragma once

#include "scene/scene.h"

namespace strad {

// parent_from_body at `time`; identity for a body without keys.
Pose pose_in_parent(const Body& body, double time);

// Whether two keys of `body` have the same move and rotation, so that it rests between them.
bool same_place(const Body& body, const BodyKey& a, const BodyKey& b);

}  // namespace strad
