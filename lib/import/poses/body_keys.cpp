#include "import/poses/body_keys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/poses/few_keys.h"
#include "import/poses/few_scene_keys.h"
#include "import/poses/pivot.h"
#include "import/poses/pose_distance.h"
#include "scene/body_pose.h"

namespace strad {
namespace {

// Numbers are rounded to this part of the body's size, far below any tolerance, so that 3 is not
// 2.9999999999999996.
constexpr double kRounding = 1e-12;

// The largest power of ten that is not above `value`.
double decimal_unit(double value) { return std::pow(10, std::floor(std::log10(value))); }

// `value` as a decimal number with no digits below `unit`, a power of ten.
double rounded_decimal(double value, double unit) {
  const double scaled = std::round(value / unit);
  if (!(std::abs(scaled) < 9e15)) return value;
  // Whole powers of ten are exact: the quotient is the double nearest to the decimal number.
  return unit < 1 ? scaled / std::round(1 / unit) : scaled * unit;
}

Vec3 rounded_decimal(Vec3 v, double unit) {
  return {rounded_decimal(v.x, unit), rounded_decimal(v.y, unit), rounded_decimal(v.z, unit)};
}

// To a decimal number of degrees.
double rounded_angle(double radians) { return rounded_decimal(radians / kDegree, 1e-10) * kDegree; }

Vec3 imaginary(Quat q) { return {q.x, q.y, q.z}; }
Quat negated(Quat q) { return {-q.w, -q.x, -q.y, -q.z}; }
double dot(Quat a, Quat b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }

// Builds the keys of one body.
class KeyBuilder {
 public:
  KeyBuilder(std::span<const Pose> poses, std::span<const double> times, const Moved& moved)
      : poses_(poses.begin(), poses.end()), times_(times), moved_(moved) {
    // Of the two quaternions of a rotation, the one nearer to that of the frame before.
    for (size_t i = 1; i < poses_.size(); ++i)
      if (dot(poses_[i].rotation, poses_[i - 1].rotation) < 0)
        poses_[i].rotation = negated(poses_[i].rotation);
    unit_ = decimal_unit(std::max(moved.bounds.diagonal(), 1e-30)) * kRounding;
    body_.pivot = rounded_decimal(pivot_of(poses_, moved.bounds.centre()), unit_);
    turns_ = find_axis();
    for (size_t i = 0; i < poses_.size(); ++i) all_.push_back(key_of(i));
  }

  Body build() {
    Body linear = body_, smooth = body_;
    linear.keys = linear_keys();
    if (all_.size() < 4 || linear.keys.size() <= 3) return linear;
    smooth.ease = Ease::kSmooth;
    smooth.keys = smooth_keys();
    return !smooth.keys.empty() && smooth.keys.size() < linear.keys.size() ? smooth : linear;
  }

 private:
  bool find_axis();
  BodyKey key_of(size_t frame) const;
  double error_at(const Body& body, size_t frame) const {
    return pose_distance(pose_in_parent(body, times_[frame]), poses_[frame], moved_.bounds);
  }
  std::vector<BodyKey> linear_keys();
  std::vector<BodyKey> smooth_keys();
  bool straight(size_t first, size_t last);
  BodyKey beyond(size_t first, size_t step_sign, double time) const;
  std::vector<BodyKey> picked(const std::vector<bool>& kept) const;
  size_t worst_frame(const Body& body, size_t first, size_t last) const;

  std::vector<Pose> poses_;
  std::span<const double> times_;
  const Moved& moved_;
  double unit_ = 0;
  Body body_;          // without keys
  bool turns_ = true;  // all rotations are turns about body_.axis
  std::vector<double> angles_;
  std::vector<BodyKey> all_;  // one a frame
};

// Whether all rotations are about one axis, which becomes the body's; then sets the angles.
bool KeyBuilder::find_axis() {
  Vec3 axis{0, 1, 0};
  double most = 0;
  for (const Pose& pose : poses_) {
    const Vec3 v = imaginary(pose.rotation);
    if (length2(v) > most) most = length2(v), axis = normalized(v);
  }
  // An axis along one of the coordinates is that, not 1e-17 beside it; it points along the larger part.
  for (int i = 0; i < 3; ++i)
    if (std::abs(axis[i]) < 1e-11) axis[i] = 0;
  axis = normalized(axis);
  const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  for (int i = 0; i < 3; ++i)
    if (std::abs(axis[i]) == largest) {
      if (axis[i] < 0) axis = -axis;
      break;
    }
  axis = {axis.x + 0.0, axis.y + 0.0, axis.z + 0.0};  // no -0
  double last = 0;
  for (const Pose& pose : poses_) {
    double angle = 2 * std::atan2(strad::dot(imaginary(pose.rotation), axis), pose.rotation.w);
    angle += 2 * kPi * std::round((last - angle) / (2 * kPi));
    angle = rounded_angle(angle);
    const Pose turned{rotation_about(axis, angle), {}}, given{pose.rotation, {}};
    Box about;  // the turn's own error, wherever the body is
    about.add(moved_.bounds.lower - moved_.bounds.centre());
    about.add(moved_.bounds.upper - moved_.bounds.centre());
    if (!(pose_distance(turned, given, about) <= 1e-2 * moved_.tolerance)) return false;
    angles_.push_back(angle);
    last = angle;
  }
  body_.axis = axis;
  return true;
}

BodyKey KeyBuilder::key_of(size_t frame) const {
  BodyKey key;
  key.time = times_[frame];
  if (turns_) {
    key.turn = angles_[frame];
  } else {
    key.has_quat = true;
    key.quat = poses_[frame].rotation;
  }
  key.move = rounded_decimal(poses_[frame] * body_.pivot - body_.pivot, unit_);
  key.move = {key.move.x + 0.0, key.move.y + 0.0, key.move.z + 0.0};
  return key;
}

// Whether the frames between two keys are on the straight way between them.
bool KeyBuilder::straight(size_t first, size_t last) {
  body_.keys = {all_[first], all_[last]};
  bool is_straight = true;
  // From the middle, where the error is often largest.
  const size_t count = last - first - 1;
  for (size_t i = 0; i < count && is_straight; ++i)
    is_straight = error_at(body_, first + 1 + (i + count / 2) % count) <= moved_.tolerance;
  body_.keys.clear();
  return is_straight;
}

std::vector<BodyKey> KeyBuilder::linear_keys() {
  std::vector<BodyKey> keys;
  for (const size_t i : few_indices(all_.size(), [&](size_t a, size_t b) { return straight(a, b); }))
    keys.push_back(all_[i]);
  // At rest up to the end: the last value holds by itself.
  while (keys.size() > 1 && same_place(body_, keys[keys.size() - 1], keys[keys.size() - 2])) keys.pop_back();
  return keys;
}

// A key one frame before the first or after the last, where the motion would come from or go to: the cubic
// through four frames, continued. Smooth easing stops at its first and last key.
BodyKey KeyBuilder::beyond(size_t first, size_t step, double time) const {
  const auto at = [&](size_t i) -> const BodyKey& { return all_[first + i * step]; };
  BodyKey key = all_[first];
  key.time = time;
  key.move = rounded_decimal(4 * at(0).move - 6 * at(1).move + 4 * at(2).move - at(3).move, unit_);
  if (turns_) {
    key.turn = rounded_angle(4 * at(0).turn - 6 * at(1).turn + 4 * at(2).turn - at(3).turn);
  } else {
    Vec3 steps[3];  // rotation vectors from each frame to the next
    for (size_t i = 0; i < 3; ++i) {
      const Quat q = conjugate(at(i).quat) * at(i + 1).quat;
      const double sine = length(imaginary(q));
      steps[i] = sine > 0 ? 2 * std::atan2(sine, q.w) / sine * imaginary(q) : Vec3{};
    }
    const Vec3 back = 3 * steps[1] - 3 * steps[0] - steps[2];
    const double angle = length(back);
    if (angle > 0) key.quat = key.quat * rotation_about(back / angle, angle);
  }
  return key;
}

std::vector<BodyKey> KeyBuilder::picked(const std::vector<bool>& kept) const {
  const size_t count = all_.size();
  std::vector<BodyKey> keys{beyond(0, 1, 2 * times_[0] - times_[1])};
  for (size_t i = 0; i < count; ++i)
    if (kept[i]) keys.push_back(all_[i]);
  keys.push_back(beyond(count - 1, ~size_t{0}, 2 * times_[count - 1] - times_[count - 2]));
  return keys;
}

// The frame with the largest error strictly between two, or `last` if none is above the tolerance.
size_t KeyBuilder::worst_frame(const Body& body, size_t first, size_t last) const {
  double worst = moved_.tolerance;
  size_t at = last;
  for (size_t i = first + 1; i < last; ++i)
    if (const double error = error_at(body, i); error > worst) worst = error, at = i;
  return at;
}

// Keys are added where the error is largest, until none is above the tolerance. Empty where that takes most
// of the frames: then straight ways serve as well.
std::vector<BodyKey> KeyBuilder::smooth_keys() {
  const size_t count = all_.size();
  Body body = body_;
  body.ease = Ease::kSmooth;
  std::vector<bool> kept(count, false);
  kept.front() = kept[1] = kept[count - 2] = kept.back() = true;
  for (bool done = false; !done;) {
    body.keys = picked(kept);
    done = true;
    for (size_t first = 0, last = 1; last < count; ++last) {
      if (!kept[last]) continue;
      if (const size_t at = worst_frame(body, first, last); at < last) {
        kept[at] = true;
        done = false;
      }
      first = last;
    }
  }
  return body.keys;
}

}  // namespace

Body body_with_keys(std::span<const Pose> poses, std::span<const double> times, const Moved& moved) {
  return KeyBuilder(poses, times, moved).build();
}

// They moved alike to within kAlike of their sizes, a tenth of what the keys may differ.
Body body_of_group(const PoseFollower& follower, size_t group, std::span<const double> times) {
  const PoseFollower::Group& moved = follower.groups()[group];
  Moved what;
  double smallest = 0;
  for (const uint32_t piece : moved.pieces) {
    for (const Vec3 p : follower.rest_of(piece)) what.bounds.add(p);
    const double size = follower.size_of(piece);
    if (size > 0 && (smallest == 0 || size < smallest)) smallest = size;
  }
  what.tolerance = (kKeyTolerance - kAlike) * smallest + 4 * follower.precision();
  return body_with_keys(moved.poses, times, what);
}

}  // namespace strad
