// The oracle at work: which links exist, at which level of space and time (the paper's section 3.1).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solve/direct_phase.h"
#include "solve/kernel.h"
#include "solve/nodes.h"
#include "solve/transport.h"

namespace strad {

struct RefinementOptions {
  double threshold = 0;  // W / (sr m^2): error of radiance * sqrt(receiver area / total area) a link may have
  double smallest_radius = 0;      // m: smaller nodes are not split
  uint32_t smallest_interval = 2;  // log2 of cells: shorter intervals are not split
};

struct RefinementCounts {
  uint64_t rays = 0, evaluations = 0, refined_in_time = 0, refined_in_space = 0;
};

class Refinement {
 public:
  // Keeps references. `dates`: nodes of the grid at which radiance is watched, ascending.
  Refinement(const TimeGrid& grid, const KernelEvaluator& kernels, const DirectPhase& direct,
             const std::vector<uint32_t>& dates, NodeTree* tree);

  // Refines all links until the oracle is content. Call again with a lower threshold or after
  // `update_radiance`.
  void refine(const RefinementOptions& options);

  // Takes what `propagate` made for the watched dates.
  void update_radiance(const std::vector<Rgb>& radiance);

  const std::vector<Link>& links() const { return links_; }
  const std::vector<std::vector<Rgb>>& direct() const { return direct_; }  // [node][watched date]
  const RefinementCounts& counts() const { return counts_; }

 private:
  enum class Action : uint8_t { kAccept, kDrop, kSplitReceiver, kSplitEmitter, kSplitTime };
  Action decide(const Link& link, const RefinementOptions& options) const;
  void split_nodes(const std::vector<uint32_t>& nodes);
  void describe(uint32_t node);
  bool is_lit(uint32_t node) const;

  const TimeGrid& grid_;
  const KernelEvaluator& kernels_;
  const DirectPhase& direct_phase_;
  std::vector<Rgb> watched_direct(uint32_t element) const;

  std::vector<uint32_t> dates_;
  std::vector<uint32_t> cells_;  // of the dates, each once
  NodeTree& tree_;
  double total_area_ = 0;
  std::vector<Link> links_;
  std::vector<std::vector<Rgb>> direct_;    // [node][watched date]
  std::vector<std::vector<Rgb>> radiance_;  // [node][watched date]
  std::vector<std::vector<float>> spread_;  // [node][watched date]: rms difference of the quarters' radiance
  std::vector<bool> linked_;                // root nodes that already emit along links
  RefinementCounts counts_;
};

}  // namespace strad
