// Unit vectors as 32 bits: the octahedron |x| + |y| + |z| = 1, unfolded to a square, 16 bits along each side.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace strad {

// Cigolle et al., "A survey of efficient representations for independent unit vectors", JCGT 3 (2), 2014. The
// angle between a vector and what comes back is at most about 0.003 degrees. Where two codes mean one vector,
// at the square's border, always the same is given: a vector that was decoded has the code it came from.
// REQUIRES: a length above 0.
uint32_t octahedral_code(Vec3 vector);
Vec3 octahedral_vector(uint32_t code);  // unit length

}  // namespace strad
