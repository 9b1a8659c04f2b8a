#include "frame/plan.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

constexpr double kMargin = 0.05;  // of the picture
constexpr int kPathSteps = 400;   // of a path over all time
constexpr Rgb kInk{0.25f, 0.25f, 0.25f};
constexpr Rgb kSpotInk{0.9f, 0.35f, 0.0f};
constexpr Rgb kCameraInk{0.05f, 0.15f, 0.9f};

// Points of the scene as points of the picture. `across` goes to the right, `down` down.
class Sheet {
 public:
  Sheet(const Box& box, const PlanOptions& options) : image_(options.width, options.height, {1, 1, 1}) {
    // Seen against the axis: with y up, x to the right and z down; with z up, x to the right and y up the
    // picture.
    int up = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (std::abs(options.up[axis]) > std::abs(options.up[up])) up = axis;
    across_[up == 0 ? 1 : 0] = 1;
    down_[up == 2 ? 1 : 2] = up == 1 ? 1 : -1;
    const double width =
        dot(box.upper - box.lower, {std::abs(across_.x), std::abs(across_.y), std::abs(across_.z)});
    const double height =
        dot(box.upper - box.lower, {std::abs(down_.x), std::abs(down_.y), std::abs(down_.z)});
    const double room = 1 - 2 * kMargin;
    scale_ = std::min(room * options.width / std::max(width, 1e-9),
                      room * options.height / std::max(height, 1e-9));
    centre_ = box.centre();
  }
  Vec2 at(Vec3 p) const {
    return {image_.width / 2.0 + scale_ * dot(p - centre_, across_),
            image_.height / 2.0 + scale_ * dot(p - centre_, down_)};
  }
  // A pixel wide, its edges smoothed. `strength`: how much of the ink it has.
  void line(Vec2 a, Vec2 b, Rgb ink, double strength) {
    const double reach = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    if (!(reach < 1e5)) return;
    const int steps = std::max(1, static_cast<int>(std::ceil(reach)));
    for (int k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      dab({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}, ink, strength);
    }
  }
  void line(Vec3 a, Vec3 b, Rgb ink, double strength = 1) { line(at(a), at(b), ink, strength); }
  void dot_at(Vec3 p, Rgb ink) {
    const Vec2 middle = at(p);
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x)
        if (x * x + y * y <= 5) dab({middle.x + x, middle.y + y}, ink, 1);
  }
  Image take() { return std::move(image_); }

 private:
  // Shares ink among the four pixels around a point.
  void dab(Vec2 p, Rgb ink, double strength) {
    const double x = std::floor(p.x - 0.5), y = std::floor(p.y - 0.5), fx = p.x - 0.5 - x, fy = p.y - 0.5 - y;
    for (int k = 0; k < 4; ++k) {
      const double px = x + (k & 1), py = y + (k >> 1);
      if (!(px >= 0 && py >= 0 && px < image_.width && py < image_.height)) continue;
      const auto part = static_cast<float>(strength * (k & 1 ? fx : 1 - fx) * (k >> 1 ? fy : 1 - fy));
      Rgb& pixel = image_.at(static_cast<uint32_t>(px), static_cast<uint32_t>(py));
      pixel = (1 - part) * pixel + part * ink;
    }
  }

  Image image_;
  Vec3 across_, down_, centre_;
  double scale_ = 1;
};

// Dark enough to be seen on white.
Rgb ink_of(uint32_t body) {
  Rgb ink;
  for (int c = 0; c < 3; ++c)
    ink[c] = static_cast<float>(0.6 * unit_from(hash_of(uint64_t{body}, static_cast<uint64_t>(c))));
  return ink;
}

std::vector<Box> boxes_of_bodies(const Scene& scene) {
  std::vector<Box> boxes(scene.bodies.size());
  for (const Polygon& polygon : scene.polygons)
    for (int k = 0; k < polygon.corner_count(); ++k)
      boxes[body_of(scene, polygon)].add(scene.vertices[polygon.corners[k]]);
  return boxes;
}

void draw_polygons(const Scene& scene, const std::vector<Pose>& poses, Sheet* sheet) {
  constexpr double kFaint = 0.3;
  for (const Polygon& polygon : scene.polygons) {
    const uint32_t body = body_of(scene, polygon);
    const int count = polygon.corner_count();
    const auto corner = [&](int k) { return poses[body] * scene.vertices[polygon.corners[k % count]]; };
    for (int k = 0; k < count; ++k)
      sheet->line(corner(k), corner(k + 1), body ? ink_of(body) : kInk, body ? 3 * kFaint : kFaint);
  }
}

// Calls `point` for the times of a path, of which each whole second is `marked`.
template <typename Point>
void draw_path(const Scene& scene, Rgb ink, Sheet* sheet, Point point) {
  Vec3 last = point(scene.start);
  bool moves = false;
  for (int k = 1; k <= kPathSteps; ++k) {
    const Vec3 next = point(scene.start + (scene.end - scene.start) * k / kPathSteps);
    moves = moves || length(next - last) > 0;
    sheet->line(last, next, ink);
    last = next;
  }
  if (!moves || scene.end - scene.start > kPathSteps) return;
  for (double second = std::ceil(scene.start); second <= scene.end; ++second)
    sheet->dot_at(point(second), ink);
}

void draw_spot(const Scene& scene, const Spot& spot, const std::vector<Pose>& poses, double time, Vec3 up,
               Sheet* sheet) {
  const SpotState state = spot_at(scene, spot, poses, time);
  const SpotKey* key = &spot.keys.front();
  for (const SpotKey& each : spot.keys)
    if (each.time <= time) key = &each;
  const double reach = length(key->aim - key->at);
  sheet->dot_at(state.position, kSpotInk);
  const double outer = std::min(spot.outer, kPi / 2 - 0.01);
  Vec3 aside = cross(up, state.direction);
  if (!(length(aside) > 1e-6)) aside = frame_about(state.direction).tangent;
  const Vec3 across = reach * std::tan(std::min(outer, 1.3)) * normalized(aside);
  const Vec3 end = state.position + reach * state.direction;
  sheet->line(state.position, end + across, kSpotInk);
  sheet->line(state.position, end - across, kSpotInk);
  sheet->line(end - across, end + across, kSpotInk, 0.5);
}

void draw_camera(const Camera& camera, double time, Vec3 up, double reach, Sheet* sheet) {
  const CameraState state = camera_at(camera, time);
  const Vec3 view = normalized(state.to - state.from), right = normalized(cross(view, state.up));
  const double half = std::tan(state.fov / 2) * 4 / 3;  // of a picture of 4 by 3
  for (const double side : {-1.0, 1.0}) {
    Vec3 edge = view + side * half * right;
    if (!(length(edge - dot(edge, up) * up) > 1e-6)) continue;
    sheet->line(state.from, state.from + reach * normalized(edge), kCameraInk);
  }
  sheet->dot_at(state.from, kCameraInk);
}

}  // namespace

Image plan_of(const Scene& scene, const Camera* camera, double time, const PlanOptions& options) {
  const std::vector<Box> boxes = boxes_of_bodies(scene);
  Box all;
  for (const double at : {scene.start, time, scene.end}) {
    const std::vector<Pose> poses = poses_at(scene, at);
    for (const Polygon& polygon : scene.polygons)
      for (int k = 0; k < polygon.corner_count(); ++k)
        all.add(poses[body_of(scene, polygon)] * scene.vertices[polygon.corners[k]]);
    if (camera) all.add(camera_at(*camera, at).from);
  }
  Sheet sheet(all, options);
  const std::vector<Pose> poses = poses_at(scene, time);
  draw_polygons(scene, poses, &sheet);
  const Vec3 up = normalized(options.up);
  for (uint32_t body = 1; body < scene.bodies.size(); ++body)
    if (!boxes[body].empty())
      draw_path(scene, ink_of(body), &sheet,
                [&](double at) { return poses_at(scene, at)[body] * boxes[body].centre(); });
  for (const Spot& spot : scene.spots) {
    draw_path(scene, kSpotInk, &sheet,
              [&](double at) { return spot_at(scene, spot, poses_at(scene, at), at).position; });
    draw_spot(scene, spot, poses, time, up, &sheet);
  }
  if (camera) {
    draw_path(scene, kCameraInk, &sheet, [&](double at) { return camera_at(*camera, at).from; });
    draw_camera(*camera, time, up, all.diagonal() / 4, &sheet);
  }
  return sheet.take();
}

}  // namespace strad
