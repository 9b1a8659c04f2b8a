// Leaves divided until light hardly varies over each.
//
// A link may reach a large patch and be right, for its receiver is far away or sees little of it. Rays of the
// gather look at each place of it, and must not find the mean of a gradient there: light would leak along a
// wall from leaf to leaf. So leaves are divided once more, without links to the parts.
#pragma once

#include "solve/links/nodes.h"
#include "solve/links/refinement.h"

namespace strad {

// `threshold`: as in RefinementOptions, of the rms difference of the quarters of a leaf, on which an error of
// its light counts as much as the refinement says. Needs a refinement that knows the light of all leaves.
void divide_leaves(const Refinement& refinement, double threshold, NodeTree* tree);

}  // namespace strad
