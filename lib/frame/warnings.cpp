#include "frame/warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "frame/camera.h"
#include "light/tracer.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

constexpr int kInstants = 24;

std::string seconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", time);
  return text;
}

struct ObjectBox {
  Box box;  // rest
  std::vector<uint32_t> polygons;
};

class Warnings {
 public:
  explicit Warnings(const Scene& scene)
      : scene_(scene), objects_(scene.objects.size()), bodies_(scene.bodies.size()) {
    for (uint32_t i = 0; i < scene.polygons.size(); ++i) {
      const Polygon& polygon = scene.polygons[i];
      objects_[polygon.object].polygons.push_back(i);
      for (int k = 0; k < polygon.corner_count(); ++k) {
        const Vec3 corner = scene.vertices[polygon.corners[k]];
        objects_[polygon.object].box.add(corner);
        bodies_[body_of(scene, polygon)].add(corner);
        all_.add(corner);
      }
    }
    const int count = scene.end > scene.start ? kInstants : 1;
    for (int k = 0; k < count; ++k) {
      times_.push_back(scene.start + (scene.end - scene.start) * k / std::max(1, count - 1));
      poses_.push_back(poses_at(scene, times_.back()));
    }
  }

  std::vector<std::string> lines() {
    light();
    keys();
    spots();
    cameras();
    bodies();
    return std::move(lines_);
  }

 private:
  void light() {
    bool any = false;
    for (const Spot& spot : scene_.spots)
      for (const SpotKey& key : spot.keys) any = any || !is_black(key.intensity);
    for (const Polygon& polygon : scene_.polygons) any = any || emits(scene_, polygon);
    if (!any) lines_.push_back("the scene has no light: no material emits and there is no spotlight");
  }

  template <typename Keys>
  void late(const std::string& what, const Keys& keys) {
    const auto after =
        std::count_if(keys.begin(), keys.end(), [&](const auto& key) { return key.time > scene_.end; });
    if (after == 0 || scene_.end == scene_.start) return;
    lines_.push_back(what + " has " + std::to_string(after) + (after == 1 ? " key" : " keys") +
                     " after the end, " + seconds(scene_.end) + ": the last is at " +
                     seconds(keys.back().time));
  }
  void keys() {
    for (const Body& body : scene_.bodies) late("body " + body.name, body.keys);
    for (const Spot& spot : scene_.spots) late("spot " + spot.name, spot.keys);
    for (const Glow& glow : scene_.glows) late("glow " + scene_.materials[glow.material].name, glow.keys);
    for (const Camera& camera : scene_.cameras) late("camera " + camera.name, camera.keys);
  }

  // How often a ray from `from` crosses an object's polygons (Moller & Trumbore 1997). All in rest
  // coordinates.
  int crossings(const ObjectBox& object, Vec3 from, Vec3 direction) const {
    int count = 0;
    for (const uint32_t index : object.polygons) {
      const Polygon& polygon = scene_.polygons[index];
      for (int k = 2; k < polygon.corner_count(); ++k) {
        const Vec3 a = scene_.vertices[polygon.corners[0]], u = scene_.vertices[polygon.corners[k - 1]] - a,
                   v = scene_.vertices[polygon.corners[k]] - a;
        const Vec3 p = cross(direction, v), t = from - a, q = cross(t, u);
        const double determinant = dot(u, p);
        if (determinant == 0) continue;
        const double x = dot(t, p) / determinant, y = dot(direction, q) / determinant;
        count += x >= 0 && y >= 0 && x + y < 1 && dot(v, q) / determinant > 0;
      }
    }
    return count;
  }
  // The object that a point is inside of, in all of three directions; kNone if it is in none. What is as
  // large as half of the scene is a room, and the point may well be in it.
  uint32_t object_around(Vec3 point, const std::vector<Pose>& poses) const {
    for (uint32_t i = 0; i < objects_.size(); ++i) {
      const ObjectBox& object = objects_[i];
      if (object.box.empty() || object.box.diagonal() > all_.diagonal() / 2) continue;
      const Vec3 at = inverse(poses[scene_.objects[i].body]) * point;
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
        inside = inside && at[axis] > object.box.lower[axis] && at[axis] < object.box.upper[axis];
      for (const Vec3 direction : {Vec3{0.36, 0.48, 0.8}, Vec3{-0.8, 0.36, -0.48}, Vec3{0.48, -0.8, 0.36}})
        inside = inside && crossings(object, at, direction) % 2 == 1;
      if (inside) return i;
    }
    return kNone;
  }

  void spots() {
    for (const Spot& spot : scene_.spots) {
      for (size_t k = 0; k < times_.size(); ++k) {
        const SpotState state = spot_at(scene_, spot, poses_[k], times_[k]);
        if (is_black(state.intensity)) continue;
        const uint32_t object = object_around(state.position, poses_[k]);
        if (object == kNone) continue;
        lines_.push_back("spot " + spot.name + " is inside the object " + scene_.objects[object].name +
                         " at " + seconds(times_[k]) + ": its light does not come out");
        break;
      }
    }
  }

  void cameras() {
    if (scene_.cameras.empty() || scene_.polygons.empty()) return;
    const Tracer tracer(scene_);
    for (const Camera& camera : scene_.cameras) {
      bool told_inside = false, told_nothing = false;
      for (size_t k = 0; k < times_.size(); ++k) {
        const CameraState state = camera_at(camera, times_[k]);
        const uint32_t object = object_around(state.from, poses_[k]);
        if (object != kNone && !told_inside) {
          told_inside = true;
          lines_.push_back("camera " + camera.name + " is inside the object " + scene_.objects[object].name +
                           " at " + seconds(times_[k]));
        }
        if (!told_nothing && sees_nothing(tracer, state, poses_[k])) {
          told_nothing = true;
          lines_.push_back("camera " + camera.name + " sees nothing at " + seconds(times_[k]));
        }
      }
    }
  }
  static bool sees_nothing(const Tracer& tracer, const CameraState& state, const std::vector<Pose>& poses) {
    constexpr uint32_t kRays = 16;  // by as many
    const CameraRays rays(state, kRays, kRays);
    for (uint32_t y = 0; y < kRays; ++y)
      for (uint32_t x = 0; x < kRays; ++x)
        if (tracer.closest(poses, rays.from(), rays.direction(x + 0.5, y + 0.5)).polygon != kNone)
          return false;
    return true;
  }

  // A corner of one body deep in the box of another that does not carry it.
  void bodies() {
    std::vector<std::vector<Vec3>> corners(scene_.bodies.size());
    for (const Polygon& polygon : scene_.polygons)
      for (int k = 0; k < polygon.corner_count(); ++k)
        corners[body_of(scene_, polygon)].push_back(scene_.vertices[polygon.corners[k]]);
    const std::vector<bool> moves = moving_bodies(scene_);
    for (uint32_t a = 1; a < scene_.bodies.size(); ++a)
      for (uint32_t b = 1; b < scene_.bodies.size(); ++b)
        if (a != b && (moves[a] || moves[b]) && !carries(a, b) && !carries(b, a)) pair(a, b, corners[a]);
  }
  bool carries(uint32_t parent, uint32_t body) const {
    while (body != 0 && body != parent) body = scene_.bodies[body].parent;
    return body == parent;
  }
  void pair(uint32_t a, uint32_t b, const std::vector<Vec3>& corners) {
    constexpr double kDeep = 0.1;         // of the box, from each of its sides
    constexpr size_t kMostCorners = 500;  // of a body, evenly among all
    const Box& box = bodies_[b];
    if (box.empty() || corners.empty()) return;
    const Vec3 margin = kDeep * (box.upper - box.lower);
    const size_t step = 1 + corners.size() / kMostCorners;
    for (size_t k = 0; k < times_.size(); ++k) {
      const Pose b_from_a = inverse(poses_[k][b]) * poses_[k][a];
      for (size_t i = 0; i < corners.size(); i += step) {
        const Vec3 p = b_from_a * corners[i];
        bool deep = true;
        for (int axis = 0; axis < 3; ++axis)
          deep = deep && p[axis] > box.lower[axis] + margin[axis] && p[axis] < box.upper[axis] - margin[axis];
        if (!deep) continue;
        lines_.push_back("body " + scene_.bodies[a].name + " is in the box of body " + scene_.bodies[b].name +
                         " at " + seconds(times_[k]));
        return;
      }
    }
  }

  const Scene& scene_;
  std::vector<ObjectBox> objects_;
  std::vector<Box> bodies_;  // rest
  Box all_;
  std::vector<double> times_;
  std::vector<std::vector<Pose>> poses_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> warnings_of(const Scene& scene) { return Warnings(scene).lines(); }

}  // namespace strad
