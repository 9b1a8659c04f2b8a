// The radiance that the leaves reflect at all time samples, by propagation along links.
#pragma once

#include "solve/links/direct_of_leaves.h"
#include "solve/links/transport.h"

namespace strad {

struct LeafRadiance {
  FunctionBlock radiance;  // W / (sr m^2), reflected
  int iterations = 0;      // of the block of time samples with the most
  double residual = 0;     // of the block with the largest
};

// Propagates light along links at all time samples, block after block. `input.direct` need not be set.
LeafRadiance propagate_to_leaves(const Workspace& work, const DirectOfLeaves& direct,
                                 const TransportInput& input);

}  // namespace strad
