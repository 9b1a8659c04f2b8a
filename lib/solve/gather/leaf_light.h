// The radiance of the leaves of the hierarchy at all dates: from links, then settled by rays.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "light/tracer.h"
#include "solve/direct/direct_phase.h"
#include "solve/links/nodes.h"
#include "solve/links/transport.h"
#include "solve/prepare/swept.h"
#include "time/light_functions.h"
#include "time/time_grid.h"

namespace strad {

// What the solve works on. All outlive the functions below.
struct Workspace {
  const TimeGrid& grid;
  const NodeTree& tree;
  const Tracer& tracer;
  const SweptBounds& swept;
};

// The share of surfaces that take part in what each leaf sees of the exposed part of itself, at the middle of
// the animation, by node.
std::vector<float> openness_of(const Workspace& work, uint64_t* rays);

// Mean direct irradiance of lights, W / m^2: held for patches and large faces, read for uniform ones.
class DirectOfLights {
 public:
  // `kept`: what the phase will give or has given to keep, of which only uniform faces are read, and not
  // before `irradiance` is called. Keeps `work` and `kept`.
  DirectOfLights(const Workspace& work, const DirectPhase& phase, const Field& kept);

  // At the nodes of `count` cells from `first` on.
  std::vector<Rgb> irradiance(uint32_t light, uint32_t first, uint32_t count) const;

 private:
  const Workspace work_;
  const Field& kept_;
  LightFunctions held_;
};

// Radiance reflected by the lights, W / (sr m^2), along links. `input.direct` need not be set.
LightFunctions propagate_all(const Workspace& work, const DirectOfLights& direct, TransportInput input,
                             int* iterations, double* residual);

// Mean radiance of the lights that are lit, over area and time.
double mean_radiance(const NodeTree& tree, const LightFunctions& radiance);

// Takes out what is left of the links' errors, which are sums of small ones of one sign: bounces by rays,
// which are unbiased, shrink it by one factor each. The factor is known from how much of the light was
// reflected more than once, so after two the rest of the geometric series is added at once. Returns the rays
// traced.
uint64_t settle_by_rays(const Workspace& work, const DirectOfLights& direct, LightFunctions* radiance);

}  // namespace strad
