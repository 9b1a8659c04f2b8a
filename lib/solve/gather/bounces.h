// Corrects the radiance of leaves by bounces along rays.
#pragma once

#include <cstdint>

#include "solve/gather/direction_guide.h"
#include "solve/gather/leaf_slopes.h"
#include "solve/links/direct_of_leaves.h"
#include "solve/links/leaf_radiance.h"

namespace strad {

struct Bounces {
  DirectionGuide guide;
  LeafSlopes slopes;  // of the radiance
  uint64_t rays = 0;
  int rounds = 0;
  double change = 0;  // of the last round: rms over area, each leaf relative to its own radiance
};

// Takes out what is left of the errors of the links. Each is small, but thousands have the same sign. A
// gather along rays is unbiased: what it finds more or less than is there, the residual, is propagated along
// the links and added (iterative refinement: Wilkinson 1963), which multiplies the error by the relative
// error of the links. Where that does not help, in rooms of which the links know little, bounces go on by
// rays alone. It ends when the change is below a share of `error`. `input`: the links.
Bounces correct_by_bounces(const Workspace& work, const DirectOfLeaves& direct, const TransportInput& input,
                           double error, FunctionBlock* radiance);

}  // namespace strad
