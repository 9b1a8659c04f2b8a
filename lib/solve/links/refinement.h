// The oracle at work: which links exist, at which level of space and time (the paper's sections 3.1 and 4).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solve/direct/direct_phase.h"
#include "solve/links/kernel.h"
#include "solve/links/link_table.h"
#include "solve/links/nodes.h"
#include "solve/links/transport.h"

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
  // Keeps references. `time_samples`: the probe samples, at which it will know radiance; ascending.
  Refinement(const TimeGrid& grid, const KernelEvaluator& kernels, const DirectPhase& direct,
             const std::vector<uint32_t>& time_samples, NodeTree* tree);

  // Refines all links until the oracle is content. Call again with a lower threshold or after
  // `update_light`.
  void refine(const RefinementOptions& options);

  // Takes the light that `propagate` has found for the probe time samples first .. first + count - 1.
  void update_light(size_t first, size_t count, const NodeLight& light);
  // From now on errors count relative to the light around a receiver where that is below `mean`, the mean
  // radiance of the scene. `dark`: a share of the scene's brightest tenth; what is darker counts as that.
  void weigh_by_local_light(double mean, double dark);

  // Of a node, means over the probe time samples.
  struct Shading {
    float radiance = 0;  // W / (sr m^2), of a cluster the brightest lobe's
    float spread = 0;    // rms difference of its parts' radiance, as far as it has parts
    float weight = 1;    // of errors there
  };
  Shading shading_of(uint32_t node) const;
  double total_area() const { return total_area_; }  // m^2, of the scene

  const std::vector<Link>& links() const { return links_; }
  // Radiance that a slot reflects of direct light at a probe time sample.
  Rgb direct(size_t slot, size_t time_sample) const {
    return direct_[slot * probe_samples_.size() + time_sample];
  }
  const RefinementCounts& counts() const { return counts_; }

 private:
  enum class Action : uint8_t { kUnknown, kAccept, kWait, kDrop, kSplitReceiver, kSplitEmitter, kSplitTime };
  // What a link may carry on its interval: the emitter's brightest radiance, and its spread over the emitter.
  struct Brightness {
    float radiance = 0, spread = 0;
  };
  Brightness brightness(const Link& link) const;
  Action decide_unseen(const Link& link, const RefinementOptions& options) const;
  Action decide(const Link& link, const RefinementOptions& options) const;
  bool can_split(const Node& node, const RefinementOptions& options) const;
  double scale_of(const Node& receiver) const;
  void refine(std::vector<Link> work, const RefinementOptions& options);
  // What to do with each link; makes the estimates that it takes.
  std::vector<Action> decide_all(const RefinementOptions& options, std::vector<Link>* batch);
  bool is_lit(uint32_t node) const;
  void split_nodes(const std::vector<uint32_t>& nodes);
  void describe_new_nodes(size_t first);
  void describe_patch(uint32_t node);
  void describe_cluster(uint32_t node);
  std::vector<Link> children_of(const Link& link, Action action);
  std::vector<Rgb> direct_at_probes(uint32_t element) const;

  const TimeGrid& grid_;
  const KernelEvaluator& kernels_;
  const DirectPhase& direct_phase_;
  std::vector<uint32_t> probe_samples_;
  std::vector<uint32_t> cells_;  // of the time samples, each once
  NodeTree& tree_;
  double total_area_ = 0;
  std::vector<Link> links_;
  std::vector<Link> waiting_;     // whose emitter is dark as far as is known
  std::vector<bool> linked_;      // roots that already emit along links
  std::vector<Rgb> direct_;       // [slot][probe time sample]: radiance reflected of direct light
  std::vector<float> brightest_;  // [node][probe time sample]: radiance, all light, the brightest lobe's
  std::vector<float> spread_;     // [node][probe time sample]: rms difference of its parts' radiance
  std::vector<float> local_;      // [node][probe time sample]: radiance around it, mean over its surfaces
  std::vector<float> weight_;     // [node][probe time sample]: what an error there counts
  RefinementCounts counts_;
};

}  // namespace strad
