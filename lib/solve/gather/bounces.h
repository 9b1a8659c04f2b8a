// Corrects the radiance of leaves by bounces along rays.
#pragma once

#include <cstdint>

#include "solve/links/direct_of_leaves.h"

namespace strad {

// Takes out what is left of the errors of the links. Each is small, but thousands have the same sign. A
// bounce by rays is unbiased, so each one multiplies the error by the share of light that was reflected more
// than once. After two bounces the rest of the geometric series is added in one step. Returns the number of
// rays.
uint64_t correct_by_bounces(const Workspace& work, const DirectOfLeaves& direct, FunctionBlock* radiance);

}  // namespace strad
