// Propagation of light along links: gather, push and pull, a block of time samples at a time.
//
// Light at one time sample does not depend on light at another. So each block of time samples is iterated on
// its own until it converges: its data fit in the cache, threads share the blocks, and memory does not grow
// with the length of the animation.
//
// A patch has one function of time. A cluster has one for each lobe (lobes.h): the mean radiance, or
// irradiance, of its surfaces that face that way. So the cost of a link does not depend on the number of
// surfaces at its ends.
//
// Gather, immediate push and delayed pull are those of the paper (Damez, Holzschuch & Sillion 2001).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/rgb.h"
#include "light/direct.h"
#include "solve/links/link_table.h"
#include "solve/links/nodes.h"
#include "time/time_grid.h"

namespace strad {

// How a leaf cluster turns irradiance from each lobe into radiance towards each.
struct ClusterReflection {
  Rgb radiance[kLobes][kLobes];  // [towards][from], of unit irradiance
};
// By cluster; empty ones for clusters that are no leaves.
std::vector<ClusterReflection> reflections_of(const NodeTree& tree);

struct TransportInput {
  const TimeGrid* grid = nullptr;
  const NodeTree* tree = nullptr;
  const LinkTable* links = nullptr;
  const std::vector<Instant>* instants = nullptr;  // of the time samples
  // Radiance that a leaf reflects of direct light, by slot (Node::slot), W / (sr m^2). A column is the place
  // of a time sample in the caller's table of direct light, which may hold only some time samples.
  std::function<Rgb(size_t slot, size_t column)> direct;
  const std::vector<ClusterReflection>* reflections = nullptr;
  // The sum that the form factors (kernel / pi) of each leaf should have, by node; null: no scaling. See
  // balance().
  const std::vector<float>* form_factor_sums = nullptr;
  double residual = 1e-3;  // largest mean change of radiance, relative
  int max_iterations = 100;
};

// By slot and time sample, [slot * time_samples.size() + i]. `irradiance`: what the links of a leaf and of
// all its ancestors bring to it, scaled by balance(); of leaves only.
struct NodeLight {
  std::vector<Rgb> radiance;    // W / (sr m^2), reflected, without emission
  std::vector<Rgb> irradiance;  // W / m^2, indirect
  int iterations = 0;
  double residual = 0;
};

// Solves for the light at `time_samples` (ascending) by Jacobi iteration. `first_column`: the column of
// `input.direct` that holds the first time sample; the others follow.
NodeLight propagate(const TransportInput& input, const std::vector<uint32_t>& time_samples,
                    uint32_t first_column);

// Energy balance: what propagate() scales gathered irradiance by, so that the exchange of every leaf adds up
// to its form factor sums at every time sample: [slot * time_samples.size() + i], leaves only.
//
// In a closed scene the form factors of a patch add up to 1. The error of each link is below a threshold, but
// thousands of them may err with the same sign. One gather of unit radiance tells their sum, and so the
// scale. No lobe gets more irradiance of it than pi, that of a full view, so that the iteration converges,
// however coarse the links are.
std::vector<float> balance(const TransportInput& input, const std::vector<uint32_t>& time_samples);

}  // namespace strad
