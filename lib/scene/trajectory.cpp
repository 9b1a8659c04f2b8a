// Poses, lights and cameras at an instant.
#include "scene/trajectory.h"

#include "scene/body_pose.h"
#include "scene/key_place.h"

namespace strad {
namespace {

float lerp(float a, float b, double s) { return static_cast<float>((1 - s) * a + s * b); }
double lerp(double a, double b, double s) { return (1 - s) * a + s * b; }
Rgb lerp(Rgb a, Rgb b, double s) { return {lerp(a.r, b.r, s), lerp(a.g, b.g, s), lerp(a.b, b.b, s)}; }

SpotKey spot_key_at(const Spot& spot, double time) {
  const KeyPlace at = place_among(spot.keys, time);
  const SpotKey& a = spot.keys[at.key];
  if (!(at.u > 0)) return a;
  const SpotKey& b = spot.keys[at.key + 1];
  return {time, lerp(a.at, b.at, at.u), lerp(a.aim, b.aim, at.u), lerp(a.intensity, b.intensity, at.u)};
}

float glow_value_at(const Glow& glow, double time) {
  const KeyPlace at = place_among(glow.keys, time);
  const float a = glow.keys[at.key].value;
  return at.u > 0 ? lerp(a, glow.keys[at.key + 1].value, at.u) : a;
}

bool same_value(const SpotKey& a, const SpotKey& b) {
  return a.at == b.at && a.aim == b.aim && a.intensity == b.intensity;
}
bool same_value(const GlowKey& a, const GlowKey& b) { return a.value == b.value; }

// Appends the times within (start, end) at which two keys of unequal value stand at one time.
template <class Key, class Same>
void add_steps(const Scene& scene, const std::vector<Key>& keys, Same same, std::vector<double>& times) {
  for (size_t i = 1; i < keys.size(); ++i) {
    const double time = keys[i].time;
    if (!(time > scene.start && time < scene.end)) continue;
    if (keys[i - 1].time == time && !same(keys[i - 1], keys[i])) times.push_back(time);
  }
}

// Whether the body moves relative to its parent within [start, end]. A smooth curve also depends on one more
// key on each side, so it may move between equal keys.
bool moves_by_itself(const Scene& scene, const Body& body) {
  if (body.keys.empty()) return false;
  const size_t reach = body.ease == Ease::kSmooth ? 1 : 0;
  const KeyPlace at_start = place_among(body.keys, scene.start), at_end = place_among(body.keys, scene.end);
  const size_t first = at_start.key - std::min(at_start.key, reach);
  const size_t last = std::min(at_end.key + (at_end.u > 0 ? 1 : 0) + reach, body.keys.size() - 1);
  for (size_t i = first; i < last; ++i) {
    const bool step_outside =
        body.keys[i].time == body.keys[i + 1].time && (i < at_start.key || i >= at_end.key);
    if (!step_outside && !same_place(body, body.keys[i], body.keys[i + 1])) return true;
  }
  return false;
}

}  // namespace

std::vector<Pose> poses_at(const Scene& scene, double time) {
  std::vector<Pose> world_from_body;
  world_from_body.reserve(scene.bodies.size());
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Pose parent_from_body = pose_in_parent(body, time);
    // Parents come first; the world (0) and bodies on it need no product.
    world_from_body.push_back(body.parent == 0 ? parent_from_body
                                               : world_from_body[body.parent] * parent_from_body);
  }
  return world_from_body;
}

SpotState spot_at(const Scene&, const Spot& spot, const std::vector<Pose>& world_from_body, double time) {
  const SpotKey key = spot_key_at(spot, time);
  Vec3 direction = key.aim - key.at;
  // The aim may pass through the position of the light between two keys. Then the earlier key's direction
  // holds.
  if (!(length2(direction) > 0)) {
    const SpotKey& earlier = spot.keys[place_among(spot.keys, time).key];
    direction = earlier.aim - earlier.at;
  }
  const Pose& pose = world_from_body[spot.body];
  return {pose * key.at, normalized(rotate(pose, direction)), key.intensity};
}

std::vector<float> glow_at(const Scene& scene, double time) {
  std::vector<float> scale(scene.materials.size(), 1.0f);
  for (const Glow& glow : scene.glows) scale[glow.material] = glow_value_at(glow, time);
  return scale;
}

CameraState camera_at(const Camera& camera, double time) {
  const KeyPlace at = place_among(camera.keys, time);
  const CameraKey& a = camera.keys[at.key];
  if (!(at.u > 0)) return {a.from, a.to, a.up, a.fov};
  const CameraKey& b = camera.keys[at.key + 1];
  return {lerp(a.from, b.from, at.u), lerp(a.to, b.to, at.u), lerp(a.up, b.up, at.u),
          lerp(a.fov, b.fov, at.u)};
}

std::vector<double> step_times(const Scene& scene) {
  std::vector<double> times;
  for (const Body& body : scene.bodies)
    add_steps(
        scene, body.keys, [&](const BodyKey& a, const BodyKey& b) { return same_place(body, a, b); }, times);
  const auto same = [](const auto& a, const auto& b) { return same_value(a, b); };
  for (const Spot& spot : scene.spots) add_steps(scene, spot.keys, same, times);
  for (const Glow& glow : scene.glows) add_steps(scene, glow.keys, same, times);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<bool> moving_bodies(const Scene& scene) {
  std::vector<bool> moving(scene.bodies.size(), false);
  for (size_t i = 1; i < scene.bodies.size(); ++i)
    moving[i] = moving[scene.bodies[i].parent] || moves_by_itself(scene, scene.bodies[i]);
  return moving;
}

}  // namespace strad
