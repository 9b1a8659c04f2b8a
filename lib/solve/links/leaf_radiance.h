// Propagation of light along links, from leaf to leaf, at all time samples.
#pragma once

#include <functional>

#include "solve/links/leaves.h"
#include "solve/links/transport.h"

namespace strad {

// What a leaf sends out by itself at the time samples of `cells` cells from `first_cell` on, W / (sr m^2).
using LeafSource = std::function<std::vector<Rgb>(uint32_t leaf, uint32_t first_cell, uint32_t cells)>;

// Sets the radiance of all leaves to what the source sends out.
void set_to_source(const Workspace& work, const LeafSource& source, FunctionBlock* radiance);

struct Propagation {
  int iterations = 0;   // of the block of time samples that took most
  double residual = 0;  // the largest of all blocks
};

// Adds to `radiance` what the leaves reflect, once or more often, of what `source` sends out. The source may
// be negative, and may depend on `radiance` at its own time samples. `input.direct` need not be set.
Propagation add_reflected(const Workspace& work, const LeafSource& source, const TransportInput& input,
                          float at_least, FunctionBlock* radiance);

}  // namespace strad
