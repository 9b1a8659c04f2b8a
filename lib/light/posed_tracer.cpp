#include "light/posed_tracer.h"

#include <algorithm>
#include <cmath>

#include "scene/trajectory.h"

namespace strad {
namespace {

// With fewer, it is quicker to carry rays into them all.
constexpr size_t kFewBodies = 8;
// Bounds are as much larger, over the scene's diagonal, so that rounding to floats loses nothing: about 80
// units in the last place.
constexpr double kSlack = 1e-5;

Box posed(const Box& rest, const Pose& pose) {
  Box box;
  for (int corner = 0; corner < 8; ++corner)
    box.add(pose * Vec3{corner & 1 ? rest.upper.x : rest.lower.x, corner & 2 ? rest.upper.y : rest.lower.y,
                        corner & 4 ? rest.upper.z : rest.lower.z});
  return box;
}

// Finite also for rays along an axis, so that no product with it is undefined.
float inverse_of(double x) {
  constexpr double kLeast = 1e-25;
  return static_cast<float>(1 / (std::abs(x) > kLeast ? x : std::copysign(kLeast, x)));
}

}  // namespace

PosedTracer::PosedTracer(const Tracer& tracer, const Scene& scene, const std::vector<Pose>& world_from_body)
    : tracer_(tracer), world_from_body_(world_from_body) {
  const std::vector<bool> moves = moving_bodies(scene);
  for (uint32_t body = 0; body < moves.size(); ++body)
    if (moves[body] && !tracer.body_box(body).empty()) moving_.push_back(body);
  if (moving_.size() < kFewBodies) return;
  Box all = tracer.scene_box();
  std::vector<Box> boxes;
  for (const uint32_t body : moving_) {
    boxes.push_back(posed(tracer.body_box(body), world_from_body[body]));
    all.add(boxes.back());
  }
  double far = all.diagonal();
  for (int axis = 0; axis < 3; ++axis)  // floats are coarser far from the origin
    far = std::max({far, std::abs(all.lower[axis]), std::abs(all.upper[axis])});
  for (const Box& box : boxes) {
    for (size_t axis = 0; axis < 3; ++axis) {
      bounds_[axis].push_back(static_cast<float>(box.lower[static_cast<int>(axis)] - kSlack * far));
      bounds_[3 + axis].push_back(static_cast<float>(box.upper[static_cast<int>(axis)] + kSlack * far));
    }
  }
}

// Slabs of three axes (Kay & Kajiya 1986).
void PosedTracer::find(Vec3 from, Vec3 direction, double reach, std::vector<bool>* bodies) const {
  const float x = static_cast<float>(from.x), y = static_cast<float>(from.y), z = static_cast<float>(from.z);
  const float u = inverse_of(direction.x), v = inverse_of(direction.y), w = inverse_of(direction.z);
  const auto most = static_cast<float>(reach);
  // One part in 10^5 longer and shorter: what rounding of the quotients may take.
  constexpr float kMore = 1 + 1e-5f;
  const size_t count = moving_.size();
  thread_local std::vector<uint8_t> met;
  met.resize(count);
  const float *lx = bounds_[0].data(), *ly = bounds_[1].data(), *lz = bounds_[2].data();
  const float *hx = bounds_[3].data(), *hy = bounds_[4].data(), *hz = bounds_[5].data();
  uint8_t* out = met.data();
  for (size_t i = 0; i < count; ++i) {
    const float x0 = (lx[i] - x) * u, x1 = (hx[i] - x) * u;
    const float y0 = (ly[i] - y) * v, y1 = (hy[i] - y) * v;
    const float z0 = (lz[i] - z) * w, z1 = (hz[i] - z) * w;
    const float near =
        std::max(std::max(std::min(x0, x1), std::min(y0, y1)), std::max(std::min(z0, z1), 0.0f));
    const float far =
        std::min(std::min(std::max(x0, x1), std::max(y0, y1)), std::min(std::max(z0, z1), most));
    out[i] = near <= far * kMore;
  }
  for (size_t i = 0; i < count; ++i)
    if (out[i]) (*bodies)[moving_[i]] = true;
}

bool PosedTracer::occluded(Vec3 from, Vec3 to, Rgb* passed) const {
  if (moving_.size() < kFewBodies) return tracer_.occluded(world_from_body_, from, to, passed);
  thread_local std::vector<bool> bodies;
  bodies.assign(world_from_body_.size(), false);
  bodies[0] = true;  // all that rests
  find(from, to - from, 1, &bodies);
  return tracer_.occluded_by(world_from_body_, bodies, from, to, passed);
}

SurfaceHit PosedTracer::closest(Vec3 from, Vec3 direction) const {
  constexpr double kReach = 1e30;
  if (moving_.size() < kFewBodies) return tracer_.closest(world_from_body_, from, direction, kReach);
  thread_local std::vector<bool> bodies;
  bodies.assign(world_from_body_.size(), false);
  bodies[0] = true;
  find(from, direction, kReach, &bodies);
  return tracer_.closest_of(world_from_body_, bodies, from, direction, kReach);
}

}  // namespace strad
