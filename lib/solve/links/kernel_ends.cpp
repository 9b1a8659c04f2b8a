#include "solve/links/kernel_ends.h"

namespace strad {
namespace {

int points_of_patch(const NodeTree& tree, const Node& p, const Pose& pose, int control,
                    ReceiverPoint* points) {
  const PatchPoints patch = patch_points(tree, p);
  const Vec3 normal = rotate(pose, p.normal);
  const int count = kQuadraturePoints + control;
  for (int i = 0; i < count; ++i) {
    const PatchUv uv = sample_uv(i);
    points[i] = {pose * point_on_patch(patch, uv.u, uv.v), normal, 1};
  }
  return count;
}

int points_of_cluster(const NodeTree& tree, const Node& p, const Pose& pose, Vec3 towards,
                      ReceiverPoint* points) {
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

}  // namespace

int receiver_points(const NodeTree& tree, const Node& receiver, const Pose& pose, Vec3 towards, int control,
                    ReceiverPoint* points) {
  return receiver.is_cluster() ? points_of_cluster(tree, receiver, pose, towards, points)
                               : points_of_patch(tree, receiver, pose, control, points);
}

int emitter_parts(const NodeTree& tree, const Node& emitter, const Pose& pose, Vec3 towards,
                  EmitterPart* parts) {
  if (emitter.is_cluster()) {
    ReceiverPoint points[kMostPoints];
    const int count = points_of_cluster(tree, emitter, pose, towards, points);
    for (int j = 0; j < count; ++j)
      parts[j] = {points[j].position, points[j].normal, emitter.area / static_cast<float>(count),
                  points[j].response / static_cast<float>(count)};
    return count;
  }
  Quarter quarters[4];
  quarters_of(patch_points(tree, emitter), pose, quarters);
  const Vec3 normal = rotate(pose, emitter.normal);
  for (int j = 0; j < 4; ++j)
    parts[j] = {quarters[j].centre, normal, static_cast<float>(quarters[j].area),
                static_cast<float>(quarters[j].area) / std::max(emitter.area, 1e-30f)};
  return 4;
}

double unoccluded_irradiance(const ReceiverPoint& x, const EmitterPart& part) {
  const Vec3 to = part.position - x.position;
  const double distance2 = length2(to), cos_x = dot(to, x.normal), cos_y = -dot(to, part.normal);
  if (!(cos_x > 1e-6 * distance2) || !(cos_y > 1e-6 * distance2) || !(distance2 > 0)) return 0;
  return cos_x * cos_y * part.area / (distance2 * (distance2 + part.area / kPi));
}

}  // namespace strad
