#include "import/gltf/moving.h"

#include <algorithm>
#include <cmath>

#include "import/gltf/sampler.h"
#include "import/poses/few_keys.h"
#include "import/poses/pose_distance.h"
#include "scene/body_pose.h"

namespace strad {
namespace {

GltfTransform transform_of(Vec3 translation, Quat rotation, Vec3 scale) {
  return {scale.x * rotate(rotation, {1, 0, 0}), scale.y * rotate(rotation, {0, 1, 0}),
          scale.z * rotate(rotation, {0, 0, 1}), translation};
}

// The rotation of a similarity; of one that mirrors, that of its opposite, which turns things the same way.
Quat rotation_of(const GltfTransform& transform) {
  const double sign = transform.mirrors() ? -1 : 1;
  const Vec3 x = sign * normalized(transform.x), y = sign * normalized(transform.y),
             z = sign * normalized(transform.z);
  // Shepperd 1978: by the largest of the four components.
  const double trace = x.x + y.y + z.z;
  if (trace > 0) {
    const double s = 2 * std::sqrt(trace + 1);
    return {s / 4, (y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s};
  }
  if (x.x >= y.y && x.x >= z.z) {
    const double s = 2 * std::sqrt(1 + x.x - y.y - z.z);
    return {(y.z - z.y) / s, s / 4, (y.x + x.y) / s, (z.x + x.z) / s};
  }
  if (y.y >= z.z) {
    const double s = 2 * std::sqrt(1 + y.y - x.x - z.z);
    return {(z.x - x.z) / s, (y.x + x.y) / s, s / 4, (z.y + y.z) / s};
  }
  const double s = 2 * std::sqrt(1 + z.z - x.x - y.y);
  return {(x.y - y.x) / s, (z.x + x.z) / s, (z.y + y.z) / s, s / 4};
}

class BodyMaker {
 public:
  BodyMaker(const GltfMotion& motion, const GltfNode& node, const GltfTransform& parent, const Box& bounds,
            double tolerance)
      : motion_(motion), node_(node), parent_(parent), bounds_(bounds), tolerance_(tolerance) {
    if (motion.rotation) turn_ = rotation_of(parent);
    rest_at_ = translation(0, Side::kFrom);
    rest_rotation_ = rotation(0, Side::kFrom);
    body_.pivot = parent.point(rest_at_);
  }
  Body make();

 private:
  Vec3 translation(double time, Side side) const {
    return motion_.translation ? vector_at(*motion_.translation, time, side) : node_.translation;
  }
  Quat rotation(double time, Side side) const {
    return motion_.rotation ? rotation_at(*motion_.rotation, time, side) : node_.rotation;
  }
  BodyKey key_at(double time, Side side) const;
  bool is_curved() const {
    return (motion_.translation && motion_.translation->interpolation == GltfInterpolation::kCubicSpline) ||
           (motion_.rotation && motion_.rotation->interpolation == GltfInterpolation::kCubicSpline);
  }
  Pose pose_between(const BodyKey& a, const BodyKey& b, double time);
  double distance_between(const BodyKey& a, const BodyKey& b);
  double error_between(const BodyKey& a, const BodyKey& b, const BodyKey& key);
  void divide(const BodyKey& a, const BodyKey& b, int depth, std::vector<BodyKey>* run);
  void finish_run(std::vector<BodyKey>* run);

  const GltfMotion& motion_;
  const GltfNode& node_;
  const GltfTransform& parent_;
  const Box& bounds_;
  double tolerance_;
  Quat turn_;  // world from the parent node's axes
  Vec3 rest_at_;
  Quat rest_rotation_;
  Body body_, probe_;
};

BodyKey BodyMaker::key_at(double time, Side side) const {
  BodyKey key;
  key.time = time;
  key.move = parent_.direction(translation(time, side) - rest_at_);
  if (!motion_.rotation) return key;
  key.has_quat = true;
  const Quat q = turn_ * (rotation(time, side) * conjugate(rest_rotation_)) * conjugate(turn_);
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  key.quat = {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
  return key;
}

Pose BodyMaker::pose_between(const BodyKey& a, const BodyKey& b, double time) {
  probe_.pivot = body_.pivot;
  probe_.keys = {a, b};
  return pose_in_parent(probe_, time);
}

double BodyMaker::distance_between(const BodyKey& a, const BodyKey& b) {
  return pose_distance(pose_between(a, a, a.time), pose_between(b, b, b.time), bounds_);
}

// How far a key is from the straight way between two others.
double BodyMaker::error_between(const BodyKey& a, const BodyKey& b, const BodyKey& key) {
  return pose_distance(pose_between(a, b, key.time), pose_between(key, key, key.time), bounds_);
}

// Appends keys between a and b, then b, such that straight ways between them follow a curve.
void BodyMaker::divide(const BodyKey& a, const BodyKey& b, int depth, std::vector<BodyKey>* run) {
  constexpr int kDeepest = 12;
  bool straight = depth == kDeepest || !is_curved();
  if (!straight && depth > 0) {
    straight = true;
    for (const double u : {0.25, 0.5, 0.75})
      straight = straight &&
                 error_between(a, b, key_at(a.time + u * (b.time - a.time), Side::kFrom)) <= 0.3 * tolerance_;
  }
  if (!straight) {
    const BodyKey middle = key_at((a.time + b.time) / 2, Side::kFrom);
    divide(a, middle, depth + 1, run);
    return divide(middle, b, depth + 1, run);
  }
  run->push_back(b);
}

// Takes the keys of a stretch without steps that are needed.
void BodyMaker::finish_run(std::vector<BodyKey>* run) {
  const auto follows = [&](const BodyKey& a, const BodyKey& b, const BodyKey& key) {
    return error_between(a, b, key) <= 0.6 * tolerance_;
  };
  // What rests at the end of a run must keep its last key there: a step may follow.
  const auto never = [](const BodyKey&, const BodyKey&) { return false; };
  for (const BodyKey& key : few_keys(*run, follows, never)) body_.keys.push_back(key);
  run->clear();
}

Body BodyMaker::make() {
  std::vector<double> times;
  for (const GltfChannel* channel : {motion_.translation, motion_.rotation})
    if (channel) times.insert(times.end(), channel->times.begin(), channel->times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<BodyKey> run{key_at(times[0], Side::kFrom)};
  for (size_t i = 1; i < times.size(); ++i) {
    divide(run.back(), key_at(times[i], Side::kBefore), 0, &run);
    const BodyKey from = key_at(times[i], Side::kFrom);
    if (distance_between(run.back(), from) <= 0.01 * tolerance_) continue;
    finish_run(&run);  // a step
    run = {from};
  }
  finish_run(&run);
  while (body_.keys.size() > 1 &&
         same_place(body_, body_.keys[body_.keys.size() - 1], body_.keys[body_.keys.size() - 2]))
    body_.keys.pop_back();
  return std::move(body_);
}

}  // namespace

GltfTransform operator*(const GltfTransform& a, const GltfTransform& b) {
  return {a.direction(b.x), a.direction(b.y), a.direction(b.z), a.point(b.origin)};
}

GltfTransform rest_transform(const GltfNode& node, const GltfMotion& motion) {
  if (node.matrix) {
    const auto& m = *node.matrix;
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
  }
  return transform_of(motion.translation ? vector_at(*motion.translation, 0, Side::kFrom) : node.translation,
                      motion.rotation ? rotation_at(*motion.rotation, 0, Side::kFrom) : node.rotation,
                      motion.scale ? vector_at(*motion.scale, 0, Side::kFrom) : node.scale);
}

bool is_similarity(const GltfTransform& t) {
  const double xx = length2(t.x), yy = length2(t.y), zz = length2(t.z);
  const double slack = 1e-6 * std::max({xx, yy, zz});
  return xx > 0 && std::abs(xx - yy) <= slack && std::abs(xx - zz) <= slack &&
         std::abs(dot(t.x, t.y)) <= slack && std::abs(dot(t.x, t.z)) <= slack &&
         std::abs(dot(t.y, t.z)) <= slack;
}

Body moving_body(const GltfMotion& motion, const GltfNode& node, const GltfTransform& parent,
                 const Box& bounds, double tolerance) {
  return BodyMaker(motion, node, parent, bounds, tolerance).make();
}

}  // namespace strad
