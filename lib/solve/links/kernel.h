// The kernel of a link: mean irradiance at the receiver from an emitter of unit radiance, with visibility.
//
// It is sampled at quadrature points and Gauss nodes of time; control points and control instants between
// them tell its error. Either end may be a patch or a cluster. Rays run from surface point to surface point,
// so the shadows that clusters cast on themselves are part of it.
#pragma once

#include <cstdint>
#include <vector>

#include "light/tracer.h"
#include "solve/links/kernel_means.h"
#include "solve/links/nodes.h"
#include "solve/prepare/swept.h"
#include "time/time_grid.h"

namespace strad {

// The kernel of a possible link on one interval, and its errors.
struct KernelEstimate {
  // Mean over the receiver at the Gauss time samples of the interval, in [0, pi].
  float kernel[kMaxOrder] = {0, 0, 0};
  // Root mean square over control points of the difference between the kernel there and `kernel`, at the time
  // sample or control instant where it is largest.
  float receiver_error = 0;
  // The error of irradiance if the radiance of the emitter's parts differs from their mean by 1 (rms), at the
  // time sample or control instant where it is largest.
  float emitter_error = 0;
  float time_error = 0;  // rms over control instants of the difference between the mean kernel and `kernel`
  bool dynamic = false;  // the kernel may change on the interval
  bool known = false;    // the estimate has been made
};

class KernelEvaluator {
 public:
  KernelEvaluator(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept);

  KernelEstimate estimate(uint32_t receiver, uint32_t emitter, Interval interval, KernelCounts* counts) const;

  // Do the boxes of two nodes, one of them a cluster, meet at one of the time samples of the interval? True
  // for a cluster and itself. Then no single direction describes their exchange.
  bool overlap(uint32_t receiver, uint32_t emitter, Interval interval) const;

 private:
  bool can_exchange(const Node& p, const Node& q, const std::vector<Pose>& poses) const;
  // The kernel at the Gauss time samples, and errors also at control instants between them.
  void sample_changing(const Node& p, const Node& q, uint64_t seed, Interval interval,
                       KernelEstimate* estimate, KernelCounts* counts) const;

  const NodeTree& tree_;
  const Tracer& tracer_;
  const TimeGrid& grid_;
  const SweptBounds& swept_;
};

}  // namespace strad
