// Indirect irradiance at the vertices of the mesh: one gather by rays over the radiance that the links have
// found.
//
// Links carry the mean light of patches; rays find what a single point sees (a local pass: Reichert 1992).
// Rays that may meet what moves are traced again at a few instants, and at more where what they bring changes
// (looks.h). In between, what the rays meet before and after is blended, with the radiance that it has at
// each time sample. So indirect light changes as smoothly as things move.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "solve/gather/leaf_counts.h"
#include "solve/gather/looks.h"
#include "solve/gather/ray_bundle.h"
#include "time/function_block.h"

namespace strad {

constexpr float kLeastUnblocked = 0.2f;  // of the view of a leaf: below, its few free rays say too little

struct GatherAccuracy {
  // From a vertex or leaf of a large face, where what a ray brings deviates by its mean or less; up to 8
  // times as many where it deviates by more. Small faces get fewer, by their accuracy share.
  int rays = 512;
  double tolerance = 4e-3;  // share of the light gathered by which its course over time may be off
};

// What the rays of a receiver found at every time sample. `Values`: std::vector<Rgb>, or a ScaledFunction of
// it.
template <typename Values>
struct Gathered {
  Values irradiance;             // W / m^2, scaled up to what a free hemisphere would get
  std::vector<float> unblocked;  // share of the view not blocked by unlit surfaces; empty: all of it
  float noise = 0;               // standard error of the mean over time, relative
};
using GatheredFunction = Gathered<std::vector<Rgb>>;

class FinalGather {
 public:
  // `radiance`: of the leaves, without emission (see NodeTree::leaf_at). `slopes`: its. Keeps references.
  FinalGather(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept,
              const FunctionBlock& radiance, LeafSlopes slopes, DirectionGuide guide,
              const GatherAccuracy& accuracy);

  // At a vertex, or over what it stands for: see receiver_of_vertex.
  GatheredFunction at_vertex(uint32_t vertex, uint64_t* rays) const;
  // The mean over a leaf: each ray starts at another point of it. Not scaled up; `unblocked` is never empty.
  GatheredFunction over_leaf(uint32_t leaf, uint64_t* rays, DirectionCounts* counts = nullptr) const;

 private:
  GatheredFunction gather(Receiver receiver, uint64_t* rays, DirectionCounts* counts) const;
  std::vector<Look> looks_of(const RayBundle& bundle, const std::vector<float>& sums) const;
  bool differs(const RayBundle& bundle, const std::vector<float>& sums, const Look& before,
               const Look& middle, const Look& after) const;
  float noise_of(const RayBundle& bundle, const std::vector<Look>& looks) const;
  void add(const LeafCounts& counts, const LookBlends& blends, float share, std::vector<float>* sums) const;

  const GatherSpace space_;
  const FunctionBlock& radiance_;
  const GatherAccuracy accuracy_;
  std::vector<float> means_;  // [leaf], over time
};

}  // namespace strad
