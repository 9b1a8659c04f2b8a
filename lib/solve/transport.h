// Propagation of light along links: gather, push and pull, a block of dates at a time.
//
// Light transport couples no two dates, so a block of dates is iterated to the end on its own: its working
// set stays in cache, blocks are shared among threads, and memory does not grow with the length of the
// animation.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/rgb.h"
#include "solve/kernel.h"
#include "solve/nodes.h"
#include "time/time_grid.h"

namespace strad {

// Adds kernel(t) * L_emitter(t) to the irradiance of the receiver on its interval.
struct Link {
  uint32_t receiver = 0, emitter = 0;
  Interval interval;
  KernelEstimate estimate;
};

// The links in the order in which a gather wants them.
struct LinkTable {
  struct Still {
    uint32_t emitter;
    float kernel;
  };
  struct Dynamic {
    uint32_t emitter;
    Interval interval;
    float kernel[kMaxOrder];
  };
  std::vector<uint32_t> first_still{0}, first_dynamic{0};  // nodes + 1
  std::vector<Still> still;
  std::vector<Dynamic> dynamic;
};
LinkTable make_link_table(const TimeGrid& grid, uint32_t node_count, const std::vector<Link>& links);

// Energy balance: corrections that make the exchange of every leaf add up to its openness both ways.
//
// In a closed scene the form factors of a patch add up to 1, as a receiver and as an emitter. The error of
// each link is below a threshold but thousands of them err with one sign, so rows and columns are scaled in
// turn (Sinkhorn & Knopp 1967) until both sums are right in the mean over time.
struct Balance {
  std::vector<float> receiver;  // [node], leaves only: scales gathered irradiance
  std::vector<float> emitter;   // [node], leaves only: scales radiance as seen by links
};
// `row_sums`, `column_sums`: [node], leaves only: what they should be, in units of pi.
Balance balance(const TimeGrid& grid, const NodeTree& tree, const std::vector<Link>& links,
                const std::vector<float>& row_sums, const std::vector<float>& column_sums);

struct TransportInput {
  const TimeGrid* grid = nullptr;
  const NodeTree* tree = nullptr;
  const LinkTable* links = nullptr;
  // Direct irradiance of a leaf at a column, W / m^2.
  std::function<Rgb(size_t node, size_t column)> direct;
  const Balance* balance = nullptr;
  double residual = 1e-3;  // largest mean change of radiance, relative
  int max_iterations = 100;
};

struct TransportResult {
  int iterations = 0;
  double residual = 0;
};

// Solves for the radiance reflected by every node at `dates` (nodes of the grid, ascending):
// radiance[node * dates.size() + i], W / (sr m^2), without emission.
// `first_column`: of the direct light, for the first date; the others follow.
TransportResult propagate(const TransportInput& input, const std::vector<uint32_t>& dates,
                          uint32_t first_column, std::vector<Rgb>* radiance);

}  // namespace strad
