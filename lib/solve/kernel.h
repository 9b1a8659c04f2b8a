// The kernel of a link: irradiance at the receiver from an emitter of unit radiance, visibility included, at
// quadrature and control points and dates.
#pragma once

#include <cstdint>
#include <vector>

#include "light/direct.h"
#include "light/tracer.h"
#include "solve/nodes.h"
#include "solve/swept.h"
#include "time/time_grid.h"

namespace strad {

// What refinement needs to know of one candidate link on one interval.
struct KernelEstimate {
  float kernel[kMaxOrder] = {0, 0,
                             0};  // mean over the receiver at the Gauss dates of the interval, in [0, pi]
  float receiver_error =
      0;                    // rms over control points of the kernel minus the represented one, max over dates
  float emitter_error = 0;  // rms difference of the shares of the emitter's four quarters, max over dates
  float time_error = 0;     // rms over control dates of the mean kernel minus the represented one
  bool dynamic = false;     // the kernel may change on the interval
  uint32_t rays = 0;
  uint32_t evaluations = 0;
};

class KernelEvaluator {
 public:
  KernelEvaluator(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept);

  KernelEstimate estimate(uint32_t receiver, uint32_t emitter, Interval interval) const;

 private:
  struct Samples;
  struct Means;
  bool can_exchange(const Node& p, const Node& q, const std::vector<Pose>& poses) const;
  Means sample(const Node& p, const Node& q, uint64_t seed, const std::vector<Pose>& poses, int control,
               KernelEstimate* count) const;

  const NodeTree& tree_;
  const Tracer& tracer_;
  const TimeGrid& grid_;
  const SweptBounds& swept_;
};

}  // namespace strad
