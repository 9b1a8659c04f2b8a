// The leaves of the hierarchy, and sums over them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "light/tracer.h"
#include "solve/links/nodes.h"
#include "solve/prepare/swept.h"
#include "time/function_block.h"
#include "time/time_grid.h"

namespace strad {

// What the functions of the solve work on. It must outlive what keeps it.
struct Workspace {
  const TimeGrid& grid;
  const NodeTree& tree;
  const Tracer& tracer;
  const SweptBounds& swept;
  int leaf_rays = 128;  // per leaf of a large face
};

// The surface of a leaf (see NodeTree::leaf_at): a patch, or a face of a leaf cluster.
struct LeafSurface {
  uint32_t element;
  double area;  // m^2
  Rgb brdf;     // 1 / sr
};
LeafSurface surface_of(const NodeTree& tree, uint32_t leaf);

// All leaves, ascending.
std::vector<uint32_t> leaves_of(const NodeTree& tree);

// Radiance times area, added up over leaves, time samples and channels.
double total_of(const NodeTree& tree, const FunctionBlock& radiance);

// By row of the radiance of leaves: the mean over time and channels, W / (sr m^2).
std::vector<double> means_over_time(const FunctionBlock& radiance);

// Mean radiance over area and time of the leaves, W / (sr m^2).
double mean_radiance(const NodeTree& tree, const FunctionBlock& radiance);

}  // namespace strad
