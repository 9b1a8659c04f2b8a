#include "solve/links/kernel.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "scene/polygon_geometry.h"

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
  quarter.area = area_of(c, quarter.count);
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
  // Beyond 4 radii a point is exact enough: the error falls with the square of the ratio, here below 2 %.
  if (distance2 < 16 * quarter.radius * quarter.radius) {
    if (!(dot(x - quarter.centre, emitter_normal) > 0)) return 0;
    return unit_irradiance(x, normal, quarter.corners, quarter.count);
  }
  const double cos_x = dot(to, normal), cos_y = -dot(to, emitter_normal);
  if (!(cos_x > 0) || !(cos_y > 0)) return 0;
  return cos_x * cos_y * quarter.area / (distance2 * distance2);
}

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

}  // namespace

// Sums over the sample points at one time sample.
struct KernelEvaluator::Means {
  double mean = 0;            // over all points
  double receiver_error = 0;  // rms over control points against what is represented there
  double emitter_error = 0;   // as in KernelEstimate
};

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

KernelEvaluator::Means KernelEvaluator::sample_patches(const Node& p, const Node& q, uint64_t seed,
                                                       const std::vector<Pose>& poses, int control,
                                                       KernelCounts* counts) const {
  const Pose &pose_p = poses[p.body], &pose_q = poses[q.body];
  const PatchPoints patch = patch_points(tree_, p);
  const Vec3 normal = rotate(pose_p, p.normal), emitter_normal = rotate(pose_q, q.normal);
  Quarter quarters[4];
  quarters_of(patch_points(tree_, q), pose_q, quarters);
  const Vec3 lift_p = tracer_.offset() * normal, lift_q = tracer_.offset() * emitter_normal;
  double at_control[9], shares[4] = {0, 0, 0, 0}, quadrature = 0;
  Means means;
  for (int i = 0; i < 4 + control; ++i) {
    const Uv uv = i < 4 ? kQuadrature[i] : kControl[i - 4];
    const Vec3 x = pose_p * point_on_patch(patch, uv.u, uv.v);
    double at_x = 0;
    for (int j = 0; j < 4; ++j) {
      const double k = unoccluded(x, normal, quarters[j], emitter_normal);
      ++counts->evaluations;
      if (!(k > 1e-7)) continue;
      const uint64_t h = hash_of(seed, static_cast<uint64_t>(i * 4 + j));
      PatchPoints target;
      target.corner_count = quarters[j].count;
      std::copy_n(quarters[j].corners, 4, target.corners);
      const Vec3 y = point_on_patch(target, 0.05 + 0.9 * unit_from(h), 0.05 + 0.9 * unit_from(mix64(h)));
      ++counts->rays;
      if (tracer_.occluded(poses, x + lift_p, y + lift_q)) continue;
      at_x += k;
      shares[j] += k;
    }
    means.mean += at_x;
    if (i < 4)
      quadrature += at_x / 4;
    else
      at_control[i - 4] = at_x;
  }
  means.mean /= 4 + control;
  for (int i = 0; i < control; ++i)
    means.receiver_error += (at_control[i] - quadrature) * (at_control[i] - quadrature) / control;
  means.receiver_error = std::sqrt(means.receiver_error);
  for (int j = 0; j < 4; ++j) {
    const double d = shares[j] / (4 + control) - means.mean * quarters[j].area / q.area;
    means.emitter_error += d * d;
  }
  means.emitter_error = 2 * std::sqrt(means.emitter_error);  // Cauchy-Schwarz over the four quarters
  return means;
}

namespace {

// Points of the receiver and parts of the emitter, world; those of patches and clusters alike.
struct ReceiverPoint {
  Vec3 position, normal;
  float response = 1;  // of the represented irradiance there, in units of its mean
};

struct EmitterPart {
  Vec3 position, normal;
  float area = 0;
  float represented = 0;  // share of the flux that the representation takes from it, from equal radiance
};

constexpr int kMostPoints = std::max(Cluster::kSamples, 13);
constexpr int kMostParts = std::max(Cluster::kSamples, 4);
constexpr int kRaysAPoint = 3;

// `towards`: from the receiver's centre to the emitter's, world.
int receiver_points(const NodeTree& tree, const Node& p, const Pose& pose, Vec3 towards, int control,
                    ReceiverPoint* points) {
  if (!p.is_cluster()) {
    const PatchPoints patch = patch_points(tree, p);
    const Vec3 normal = rotate(pose, p.normal);
    for (int i = 0; i < 4 + control; ++i) {
      const Uv uv = i < 4 ? kQuadrature[i] : kControl[i - 4];
      points[i] = {pose * point_on_patch(patch, uv.u, uv.v), normal, 1};
    }
    return 4 + control;
  }
  const Cluster& cluster = tree.cluster(p);
  const LobeWeights sides = lobes_towards(rotate_back(pose, towards), cluster.lobe_share);
  const bool itself = !(length2(towards) > 0);
  for (int i = 0; i < Cluster::kSamples; ++i) {
    const SurfaceSample& s = cluster.samples[i];
    float response = 0;
    const LobeWeights own = lobes_of_normal(s.normal);
    for (int l = 0; l < 3; ++l)
      if (own.lobe[l] == sides.lobe[l]) response += own.weight[l] * sides.weight[l];
    points[i] = {pose * s.position, rotate(pose, s.normal), itself ? 1 : response};
  }
  return Cluster::kSamples;
}

int emitter_parts(const NodeTree& tree, const Node& q, const Pose& pose, Vec3 towards, EmitterPart* parts) {
  if (!q.is_cluster()) {
    Quarter quarters[4];
    quarters_of(patch_points(tree, q), pose, quarters);
    const Vec3 normal = rotate(pose, q.normal);
    for (int j = 0; j < 4; ++j)
      parts[j] = {quarters[j].centre, normal, static_cast<float>(quarters[j].area),
                  static_cast<float>(quarters[j].area) / std::max(q.area, 1e-30f)};
    return 4;
  }
  ReceiverPoint points[kMostPoints];
  const int count = receiver_points(tree, q, pose, towards, 0, points);
  for (int j = 0; j < count; ++j)
    parts[j] = {points[j].position, points[j].normal, q.area / static_cast<float>(count),
                points[j].response / static_cast<float>(count)};
  return count;
}

// Unoccluded irradiance at a point from a part of unit radiance, as from a disk of its area (Wallace,
// Elmquist & Haines 1989). So it is never more than that of a full view, however close the part is.
double from_part(const ReceiverPoint& x, const EmitterPart& part) {
  const Vec3 to = part.position - x.position;
  const double distance2 = length2(to), cos_x = dot(to, x.normal), cos_y = -dot(to, part.normal);
  if (!(cos_x > 1e-6 * distance2) || !(cos_y > 1e-6 * distance2) || !(distance2 > 0)) return 0;
  return cos_x * cos_y * part.area / (distance2 * (distance2 + part.area / kPi));
}

}  // namespace

KernelEvaluator::Means KernelEvaluator::sample_clusters(const Node& p, const Node& q, uint64_t seed,
                                                        const std::vector<Pose>& poses, int control,
                                                        KernelCounts* counts) const {
  const Pose &pose_p = poses[p.body], &pose_q = poses[q.body];
  const Vec3 towards = pose_q * q.centre - pose_p * p.centre;
  ReceiverPoint points[kMostPoints];
  EmitterPart parts[kMostParts];
  const int point_count = receiver_points(tree_, p, pose_p, towards, control, points);
  const int part_count = emitter_parts(tree_, q, pose_q, -1 * towards, parts);
  double at_point[kMostPoints], shares[kMostParts] = {}, response = 0, free = 0;
  Means means;
  for (int i = 0; i < point_count; ++i) {
    double from[kMostParts], unoccluded = 0;
    for (int j = 0; j < part_count; ++j) {
      from[j] = from_part(points[i], parts[j]);
      unoccluded += from[j];
      shares[j] += from[j];
    }
    counts->evaluations += static_cast<uint64_t>(part_count);
    at_point[i] = 0;
    response += points[i].response / point_count;
    if (!(unoccluded > 1e-7)) continue;
    // The same pairs at every time sample, except those without exchange: visibility may change only with
    // what moves.
    double tested = 0, visible = 0;
    int rays = 0;
    const uint64_t h = hash_of(seed, static_cast<uint64_t>(i));
    for (int k = 0; k < part_count && rays < kRaysAPoint; ++k) {
      const int j = static_cast<int>((h + static_cast<uint64_t>(k) * 5) % static_cast<uint64_t>(part_count));
      if (!(from[j] > 0)) continue;
      ++rays;
      tested += from[j];
      if (!tracer_.occluded(poses, points[i].position + tracer_.offset() * points[i].normal,
                            parts[j].position + tracer_.offset() * parts[j].normal))
        visible += from[j];
    }
    counts->rays += static_cast<uint64_t>(rays);
    at_point[i] = tested > 0 ? unoccluded * visible / tested : 0;
    means.mean += at_point[i] / point_count;
    free += unoccluded;
  }
  if (!(free > 0)) return means;
  const double visible = std::clamp(means.mean * point_count / free, 0.05, 1.0);
  // A few samples do not cover the lobes of a cluster evenly. The mean response of a complete cover is 1, so
  // the mean over the samples gives the correction.
  double emitted = 0;
  for (int j = 0; j < part_count; ++j) emitted += parts[j].represented;
  for (const double sampled : {response, emitted})
    if (sampled > 0.05) {
      const double factor = std::min(1 / sampled, 2.0);
      means.mean *= factor;
      for (int i = 0; i < point_count; ++i) at_point[i] *= factor;
    }
  double error2 = 0;
  for (int i = 0; i < point_count; ++i) {
    const double represented = response > 0.05 ? means.mean * points[i].response / response : means.mean;
    error2 += (at_point[i] - represented) * (at_point[i] - represented) / point_count;
  }
  means.receiver_error = std::sqrt(error2);
  double uneven = 0;
  for (int j = 0; j < part_count; ++j) {
    const double d = shares[j] / free - (emitted > 0.05 ? parts[j].represented / emitted : 0);
    uneven += part_count * d * d;
  }
  // If visibility is partial, it is not known which parts are hidden.
  means.emitter_error = means.mean * std::sqrt(uneven + (1 - visible) / visible);
  return means;
}

KernelEvaluator::Means KernelEvaluator::sample(const Node& p, const Node& q, uint64_t seed,
                                               const std::vector<Pose>& poses, int control,
                                               KernelCounts* counts) const {
  return p.is_cluster() || q.is_cluster() ? sample_clusters(p, q, seed, poses, control, counts)
                                          : sample_patches(p, q, seed, poses, control, counts);
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
  for (int d = 0; d < kTimes; ++d)
    if (meet(swept_.poses(interval, static_cast<double>(d) / (kTimes - 1)))) return true;
  return false;
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
  const int control = p.area > 0.25 * q.area ? 9 : 5;
  if (!e.dynamic) {
    const Means means = sample(p, q, seed, middle, control, counts);
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
    const Means means = sample(p, q, seed, poses, 5, counts);
    e.kernel[k] = static_cast<float>(means.mean);
    worst(means);
  }
  // Control instants: both ends of the interval, and more between them the longer it is. None of them is a
  // Gauss node.
  const int times = interval.log2_cells >= 4 ? 8 : interval.log2_cells >= 2 ? 6 : 4;
  double error2 = 0;
  for (int d = 0; d < times; ++d) {
    const double s = static_cast<double>(d) / (times - 1);
    const std::vector<Pose> poses = swept_.poses(interval, s);
    Means means;
    if (can_exchange(p, q, poses)) means = sample(p, q, seed, poses, 5, counts);
    double weights[kMaxOrder], represented = 0;
    lagrange_weights(order, s, weights);
    for (int k = 0; k < order; ++k) represented += weights[k] * e.kernel[k];
    error2 += (means.mean - represented) * (means.mean - represented) / times;
    worst(means);
  }
  e.time_error = static_cast<float>(std::sqrt(error2));
  // If the kernel turns out constant, only relative motion of the ends makes the link dynamic.
  if (e.time_error <= 1e-6f * e.kernel[0] && std::all_of(e.kernel, e.kernel + order, [&](float k) {
        return std::abs(k - e.kernel[0]) <= 1e-6f * e.kernel[0];
      }))
    e.dynamic = relative_motion;
  return e;
}

}  // namespace strad
