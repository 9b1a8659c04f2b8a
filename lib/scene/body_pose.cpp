// A rigid body's own motion: the pose in its parent's frame, interpolated between keys.
#include "scene/body_pose.h"

#include <array>

#include "scene/key_place.h"

namespace strad {
namespace {

Quat rotation_of(const Body& body, const BodyKey& key) {
  return key.has_quat ? key.quat : rotation_about(body.axis, key.turn);
}

// Rotation vectors: the axis times the angle in radians. With them, moving at constant speed along the
// shorter way is slerp (Shoemake 1985).
Quat exp_of(Vec3 vector) {
  const double angle = length(vector);
  if (!(angle > 0)) return {};
  return rotation_about(vector / angle, angle);
}

// The rotation vector of `q` that is nearest to `expected`. It is unique only up to whole turns.
Vec3 log_near(Quat q, Vec3 expected) {
  const Vec3 imaginary{q.x, q.y, q.z};
  const double sine = length(imaginary);
  // Below this the axis is lost to rounding. The rotation is then a whole number of turns about the expected
  // axis.
  const bool axis_known = sine > 1e-12;
  const Vec3 axis = axis_known ? imaginary / sine : normalized(expected);
  const double angle = 2 * std::atan2(sine, q.w);
  const double turns = std::round((dot(expected, axis) - angle) / (2 * kPi));
  return (angle + 2 * kPi * turns) * axis;
}

// Rotation vector from key i to key i + 1; it is the same in the frames of both. Between two turns it is the
// difference of their angles, so that 0 to 720 degrees turns twice. With a quaternion it is the shorter way.
Vec3 rotation_step(const Body& body, size_t i) {
  const BodyKey &a = body.keys[i], &b = body.keys[i + 1];
  if (!a.has_quat && !b.has_quat) return (b.turn - a.turn) * body.axis;
  return log_near(conjugate(rotation_of(body, a)) * rotation_of(body, b), {});
}

Vec3 move_step(const Body& body, size_t i) { return body.keys[i + 1].move - body.keys[i].move; }

// Velocity at key i of the non-uniform Catmull-Rom curve with the given steps between keys (Barry & Goldman
// 1988). Zero where the value is held or jumps: at the first and the last key and on both sides of a step.
template <class StepBetween>
Vec3 velocity_at_key(const Body& body, size_t i, StepBetween step_between) {
  if (i == 0 || i + 1 == body.keys.size()) return {};
  const double before = body.keys[i].time - body.keys[i - 1].time;
  const double after = body.keys[i + 1].time - body.keys[i].time;
  if (!(before > 0 && after > 0)) return {};
  const Vec3 slope_before = step_between(body, i - 1) / before, slope_after = step_between(body, i) / after;
  return (after * slope_before + before * slope_after) / (before + after);
}

// Cumulative cubic Bernstein polynomials: the fraction of each of the three legs of a Bezier curve that is
// done at u.
std::array<double, 3> bezier_legs(double u) {
  const double v = 1 - u;
  return {1 - v * v * v, u * u * (3 - 2 * u), u * u * u};
}

Vec3 smooth_move(const Body& body, const KeyPlace& at) {
  const Vec3 first = velocity_at_key(body, at.key, move_step) * (at.span / 3);
  const Vec3 last = velocity_at_key(body, at.key + 1, move_step) * (at.span / 3);
  const Vec3 middle = move_step(body, at.key) - first - last;
  const auto legs = bezier_legs(at.u);
  return body.keys[at.key].move + legs[0] * first + legs[1] * middle + legs[2] * last;
}

// Hermite quaternion curve of Kim, Kim & Shin 1995: a Bezier curve whose legs are rotations. If all keys
// are turns about the axis it is the cubic Hermite curve of the angle.
Quat smooth_rotation(const Body& body, const KeyPlace& at) {
  const Vec3 first = velocity_at_key(body, at.key, rotation_step) * (at.span / 3);
  const Vec3 last = velocity_at_key(body, at.key + 1, rotation_step) * (at.span / 3);
  const Vec3 whole = rotation_step(body, at.key);
  const Vec3 middle = log_near(exp_of(-first) * exp_of(whole) * exp_of(-last), whole - first - last);
  const auto legs = bezier_legs(at.u);
  return rotation_of(body, body.keys[at.key]) * exp_of(legs[0] * first) * exp_of(legs[1] * middle) *
         exp_of(legs[2] * last);
}

}  // namespace

Pose pose_in_parent(const Body& body, double time) {
  if (body.keys.empty()) return {};
  const KeyPlace at = place_among(body.keys, time);
  Quat rotation = rotation_of(body, body.keys[at.key]);
  Vec3 move = body.keys[at.key].move;
  if (at.u > 0 && body.ease == Ease::kLinear) {
    rotation = rotation * exp_of(at.u * rotation_step(body, at.key));
    move = move + at.u * move_step(body, at.key);
  } else if (at.u > 0) {
    rotation = smooth_rotation(body, at);
    move = smooth_move(body, at);
  }
  // In this order the translation of a body that does not turn is exactly its move.
  return {rotation, move + (body.pivot - rotate(rotation, body.pivot))};
}

bool same_place(const Body& body, const BodyKey& a, const BodyKey& b) {
  if (!(a.move == b.move)) return false;
  if (!a.has_quat && !b.has_quat) return a.turn == b.turn;
  const Quat p = rotation_of(body, a), q = rotation_of(body, b);
  return p == q || p == Quat{-q.w, -q.x, -q.y, -q.z};
}

}  // namespace strad
