// Kernels of two nodes of which one is a cluster.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "solve/links/kernel_ends.h"
#include "solve/links/kernel_means.h"

namespace strad {
namespace {

constexpr int kRaysAPoint = 3;
constexpr double kLeastResponse =
    0.05;  // below it the samples hardly face the other end: their mean is unreliable

// Both ends of a pair, and the irradiance of the receiver's points from the emitter's parts.
struct Exchange {
  ReceiverPoint points[kMostPoints];
  EmitterPart parts[kMostParts];
  int point_count = 0, part_count = 0;
  double at_point[kMostPoints] = {};  // irradiance
  double shares[kMostParts] = {};     // of the unoccluded irradiance, summed over the points
  double unoccluded = 0;              // irradiance, summed over the points that get any
  double mean = 0;                    // of at_point
  double response = 0;                // mean over the points
  double represented = 0;             // sum over the parts
};

Exchange exchange_of(const KernelPair& pair, int control) {
  const Node &p = pair.receiver, &q = pair.emitter;
  const Pose &pose_p = pair.poses[p.body], &pose_q = pair.poses[q.body];
  const Vec3 towards = pose_q * q.centre - pose_p * p.centre;
  Exchange e;
  e.point_count = receiver_points(pair.tree, p, pose_p, towards, control, e.points);
  e.part_count = emitter_parts(pair.tree, q, pose_q, -1 * towards, e.parts);
  for (int i = 0; i < e.point_count; ++i) e.response += e.points[i].response / e.point_count;
  for (int j = 0; j < e.part_count; ++j) e.represented += e.parts[j].represented;
  return e;
}

// What arrives of `unoccluded`, the sum of what the parts would give to point `i` (`from`), as a few rays
// see. The same pairs at every time sample, except those without exchange: visibility may change only with
// what moves.
double arriving(const KernelPair& pair, const Exchange& e, int i, const double* from, double unoccluded,
                KernelCounts* counts) {
  const double offset = pair.tracer.offset();
  const ReceiverPoint& x = e.points[i];
  const uint64_t h = hash_of(pair.seed, static_cast<uint64_t>(i)),
                 parts = static_cast<uint64_t>(e.part_count);
  double tested = 0, visible = 0;
  int rays = 0;
  for (uint64_t k = 0; k < parts && rays < kRaysAPoint; ++k) {
    const auto j = static_cast<int>((h + k * 5) % parts);
    if (!(from[j] > 0)) continue;
    ++rays;
    tested += from[j];
    Rgb passed{1, 1, 1};
    if (!pair.tracer.occluded(pair.poses, x.position + offset * x.normal,
                              e.parts[j].position + offset * e.parts[j].normal, &passed))
      visible += from[j] * double{mean_channel(passed)};
  }
  counts->rays += static_cast<uint64_t>(rays);
  return tested > 0 ? unoccluded * visible / tested : 0;
}

void sample_point(const KernelPair& pair, int i, Exchange* e, KernelCounts* counts) {
  double from[kMostParts], unoccluded = 0;
  for (int j = 0; j < e->part_count; ++j) {
    from[j] = unoccluded_irradiance(e->points[i], e->parts[j]);
    unoccluded += from[j];
    e->shares[j] += from[j];
  }
  counts->evaluations += static_cast<uint64_t>(e->part_count);
  if (!(unoccluded > 1e-7)) return;
  e->at_point[i] = arriving(pair, *e, i, from, unoccluded, counts);
  e->mean += e->at_point[i] / e->point_count;
  e->unoccluded += unoccluded;
}

// A few samples do not cover the lobes of a cluster evenly. The mean response of a complete cover is 1, so
// the mean over the samples gives the correction.
void correct_cover(Exchange* e) {
  for (const double sampled : {e->response, e->represented})
    if (sampled > kLeastResponse) {
      const double factor = std::min(1 / sampled, 2.0);
      e->mean *= factor;
      for (int i = 0; i < e->point_count; ++i) e->at_point[i] *= factor;
    }
}

double receiver_error(const Exchange& e) {
  double error2 = 0;
  for (int i = 0; i < e.point_count; ++i) {
    const double represented =
        e.response > kLeastResponse ? e.mean * e.points[i].response / e.response : e.mean;
    error2 += (e.at_point[i] - represented) * (e.at_point[i] - represented) / e.point_count;
  }
  return std::sqrt(error2);
}

// `visible`: share of the unoccluded irradiance that arrives. If it is partial, it is not known which parts
// are hidden.
double emitter_error(const Exchange& e, double visible) {
  double uneven = 0;
  for (int j = 0; j < e.part_count; ++j) {
    const double d = e.shares[j] / e.unoccluded -
                     (e.represented > kLeastResponse ? e.parts[j].represented / e.represented : 0);
    uneven += e.part_count * d * d;
  }
  return e.mean * std::sqrt(uneven + (1 - visible) / visible);
}

}  // namespace

KernelMeans means_of_clusters(const KernelPair& pair, int control, KernelCounts* counts) {
  Exchange e = exchange_of(pair, control);
  for (int i = 0; i < e.point_count; ++i) sample_point(pair, i, &e, counts);
  if (!(e.unoccluded > 0)) return {};
  const double visible = std::clamp(e.mean * e.point_count / e.unoccluded, 0.05, 1.0);
  correct_cover(&e);
  return {e.mean, receiver_error(e), emitter_error(e, visible)};
}

}  // namespace strad
