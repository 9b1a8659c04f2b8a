// The rays of a receiver, and what they meet at an instant.
//
// Rays of a receiver at rest are traced once among what rests, and again only where a moving body may come
// before that. Rays of a receiver in motion are traced anew at each instant.
#pragma once

#include <cstdint>
#include <vector>

#include "light/tracer.h"
#include "solve/gather/direction_guide.h"
#include "solve/gather/leaf_slopes.h"
#include "solve/gather/looks.h"
#include "solve/gather/receiver.h"
#include "solve/prepare/swept.h"
#include "time/time_grid.h"

namespace strad {

constexpr uint32_t kOpenView = 0xfffffffeu;  // in place of a leaf: the ray leaves the scene
constexpr uint32_t kUnlit = 0xffffffffu;     // in place of a leaf: a surface that no light reaches

// What rays are traced in. It must outlive what keeps it.
struct GatherSpace {
  GatherSpace(const NodeTree& node_tree, const Tracer& ray_tracer, const TimeGrid& time_grid,
              const SweptBounds& swept_bounds, LeafSlopes leaf_slopes = {},
              DirectionGuide direction_guide = {});
  uint32_t leaf_of(const SurfaceHit& hit) const;
  Seen seen_at(const SurfaceHit& hit) const;
  // What a ray sees through any glass, weighted by the share that arrives; `mask`: of bodies, empty: all.
  // With glass in the scene, what rests and what moves are traced together: which glass lies before a surface
  // depends on both.
  Seen seen_through_glass(const std::vector<Pose>& poses, Vec3 from, Vec3 towards,
                          const std::vector<bool>& mask = {}) const;

  const NodeTree& tree;
  const Tracer& tracer;
  const TimeGrid& grid;
  const SweptBounds& swept;
  LeafSlopes slopes;
  DirectionGuide guide;
  std::vector<bool> still_mask, moving_mask;  // [body]
};

class RayBundle {
 public:
  // Traces among what rests if the receiver rests. Counts rays in `*rays`, also later.
  RayBundle(const GatherSpace& space, const Receiver& receiver, uint64_t* rays);

  size_t ray_count() const { return always_.size() + watched_.size(); }
  // The leaves of rays that never meet anything that moves.
  const std::vector<Seen>& always() const { return always_; }
  // Adds what all rays have brought by the mean radiance of leaves; `looks`: what the other rays saw.
  void count(const std::vector<float>& mean_radiance, const std::vector<Look>& looks,
             DirectionCounts* counts) const;
  // The leaves of the other rays, in order, at an end of a cell (see Look).
  std::vector<Seen> see(uint32_t span, uint32_t cell) const;
  // By how many rays at most what they may meet of moving bodies in a cell differs from the blend of the
  // first and the last of these cells. 0 for a receiver in motion, of which nothing is known.
  uint32_t surprise(uint32_t first_cell, uint32_t end_cell) const;

 private:
  struct Watched {
    RestRay ray;  // world if the receiver rests
    double reach;
    Seen behind;  // of what rests
  };
  void trace_still(const std::vector<RestRay>& rest_rays);
  bool may_meet(size_t watched, uint32_t cell) const { return meets_[watched * cells_ + cell]; }

  const GatherSpace& space_;
  uint32_t body_;
  bool moves_;
  size_t cells_;
  std::vector<Seen> always_;
  std::vector<RestRay> always_rays_;
  std::vector<Watched> watched_;
  std::vector<bool> meets_;       // [watched * cells + cell], of a receiver at rest
  std::vector<uint32_t> active_;  // [cell]: watched rays that may meet something that moves
  uint64_t& rays_;
};

}  // namespace strad
