// Takes the noise of rays out of functions on the mesh, as far as it is no more than noise.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solution/mesh.h"
#include "time/scaled_function.h"

namespace strad {

// Two neighbours of a vertex, as far from it and opposite: light that varies linearly is at the vertex the
// mean of what it is there.
struct NeighbourPair {
  uint32_t a, b;
};

// By vertex: its pairs along the edges of `elements`, no farther than `farthest` (m).
std::vector<std::vector<NeighbourPair>> opposite_neighbours(const Mesh& mesh,
                                                            const std::vector<uint32_t>& elements,
                                                            double farthest);

// Moves each function with pairs half way towards their mean, kSweeps times, where it differs from that by no
// more than noise would over all time samples. `function(v)`: to be changed in place. The result does not
// depend on threads.
void smooth(const std::vector<std::vector<NeighbourPair>>& pairs,
            const std::function<CoarseFunction&(uint32_t vertex)>& function);

}  // namespace strad
