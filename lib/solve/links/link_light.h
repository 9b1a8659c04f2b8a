// The light that links carry: refinement, balance and propagation, from the first pair of clusters to the
// radiance of every leaf at every date.
#pragma once

#include "solve/gather/leaf_light.h"
#include "solve/solve.h"

namespace strad {

struct LinkLightOptions {
  double threshold = 0;        // W / (sr m^2), of the last refinement (RefinementOptions)
  double smallest_radius = 0;  // m
  double residual = 1e-4;
};

struct LinkLight {
  LightFunctions radiance;  // W / (sr m^2), reflected
  DirectOfLights direct;
};

// Splits `tree` where links want it. Ends the direct phase: puts what is to be kept of it to `kept`, which
// the result goes on reading. Adds to `stats`.
LinkLight light_along_links(const Workspace& work, const std::vector<Instant>& instants,
                            const LinkLightOptions& options, NodeTree* tree, DirectPhase* direct, Field* kept,
                            SolveStats* stats);

}  // namespace strad
