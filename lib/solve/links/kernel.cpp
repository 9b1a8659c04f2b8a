#include "solve/links/kernel.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "solve/links/patch_quarters.h"

namespace strad {
namespace {

// Box of a node in the frame of another body.
Box box_in(const NodeTree& tree, const Node& node, const Pose& own, const Pose& other) {
  Box box;
  const auto add = [&](Vec3 corner) { box.add(&own == &other ? corner : inverse(other) * (own * corner)); };
  if (!node.is_cluster()) {
    const PatchPoints patch = patch_points(tree, node);
    for (int i = 0; i < patch.corner_count; ++i) add(patch.corners[i]);
    return box;
  }
  const Box& own_box = tree.cluster(node).box;
  for (int corner = 0; corner < 8; ++corner)
    add({corner & 1 ? own_box.lower.x : own_box.upper.x, corner & 2 ? own_box.lower.y : own_box.upper.y,
         corner & 4 ? own_box.lower.z : own_box.upper.z});
  return box;
}

bool any_in_front(const PatchPoints& patch, const Pose& pose, Vec3 origin, Vec3 normal) {
  for (int i = 0; i < patch.corner_count; ++i)
    if (dot(pose * patch.corners[i] - origin, normal) > 1e-9) return true;
  return false;
}

KernelMeans means_of(const KernelPair& pair, int control, KernelCounts* counts) {
  return pair.receiver.is_cluster() || pair.emitter.is_cluster() ? means_of_clusters(pair, control, counts)
                                                                 : means_of_patches(pair, control, counts);
}

// For a kernel that stays the same on its interval.
void sample_still(const KernelPair& pair, KernelEstimate* estimate, KernelCounts* counts) {
  const int control = pair.receiver.area > 0.25 * pair.emitter.area ? kMostControlPoints : kFewControlPoints;
  const KernelMeans means = means_of(pair, control, counts);
  for (float& k : estimate->kernel) k = static_cast<float>(means.mean);
  estimate->receiver_error = static_cast<float>(means.receiver_error);
  estimate->emitter_error = static_cast<float>(means.emitter_error);
}

// The represented kernel at fraction `s` of its interval.
double represented_at(double s, int order, const float* kernel) {
  double weights[kMaxOrder], represented = 0;
  lagrange_weights(order, s, weights);
  for (int k = 0; k < order; ++k) represented += weights[k] * kernel[k];
  return represented;
}

bool is_constant(const KernelEstimate& e, int order) {
  const float least = 1e-6f * e.kernel[0];
  return e.time_error <= least &&
         std::all_of(e.kernel, e.kernel + order, [&](float k) { return std::abs(k - e.kernel[0]) <= least; });
}

}  // namespace

KernelEvaluator::KernelEvaluator(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                                 const SweptBounds& swept)
    : tree_(tree), tracer_(tracer), grid_(grid), swept_(swept) {}

bool KernelEvaluator::can_exchange(const Node& p, const Node& q, const std::vector<Pose>& poses) const {
  if (p.is_cluster() || q.is_cluster()) return true;
  const PatchPoints patch_p = patch_points(tree_, p), patch_q = patch_points(tree_, q);
  const Pose &pose_p = poses[p.body], &pose_q = poses[q.body];
  return any_in_front(patch_q, pose_q, pose_p * p.centre, rotate(pose_p, p.normal)) &&
         any_in_front(patch_p, pose_p, pose_q * q.centre, rotate(pose_q, q.normal));
}

bool KernelEvaluator::overlap(uint32_t receiver, uint32_t emitter, Interval interval) const {
  const Node &p = tree_.nodes()[receiver], &q = tree_.nodes()[emitter];
  if (receiver == emitter) return p.is_cluster();
  if (!p.is_cluster() && !q.is_cluster()) return false;
  const auto meet = [&](const std::vector<Pose>& poses) {
    const Box a = box_in(tree_, p, poses[p.body], poses[q.body]),
              b = box_in(tree_, q, poses[q.body], poses[q.body]);
    for (int i = 0; i < 3; ++i)
      if (a.lower[i] > b.upper[i] || b.lower[i] > a.upper[i]) return false;
    return true;
  };
  if (p.body == q.body || !(swept_.moves(p.body) || swept_.moves(q.body)))
    return meet(swept_.poses(interval, 0.5));
  constexpr int kTimes = 5;
  for (int i = 0; i < kTimes; ++i)
    if (meet(swept_.poses(interval, static_cast<double>(i) / (kTimes - 1)))) return true;
  return false;
}

void KernelEvaluator::sample_changing(const Node& p, const Node& q, uint64_t seed, Interval interval,
                                      KernelEstimate* estimate, KernelCounts* counts) const {
  KernelEstimate& e = *estimate;
  // The mean kernel at fraction `s` of the interval; the worst errors are kept.
  const auto mean_at = [&](double s) {
    const std::vector<Pose> poses = swept_.poses(interval, s);
    if (!can_exchange(p, q, poses)) return 0.0;
    const KernelMeans means = means_of({tree_, tracer_, poses, p, q, seed}, kFewControlPoints, counts);
    e.receiver_error = std::max(e.receiver_error, static_cast<float>(means.receiver_error));
    e.emitter_error = std::max(e.emitter_error, static_cast<float>(means.emitter_error));
    return means.mean;
  };
  const int order = grid_.order;
  for (int k = 0; k < order; ++k) e.kernel[k] = static_cast<float>(mean_at(gauss_nodes(order)[k]));
  // Control instants: both ends of the interval, and more between them the longer it is. None of them is a
  // Gauss node.
  const int times = interval.log2_cells >= 4 ? 8 : interval.log2_cells >= 2 ? 6 : 4;
  double error2 = 0;
  for (int i = 0; i < times; ++i) {
    const double s = static_cast<double>(i) / (times - 1);
    const double mean = mean_at(s), represented = represented_at(s, order, e.kernel);
    error2 += (mean - represented) * (mean - represented) / times;
  }
  e.time_error = static_cast<float>(std::sqrt(error2));
}

KernelEstimate KernelEvaluator::estimate(uint32_t receiver, uint32_t emitter, Interval interval,
                                         KernelCounts* counts) const {
  const Node &p = tree_.nodes()[receiver], &q = tree_.nodes()[emitter];
  KernelEstimate e;
  e.known = true;
  const std::vector<Pose> middle = swept_.poses(interval, 0.5);
  const bool relative_motion = p.body != q.body && (swept_.moves(p.body) || swept_.moves(q.body));
  if (!relative_motion && !can_exchange(p, q, middle)) return e;
  e.dynamic = grid_.cell_count() > 1 && (relative_motion || swept_.moves(p.body) ||
                                         swept_.may_block(middle[p.body] * p.centre, p.radius,
                                                          middle[q.body] * q.centre, q.radius, interval));
  const uint64_t seed = hash_of(receiver, emitter);
  if (!e.dynamic) {
    sample_still({tree_, tracer_, middle, p, q, seed}, &e, counts);
    return e;
  }
  sample_changing(p, q, seed, interval, &e, counts);
  // If the kernel turns out constant, only relative motion of the ends makes the link dynamic.
  if (is_constant(e, grid_.order)) e.dynamic = relative_motion;
  return e;
}

}  // namespace strad
