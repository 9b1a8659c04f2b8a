// The radiance of the leaves of the hierarchy at all dates: from links, then settled by rays.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "light/tracer.h"
#include "solve/direct_phase.h"
#include "solve/nodes.h"
#include "solve/packed_function.h"
#include "solve/swept.h"
#include "solve/transport.h"
#include "time/time_grid.h"

namespace strad {

// A function of time of each node, at every node of the grid; empty for nodes that are no leaves.
using LeafFunctions = std::vector<std::vector<Rgb>>;
using PackedLeafFunctions = std::vector<PackedFunction>;

// What the solve works on. All outlive the functions below.
struct Workspace {
  const TimeGrid& grid;
  const NodeTree& tree;
  const Tracer& tracer;
  const SweptBounds& swept;
};

// What each leaf sees, at the middle of the animation.
struct Views {
  std::vector<float> row_sums, column_sums;  // see balance()
};
Views views_of(const Workspace& work, uint64_t* rays);

// Mean direct irradiance of the leaves, W / m^2.
PackedLeafFunctions direct_of_leaves(const Workspace& work, const DirectPhase& phase);

// Radiance reflected by the leaves, W / (sr m^2), along links; `input.direct` by the dates of the grid.
TransportResult propagate_all(const TransportInput& input, LeafFunctions* radiance);

// Mean radiance of the leaves that are lit, over area and time.
double mean_radiance(const NodeTree& tree, const LeafFunctions& radiance);

// Takes out what is left of the links' errors, which are sums of small ones of one sign: bounces by rays,
// which are unbiased, shrink it by one factor each; the factor is seen from two bounces and the rest of the
// geometric series added at once (Aitken's extrapolation). Returns the rays traced.
uint64_t settle_by_rays(const Workspace& work, const PackedLeafFunctions& direct, LeafFunctions* radiance);

}  // namespace strad
