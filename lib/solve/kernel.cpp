#include "solve/kernel.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

struct Uv {
  double u, v;
};
// Quadrature points: 2 x 2. Control points, apart from them: near the corners and the centre, and for large
// receivers the middles of the edges too (nine control points halve the error of one).
constexpr Uv kQuadrature[4] = {{0.27, 0.23}, {0.77, 0.27}, {0.23, 0.73}, {0.73, 0.77}};
constexpr Uv kControl[9] = {{0.06, 0.06}, {0.94, 0.06}, {0.94, 0.94}, {0.06, 0.94}, {0.5, 0.5},
                            {0.5, 0.06},  {0.94, 0.5},  {0.5, 0.94},  {0.06, 0.5}};

struct Quarter {
  Vec3 corners[4];
  int count;
  Vec3 centre;
  double area, radius;
};

Quarter finish(Quarter quarter) {
  const Vec3* c = quarter.corners;
  quarter.area = 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
  if (quarter.count == 4) quarter.area += 0.5 * length(cross(c[2] - c[0], c[3] - c[0]));
  for (int i = 0; i < quarter.count; ++i) quarter.centre += c[i] / quarter.count;
  quarter.radius = 0;
  for (int i = 0; i < quarter.count; ++i)
    quarter.radius = std::max(quarter.radius, length(c[i] - quarter.centre));
  return quarter;
}

// The four children that the patch has or would have, world.
void quarters_of(const PatchPoints& patch, const Pose& pose, Quarter* quarters) {
  const int n = patch.corner_count;
  Vec3 c[4], m[4], mid;
  for (int i = 0; i < n; ++i) c[i] = pose * patch.corners[i];
  for (int i = 0; i < n; ++i) {
    m[i] = 0.5 * (c[i] + c[(i + 1) % n]);
    mid += c[i] / n;
  }
  for (int i = 0; i < n; ++i) {
    const Vec3 before = m[(i + n - 1) % n];
    quarters[i] = n == 4 ? finish({{c[i], m[i], mid, before}, 4, {}, 0, 0})
                         : finish({{c[i], m[i], before, {}}, 3, {}, 0, 0});
  }
  if (n == 3) quarters[3] = finish({{m[0], m[1], m[2], {}}, 3, {}, 0, 0});
}

// Irradiance at x from a quarter of unit radiance, unoccluded.
double unoccluded(Vec3 x, Vec3 normal, const Quarter& quarter, Vec3 emitter_normal) {
  const Vec3 to = quarter.centre - x;
  const double distance2 = length2(to);
  // Beyond 4 radii a point serves: the error falls with the square of the ratio, here below 2 %.
  if (distance2 < 16 * quarter.radius * quarter.radius) {
    if (!(dot(x - quarter.centre, emitter_normal) > 0)) return 0;
    return unit_irradiance(x, normal, quarter.corners, quarter.count);
  }
  const double cos_x = dot(to, normal), cos_y = -dot(to, emitter_normal);
  if (!(cos_x > 0) || !(cos_y > 0)) return 0;
  return cos_x * cos_y * quarter.area / (distance2 * distance2);
}

bool any_in_front(const PatchPoints& patch, const Pose& pose, Vec3 origin, Vec3 normal) {
  for (int i = 0; i < patch.corner_count; ++i)
    if (dot(pose * patch.corners[i] - origin, normal) > 1e-9) return true;
  return false;
}

}  // namespace

// Sums over the sample points at one date.
struct KernelEvaluator::Means {
  double mean = 0;            // over all points
  double quadrature = 0;      // over the quadrature points
  double receiver_error = 0;  // rms over control points against the quadrature mean
  double emitter_error = 0;   // root of the sum over quarters of (share - a quarter of the mean)^2
};

KernelEvaluator::KernelEvaluator(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                                 const SweptBounds& swept)
    : tree_(tree), tracer_(tracer), grid_(grid), swept_(swept) {}

bool KernelEvaluator::can_exchange(const Node& p, const Node& q, const std::vector<Pose>& poses) const {
  const PatchPoints patch_p = patch_points(tree_, p), patch_q = patch_points(tree_, q);
  const Pose &pose_p = poses[p.body], &pose_q = poses[q.body];
  return any_in_front(patch_q, pose_q, pose_p * p.centre, rotate(pose_p, p.normal)) &&
         any_in_front(patch_p, pose_p, pose_q * q.centre, rotate(pose_q, q.normal));
}

KernelEvaluator::Means KernelEvaluator::sample(const Node& p, const Node& q, uint64_t seed,
                                               const std::vector<Pose>& poses, int control,
                                               KernelEstimate* count) const {
  const Pose &pose_p = poses[p.body], &pose_q = poses[q.body];
  const PatchPoints patch = patch_points(tree_, p);
  const Vec3 normal = rotate(pose_p, p.normal), emitter_normal = rotate(pose_q, q.normal);
  Quarter quarters[4];
  quarters_of(patch_points(tree_, q), pose_q, quarters);
  const Vec3 lift_p = tracer_.offset() * normal, lift_q = tracer_.offset() * emitter_normal;
  double at_control[9], shares[4] = {0, 0, 0, 0};
  Means means;
  for (int i = 0; i < 4 + control; ++i) {
    const Uv uv = i < 4 ? kQuadrature[i] : kControl[i - 4];
    const Vec3 x = pose_p * point_on_patch(patch, uv.u, uv.v);
    double at_x = 0;
    for (int j = 0; j < 4; ++j) {
      const double k = unoccluded(x, normal, quarters[j], emitter_normal);
      ++count->evaluations;
      if (!(k > 1e-7)) continue;
      const uint64_t h = hash_of(seed, static_cast<uint64_t>(i * 4 + j));
      PatchPoints target;
      target.corner_count = quarters[j].count;
      std::copy_n(quarters[j].corners, 4, target.corners);
      const Vec3 y = point_on_patch(target, 0.05 + 0.9 * unit_from(h), 0.05 + 0.9 * unit_from(mix64(h)));
      ++count->rays;
      if (tracer_.occluded(poses, x + lift_p, y + lift_q)) continue;
      at_x += k;
      shares[j] += k;
    }
    means.mean += at_x;
    if (i < 4)
      means.quadrature += at_x / 4;
    else
      at_control[i - 4] = at_x;
  }
  means.mean /= 4 + control;
  for (int i = 0; i < control; ++i)
    means.receiver_error += (at_control[i] - means.quadrature) * (at_control[i] - means.quadrature) / control;
  means.receiver_error = std::sqrt(means.receiver_error);
  for (int j = 0; j < 4; ++j) {
    const double d = shares[j] / (4 + control) - means.mean * quarters[j].area / q.area;
    means.emitter_error += d * d;
  }
  means.emitter_error = std::sqrt(means.emitter_error);
  return means;
}

KernelEstimate KernelEvaluator::estimate(uint32_t receiver, uint32_t emitter, Interval interval) const {
  const Node &p = tree_.nodes()[receiver], &q = tree_.nodes()[emitter];
  KernelEstimate e;
  const std::vector<Pose> middle = swept_.poses(interval, 0.5);
  const bool relative_motion = p.body != q.body && (swept_.moves(p.body) || swept_.moves(q.body));
  if (!relative_motion && !can_exchange(p, q, middle)) return e;
  e.dynamic = grid_.cell_count() > 1 && (relative_motion || swept_.moves(p.body) ||
                                         swept_.may_block(middle[p.body] * p.centre, p.radius,
                                                          middle[q.body] * q.centre, q.radius, interval));
  const uint64_t seed = hash_of(receiver, emitter);
  const int control = p.area > 0.25 * q.area ? 9 : 5;
  if (!e.dynamic) {
    const Means means = sample(p, q, seed, middle, control, &e);
    for (float& k : e.kernel) k = static_cast<float>(means.mean);
    e.receiver_error = static_cast<float>(means.receiver_error);
    e.emitter_error = static_cast<float>(means.emitter_error);
    return e;
  }
  const int order = grid_.order;
  const auto worst = [&](const Means& means) {
    e.receiver_error = std::max(e.receiver_error, static_cast<float>(means.receiver_error));
    e.emitter_error = std::max(e.emitter_error, static_cast<float>(means.emitter_error));
  };
  for (int k = 0; k < order; ++k) {
    const std::vector<Pose> poses = swept_.poses(interval, gauss_nodes(order)[k]);
    if (!can_exchange(p, q, poses)) continue;
    const Means means = sample(p, q, seed, poses, k == 0 ? control : 5, &e);
    e.kernel[k] = static_cast<float>(means.mean);
    worst(means);
  }
  // Control dates: both ends and, the longer the interval, the more between; none of them is a Gauss date.
  const int dates = interval.log2_cells >= 4 ? 8 : interval.log2_cells >= 2 ? 6 : 4;
  double error2 = 0;
  for (int d = 0; d < dates; ++d) {
    const double s = static_cast<double>(d) / (dates - 1);
    const std::vector<Pose> poses = swept_.poses(interval, s);
    Means means;
    if (can_exchange(p, q, poses)) means = sample(p, q, seed, poses, 5, &e);
    double weights[kMaxOrder], represented = 0;
    lagrange_weights(order, s, weights);
    for (int k = 0; k < order; ++k) represented += weights[k] * e.kernel[k];
    error2 += (means.mean - represented) * (means.mean - represented) / dates;
    worst(means);
  }
  e.time_error = static_cast<float>(std::sqrt(error2));
  return e;
}

}  // namespace strad
