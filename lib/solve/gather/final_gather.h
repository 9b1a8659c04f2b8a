// Indirect irradiance at the vertices of the mesh: one gather by rays over the radiance that the links have
// found.
//
// Links carry the mean light of patches; rays find what a single point sees (a local pass: Reichert 1992). A
// ray of a vertex at rest is traced again only in cells of time in which a moving body may meet it. Rays of
// vertices of moving bodies are traced at the ends of up to 32 steps per span. In between, what the rays meet
// at both ends is blended, with the radiance that it has at each time sample. So indirect light changes as
// smoothly as things move.
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

// Rays per leaf: noise of some 5 % (10 % for a small face), averaged over the hundreds that a point sees.
constexpr int kLeafRays = 128;
constexpr float kLeastUnblocked = 0.2f;  // of the view of a leaf: below, its few free rays say too little

// What the rays of a receiver found at every time sample. `Values`: std::vector<Rgb>, or a ScaledFunction of
// it.
template <typename Values>
struct Gathered {
  Values irradiance;             // W / m^2, scaled up to what a free hemisphere would get
  std::vector<float> unblocked;  // share of the view not blocked by unlit surfaces; empty: all of it
};
using GatheredFunction = Gathered<std::vector<Rgb>>;

class FinalGather {
 public:
  // `radiance`: of the leaves, without emission (see NodeTree::leaf_at). `rays`: from a vertex or leaf of a
  // large face; small faces get fewer, by their accuracy share. Keeps references.
  FinalGather(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept,
              const FunctionBlock& radiance, int rays);

  // At a vertex; over the uniform face that it stands for; or over its part of an undivided face, since the
  // corners of small faces are often inside of what they touch.
  GatheredFunction at_vertex(uint32_t vertex, uint64_t* rays) const;
  // The mean over a leaf: each ray starts at another point of it. Not scaled up; `unblocked` is never empty.
  GatheredFunction over_leaf(uint32_t leaf, uint64_t* rays) const;

  // What the rays of a leaf meet, as shares of all: surfaces that take part, and unlit ones. Where a node is
  // partly covered (a box stands on it) the covered part sees only the unlit inside of what covers it.
  struct View {
    float lit = 1, unlit = 0;
  };
  View view_of(uint32_t node, uint64_t* rays) const;

 private:
  // Where rays start: all at one point, or spread over a patch; rest.
  struct Receiver {
    Vec3 position, normal;
    uint32_t body = 0;
    uint64_t seed = 0;
    bool spread = false;
    PatchPoints patch{};
    int rays = 0;
  };
  Receiver receiver_on(uint32_t face, Vec3 position, uint64_t seed) const;
  Receiver receiver_of_vertex(uint32_t vertex) const;
  PatchPoints part_at_vertex(uint32_t face, uint32_t vertex) const;
  Receiver receiver_of_patch(const Node& node) const;
  Receiver receiver_of_face(uint32_t face) const;
  View view_of(const Receiver& receiver) const;
  GatheredFunction gather(const Receiver& receiver, uint64_t* rays) const;
  // The leaves that a ray sees at both ends of a cell.
  struct CellEnds {
    uint32_t begin = 0, end = 0;
  };
  GatheredFunction at_rest(const Receiver& receiver, uint64_t* rays) const;
  bool meets_movers(Vec3 from, Vec3 towards, const SurfaceHit& behind, std::vector<CellEnds>* seen,
                    uint64_t* rays) const;
  void add_seen(const std::vector<CellEnds>& seen, float share, GatheredFunction* sum) const;
  void add_always(std::vector<uint32_t> leaves, float share, GatheredFunction* sum) const;
  GatheredFunction in_motion(const Receiver& receiver, uint64_t* rays) const;
  Vec3 direction(const Receiver& receiver, int ray) const;
  Vec3 origin(const Receiver& receiver, int ray) const;
  uint32_t leaf_of(const SurfaceHit& hit) const;
  void add(uint32_t leaf, uint32_t first_sample, uint32_t sample_count, const float* weights,
           GatheredFunction* to) const;

  const NodeTree& tree_;
  const Tracer& tracer_;
  const TimeGrid& grid_;
  const SweptBounds& swept_;
  const FunctionBlock& radiance_;
  int rays_;
  std::vector<bool> still_mask_, moving_mask_;
};

}  // namespace strad
