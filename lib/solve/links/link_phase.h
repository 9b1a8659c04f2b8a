// The links of the solve, refined in three rounds with falling thresholds.
//
// They start from all pairs of root clusters. After a round light is propagated along the links, so that the
// oracle knows in the next round how bright the emitters are.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solve/links/leaves.h"
#include "solve/links/link_table.h"
#include "solve/links/refinement.h"
#include "solve/links/transport.h"

namespace strad {

struct LinkOptions {
  double threshold = 0;        // W / (sr m^2), of the last refinement (RefinementOptions)
  double smallest_radius = 0;  // m
  double mean = 0;             // W / (sr m^2), of the scene
  double dark = 1e-4;          // of the brightest tenth: what is darker counts as that
  double residual = 1e-4;      // of propagation (TransportInput)
};

// The sum that the form factors of each leaf should have, by node, for the tree as it is. Adds the rays
// traced.
using FormFactorSums = std::function<std::vector<float>(uint64_t* rays)>;

struct RefinedLinks {
  LinkTable table;
  std::vector<ClusterReflection> reflections;
  std::vector<float> form_factor_sums;
  uint64_t count = 0;  // of links
  RefinementCounts counts;
  uint64_t form_factor_rays = 0;
};

// Splits `tree`, which is the tree of `work`, where links need it.
RefinedLinks refine_links(const Workspace& work, const std::vector<Instant>& instants,
                          const LinkOptions& options, const DirectPhase& direct,
                          const FormFactorSums& form_factor_sums, NodeTree* tree);

// The input of a propagation along these links, without its `direct`. Keeps pointers to all arguments.
TransportInput input_of(const Workspace& work, const std::vector<Instant>& instants,
                        const RefinedLinks& links, double residual);

}  // namespace strad
