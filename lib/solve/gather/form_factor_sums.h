// The sums that the form factors of each leaf should have, by rays.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/links/leaves.h"

namespace strad {

// By node, for leaves: the share of the unblocked view of a leaf in which its rays meet a surface that light
// reaches, at the middle of the animation. In a closed scene it is 1. It is what the form factors of the leaf
// sum to, and so what its links are scaled by (TransportInput).
std::vector<float> form_factor_sums_by_rays(const Workspace& work, uint64_t* rays);

}  // namespace strad
