// Kernels of two patches.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "solve/links/kernel_means.h"
#include "solve/links/patch_quarters.h"

namespace strad {
namespace {

// A point within a quarter, clear of its edges, for ray number `h`.
Vec3 point_within(const Quarter& quarter, uint64_t h) {
  PatchPoints patch;
  patch.corner_count = quarter.count;
  std::copy_n(quarter.corners, 4, patch.corners);
  return point_on_patch(patch, 0.05 + 0.9 * unit_from(h), 0.05 + 0.9 * unit_from(mix64(h)));
}

// The emitter as a point of the receiver sees it.
struct Emission {
  Quarter quarters[4];
  Vec3 normal;  // world
  double shares[4] = {0, 0, 0, 0};
};

// Irradiance at sample point `i` from the emitter of unit radiance; added to the shares of its quarters.
double irradiance_at(const KernelPair& pair, int i, Vec3 x, Vec3 normal, Emission* emission,
                     KernelCounts* counts) {
  const double offset = pair.tracer.offset();
  const Vec3 from = x + offset * normal, lift = offset * emission->normal;
  double at_x = 0;
  for (int j = 0; j < 4; ++j) {
    const Quarter& quarter = emission->quarters[j];
    const double k = unoccluded_irradiance(x, normal, quarter, emission->normal);
    ++counts->evaluations;
    if (!(k > 1e-7)) continue;
    const Vec3 y = point_within(quarter, hash_of(pair.seed, static_cast<uint64_t>(i * 4 + j)));
    ++counts->rays;
    Rgb passed{1, 1, 1};
    if (pair.tracer.occluded(pair.poses, from, y + lift, &passed)) continue;
    const double arriving = k * double{mean_channel(passed)};
    at_x += arriving;
    emission->shares[j] += arriving;
  }
  return at_x;
}

double rms_against(const double* values, int count, double represented) {
  double error2 = 0;
  for (int i = 0; i < count; ++i) error2 += (values[i] - represented) * (values[i] - represented) / count;
  return std::sqrt(error2);
}

}  // namespace

KernelMeans means_of_patches(const KernelPair& pair, int control, KernelCounts* counts) {
  const Node &p = pair.receiver, &q = pair.emitter;
  const Pose &pose_p = pair.poses[p.body], &pose_q = pair.poses[q.body];
  const PatchPoints patch = patch_points(pair.tree, p);
  const Vec3 normal = rotate(pose_p, p.normal);
  Emission emission;
  emission.normal = rotate(pose_q, q.normal);
  quarters_of(patch_points(pair.tree, q), pose_q, emission.quarters);
  const int count = kQuadraturePoints + control;
  double at_point[kQuadraturePoints + kMostControlPoints], quadrature = 0;
  KernelMeans means;
  for (int i = 0; i < count; ++i) {
    const PatchUv uv = sample_uv(i);
    at_point[i] =
        irradiance_at(pair, i, pose_p * point_on_patch(patch, uv.u, uv.v), normal, &emission, counts);
    means.mean += at_point[i];
    if (i < kQuadraturePoints) quadrature += at_point[i] / kQuadraturePoints;
  }
  means.mean /= count;
  means.receiver_error = rms_against(at_point + kQuadraturePoints, control, quadrature);
  for (int j = 0; j < 4; ++j) {
    const double d = emission.shares[j] / count - means.mean * emission.quarters[j].area / q.area;
    means.emitter_error += d * d;
  }
  means.emitter_error = 2 * std::sqrt(means.emitter_error);  // Cauchy-Schwarz over the four quarters
  return means;
}

}  // namespace strad
