#include "import/poses/few_scene_keys.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "import/poses/few_keys.h"
#include "scene/motion_print.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

double largest_difference(Rgb a, Rgb b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

}  // namespace

Box box_of(const Scene& scene) {
  Box box;
  for (const Vec3 vertex : scene.vertices) box.add(vertex);
  return box;
}

std::vector<SpotKey> few_spot_keys(const std::vector<SpotKey>& all, double size) {
  float brightest = 0;
  for (const SpotKey& key : all) brightest = std::max(brightest, max_channel(key.intensity));
  const auto follows = [&](const SpotKey& a, const SpotKey& b, const SpotKey& key) {
    const double u = (key.time - a.time) / (b.time - a.time);
    const Vec3 at = lerp(a.at, b.at, u), aim = lerp(a.aim, b.aim, u);
    const Rgb intensity = static_cast<float>(1 - u) * a.intensity + static_cast<float>(u) * b.intensity;
    return length(at - key.at) <= kKeyTolerance * size &&
           angle_between(aim - at, key.aim - key.at) <= kKeyTolerance &&
           largest_difference(intensity, key.intensity) <= kKeyTolerance * brightest;
  };
  return few_keys(all, follows, [](const SpotKey& a, const SpotKey& b) {
    return a.at == b.at && a.aim == b.aim && a.intensity == b.intensity;
  });
}

std::vector<GlowKey> few_glow_keys(const std::vector<GlowKey>& all) {
  float largest = 0;
  for (const GlowKey& key : all) largest = std::max(largest, key.value);
  const auto follows = [&](const GlowKey& a, const GlowKey& b, const GlowKey& key) {
    const double u = (key.time - a.time) / (b.time - a.time);
    return std::abs((1 - u) * a.value + u * b.value - key.value) <= kKeyTolerance * largest;
  };
  return few_keys(all, follows, [](const GlowKey& a, const GlowKey& b) { return a.value == b.value; });
}

std::vector<CameraKey> few_camera_keys(const std::vector<CameraKey>& all, double size) {
  const auto follows = [&](const CameraKey& a, const CameraKey& b, const CameraKey& key) {
    const CameraState now = camera_at({"", {a, b}}, key.time);
    const Vec3 view = now.to - now.from, given = key.to - key.from;
    return length(now.from - key.from) <= kKeyTolerance * size &&
           angle_between(view, given) <= kKeyTolerance &&
           angle_between(cross(view, now.up), cross(given, key.up)) <= kKeyTolerance &&
           std::abs(now.fov - key.fov) <= kKeyTolerance;
  };
  return few_keys(all, follows, [](const CameraKey& a, const CameraKey& b) {
    return a.from == b.from && a.to == b.to && a.up == b.up && a.fov == b.fov;
  });
}

void name_bodies(Scene* scene) {
  std::set<std::string> taken;
  for (const Body& body : scene->bodies) taken.insert(body.name);
  for (const Object& object : scene->objects) {
    if (object.body == 0) continue;
    Body& body = scene->bodies[object.body];
    body.parts.push_back(pattern_of(object.name));
    if (!body.name.empty()) continue;
    body.name = object.name;
    for (int number = 2; !taken.insert(body.name).second; ++number)
      body.name = object.name + "_" + std::to_string(number);
  }
  for (Body& body : scene->bodies) {
    if (!body.name.empty()) continue;
    body.name = "carrier";
    for (int number = 2; !taken.insert(body.name).second; ++number)
      body.name = "carrier_" + std::to_string(number);
  }
}

}  // namespace strad
