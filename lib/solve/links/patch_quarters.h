// Where kernels are sampled on a patch: points of the receiver, and the quarters of the emitter.
#pragma once

#include "base/pose.h"
#include "solve/links/nodes.h"

namespace strad {

struct PatchUv {
  double u, v;
};
// Quadrature points: 2 x 2. Control points, apart from them: near the corners and the centre, and for large
// receivers the middles of the edges too (nine control points halve the error of one).
constexpr int kQuadraturePoints = 4;
constexpr int kFewControlPoints = 5, kMostControlPoints = 9;
constexpr PatchUv kQuadrature[kQuadraturePoints] = {{0.27, 0.23}, {0.77, 0.27}, {0.23, 0.73}, {0.73, 0.77}};
constexpr PatchUv kControl[kMostControlPoints] = {{0.06, 0.06}, {0.94, 0.06}, {0.94, 0.94},
                                                  {0.06, 0.94}, {0.5, 0.5},   {0.5, 0.06},
                                                  {0.94, 0.5},  {0.5, 0.94},  {0.06, 0.5}};
// The quadrature points first, then the control points.
constexpr PatchUv sample_uv(int i) {
  return i < kQuadraturePoints ? kQuadrature[i] : kControl[i - kQuadraturePoints];
}

// One of the four children that a patch has or would have, world.
struct Quarter {
  Vec3 corners[4];
  int count;
  Vec3 centre;
  double area, radius;
};
void quarters_of(const PatchPoints& patch, const Pose& pose, Quarter* quarters);

// Irradiance at x from a quarter of unit radiance, unoccluded.
double unoccluded_irradiance(Vec3 x, Vec3 normal, const Quarter& quarter, Vec3 emitter_normal);

}  // namespace strad
