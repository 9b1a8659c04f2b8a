// Values of a glTF animation's channel over time.
#pragma once

#include "import/gltf/model.h"

namespace strad {

// On which side of an instant: a step has another value before it than from it on.
enum class Side { kBefore, kFrom };

// As section 3.11 and appendix C of glTF 2.0 say: held before the first and after the last key. Times in s.
Vec3 vector_at(const GltfChannel& channel, double time, Side side);
// Linear interpolation of rotations takes the shorter way (slerp).
Quat rotation_at(const GltfChannel& channel, double time, Side side);

// Whether all values are the same to rounding.
bool is_constant(const GltfChannel& channel);

}  // namespace strad
