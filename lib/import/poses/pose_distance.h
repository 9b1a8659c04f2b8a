// How far apart two poses put a box.
#pragma once

#include "base/pose.h"
#include "base/vec.h"

namespace strad {

// The largest distance between where `a` and `b` put a point of the box: that of a corner, since the
// difference of two rigid motions is affine.
double pose_distance(const Pose& a, const Pose& b, const Box& box);

}  // namespace strad
