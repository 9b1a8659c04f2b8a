// The kernel of a link at one time sample: its mean over sample points, and how far it differs from that.
#pragma once

#include <cstdint>
#include <vector>

#include "light/tracer.h"
#include "solve/links/nodes.h"

namespace strad {

struct KernelCounts {
  uint64_t rays = 0, evaluations = 0;
};

struct KernelMeans {
  double mean = 0;            // over all points
  double receiver_error = 0;  // rms over control points against what is represented there
  // What an emitter whose radiance differs by 1 (rms) over its parts may add to the irradiance.
  double emitter_error = 0;
};

// Two nodes at one time sample.
struct KernelPair {
  const NodeTree& tree;
  const Tracer& tracer;
  const std::vector<Pose>& poses;  // of all bodies
  const Node &receiver, &emitter;
  uint64_t seed;  // of the rays
};

// Of two patches. `control`: how many control points the receiver has.
KernelMeans means_of_patches(const KernelPair& pair, int control, KernelCounts* counts);

// Of two nodes, at least one of them a cluster.
KernelMeans means_of_clusters(const KernelPair& pair, int control, KernelCounts* counts);

}  // namespace strad
