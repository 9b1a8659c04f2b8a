// One gather along all links at a block of time samples: irradiance of every node from the radiance of every
// other.
#pragma once

#include <cstdint>
#include <vector>

#include "light/direct.h"
#include "solve/links/link_table.h"
#include "solve/links/nodes.h"
#include "time/time_grid.h"

namespace strad {

class LinkGather {
 public:
  // Prepares what the links do at the time samples. Keeps references.
  // `instants`: of all time samples of the grid.
  LinkGather(const TimeGrid& grid, const NodeTree& tree, const LinkTable& links,
             const std::vector<Instant>& instants, const std::vector<uint32_t>& time_samples);

  // irradiance[slot] += sum of kernel * radiance[slot]; arrays of 3 * time samples floats per slot.
  void run(const float* radiance, float* irradiance) const;

 private:
  // One end of a link: a patch, three lobes of a cluster, or all six where it exchanges light with itself.
  struct End {
    uint32_t slot[kLobes];
    float weight[kLobes];
    int count;
  };
  End receiving_end(const Node& p, const Node& q, size_t time_sample) const;
  End emitting_end(const Node& p, const Node& q, size_t time_sample) const;
  Vec3 towards(const Node& from, const Node& to, size_t time_sample) const;
  void add(const Node& p, const Node& q, const float* kernel, const float* radiance, float* irradiance) const;
  void add_still(const Node& p, const Node& q, float kernel, const float* radiance, float* irradiance) const;

  const NodeTree& tree_;
  const LinkTable& links_;
  size_t count_;
  std::vector<const Instant*> instants_;  // of the time samples
  std::vector<uint32_t> first_dynamic_, emitters_;
  std::vector<float> kernels_;
};

}  // namespace strad
