// Removes noise of rays from functions at the vertices of the mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solution/mesh.h"
#include "time/scaled_function.h"

namespace strad {

// Two neighbours of a vertex, on opposite sides at equal distance. Where light varies linearly, its value at
// the vertex is the mean of their values.
struct NeighbourPair {
  uint32_t a, b;
};

// By vertex: the pairs of its neighbours along edges of `elements` that are no longer than `farthest` (m).
std::vector<std::vector<NeighbourPair>> opposite_neighbours(const Mesh& mesh,
                                                            const std::vector<uint32_t>& elements,
                                                            double farthest);

// Moves the function of each vertex half way towards the mean of its pairs, kSweeps times. A vertex that
// differs from a pair by more than is usual moves less or not at all, for the difference is light
// (share_of_noise). `function(v)`: the function of vertex v, changed in place. The result does not depend on
// the number of threads.
void smooth(const std::vector<std::vector<NeighbourPair>>& pairs,
            const std::function<CoarseFunction&(uint32_t vertex)>& function);

}  // namespace strad
