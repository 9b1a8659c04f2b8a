// Visibility of turning and moving bodies against analytic intersections.
#include "light/tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "base/rng.h"
#include "light_test_scene.h"
#include "scene/polygon_geometry.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

// Two movers, one on the other, a body that is displaced but never moves, and a wall of the world.
Scene turning_scene() {
  Scene scene;
  scene.end = 10;
  const uint32_t arm = add_body(&scene, {0.5, 0, 0.2}, 4.0, normalized({1, 2, 3}), {0.2, 0.1, 0});
  const uint32_t hand = add_body(&scene, {0, 0.3, 0}, -7.0, {0, 0, 1}, {1, 0, 0}, arm);
  const uint32_t fixed = add_body(&scene, {});
  scene.bodies[fixed].keys = {{0, {-1, 0, 0}, 0.5, false, {}}};
  add_polygon(&scene, {{-0.5, -0.4, 0.1}, {0.6, -0.4, 0.1}, {0.6, 0.5, 0.1}, {-0.5, 0.5, 0.1}}, arm);
  add_polygon(&scene, {{1, -0.4, -0.4}, {1.4, 0.5, -0.4}, {1, 0, 0.6}}, hand);
  add_polygon(&scene, {{-0.2, -0.6, -0.6}, {-0.2, 0.6, -0.6}, {-0.2, 0.6, 0.6}, {-0.2, -0.6, 0.6}}, fixed);
  add_polygon(&scene, {{-2, -2, -1}, {2, -2, -1}, {2, 2, -1}, {-2, 2, -1}}, 0);
  return scene;
}

Vec3 normal_of(const Scene& scene, const Polygon& p, const Pose& pose) {
  const auto at = [&](int c) { return pose * scene.vertices[p.corners[c]]; };
  return normalized(cross(at(1) - at(0), at(2) - at(0)));
}

// How far inside the polygon (metres; negative: outside) and at which parameter the line from + s * direction
// meets its plane.
struct Meeting {
  double s, inside;
};
std::optional<Meeting> meeting(const Scene& scene, const Polygon& p, const Pose& pose, Vec3 from,
                               Vec3 direction) {
  const Vec3 n = normal_of(scene, p, pose);
  const auto at = [&](int c) { return pose * scene.vertices[p.corners[c % p.corner_count()]]; };
  const double along = dot(direction, n);
  if (std::abs(along) < 1e-3 * length(direction)) return std::nullopt;  // grazing: not to be told by floats
  const double s = dot(at(0) - from, n) / along;
  const Vec3 x = from + s * direction;
  double inside = 1e30;
  for (int c = 0; c < p.corner_count(); ++c)
    inside = std::min(inside, dot(cross(n, normalized(at(c + 1) - at(c))), x - at(c)));
  return Meeting{s, inside};
}

Vec3 random_point(uint64_t i, uint64_t k) {
  const auto unit = [&](uint64_t j) { return unit_from(hash_of(i, k, j)) - 0.5; };
  return {5 * unit(0), 4 * unit(1), 4 * unit(2)};
}

constexpr double kTie = 1e-5;  // m: nearer to an edge or an end than this either answer is right

struct Truth {
  bool sure = true;
  uint32_t polygon = kNone;
  double s = 1e30;
  bool front = true;
};
// The first polygon of `mask`'s bodies met by from + s * direction with 0 < s < 1.
Truth truth_of(const Scene& scene, const std::vector<Pose>& poses, const std::vector<bool>& mask, Vec3 from,
               Vec3 direction) {
  Truth truth;
  const double tie = kTie / length(direction);
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon& polygon = scene.polygons[p];
    const uint32_t body = body_of(scene, polygon);
    if (!mask[body]) continue;
    const std::optional<Meeting> m = meeting(scene, polygon, poses[body], from, direction);
    if (!m || std::abs(m->inside) < kTie || std::abs(m->s) < tie || std::abs(m->s - 1) < tie)
      truth.sure = false;
    if (!truth.sure) return truth;
    if (m->inside < 0 || m->s < 0 || m->s > 1) continue;
    if (std::abs(m->s - truth.s) < tie) truth.sure = false;
    if (m->s < truth.s)
      truth = {truth.sure, p, m->s, dot(direction, normal_of(scene, polygon, poses[body])) < 0};
  }
  return truth;
}

void expect_truth(const std::vector<bool>& mask, bool all) {
  const Scene scene = turning_scene();
  const Tracer tracer(scene);
  int sure = 0, blocked = 0;
  for (uint64_t i = 0; i < 20000; ++i) {
    const std::vector<Pose> poses = poses_at(scene, 10 * unit_from(hash_of(i, 99)));
    const Vec3 from = random_point(i, 1), to = random_point(i, 2);
    const Truth truth = truth_of(scene, poses, mask, from, to - from);
    if (!truth.sure) continue;
    ++sure;
    const bool hit = truth.polygon != kNone;
    blocked += hit;
    ASSERT_EQ(tracer.occluded_by(poses, mask, from, to), hit) << i;
    if (all) {
      ASSERT_EQ(tracer.occluded(poses, from, to), hit) << i;
    }
    const double reach = length(to - from);
    const Vec3 direction = (to - from) / reach;
    const SurfaceHit found = all ? tracer.closest(poses, from, direction, reach)
                                 : tracer.closest_of(poses, mask, from, direction, reach);
    ASSERT_EQ(found.polygon, truth.polygon) << i;
    if (!hit) continue;
    ASSERT_EQ(found.front, truth.front) << i;
    ASSERT_NEAR(found.distance, truth.s * reach, kTie);
    const Vec3 at = poses[body_of(scene, scene.polygons[found.polygon])] * found.rest_point;
    ASSERT_NEAR(length(at - (from + truth.s * (to - from))), 0, kTie);
    const Vec3 on_polygon = point_of(scene, scene.polygons[found.polygon], found.uv);
    ASSERT_NEAR(length(on_polygon - found.rest_point), 0, kTie);
  }
  EXPECT_GT(sure, 19000);
  EXPECT_GT(blocked, 1000);
}

TEST(Tracer, SeesTurningBodiesWhereTheyAre) { expect_truth({true, true, true, true}, true); }
TEST(Tracer, SeesOnlyTheBodiesAskedFor) { expect_truth({false, true, true, false}, false); }

TEST(Tracer, BoxesAreOfTheRestPose) {
  const Scene scene = turning_scene();
  const Tracer tracer(scene);
  EXPECT_EQ(tracer.body_box(1).lower, (Vec3{-0.5, -0.4, 0.1}));
  EXPECT_EQ(tracer.body_box(1).upper, (Vec3{0.6, 0.5, 0.1}));
  EXPECT_EQ(tracer.scene_box().lower, (Vec3{-2, -2, -1}));
  EXPECT_NEAR(tracer.offset(), 1e-5 * tracer.scene_box().diagonal(), 1e-12);
}

// A quad of 2 x 2 m that slides along x, whose texture has a hole where u > 1/2, and a triangle at rest below
// it.
TEST(Tracer, RaysPassHoles) {
  Scene scene;
  scene.end = 1;
  const uint32_t body = add_body(&scene, {10, 0, 0});
  add_polygon(&scene, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, body);
  add_polygon(&scene, {{-9, -9, 0}, {99, -9, 0}, {-9, 99, 0}});
  scene.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (uint32_t c = 0; c < 4; ++c) scene.polygons[0].uvs[c] = c;
  scene.textures = {{"t", 1, 1, {9, 9, 9}, true, {2, 1, {255, 0}}}};
  scene.materials[0].texture = 0;
  validate(scene);
  const Tracer tracer(scene);
  for (const double time : {0.0, 0.5}) {
    const std::vector<Pose> poses = poses_at(scene, time);
    for (const double y : {-0.7, 0.7})  // both triangles of the quad
      for (const double x : {-0.9, -0.1, 0.1, 0.9}) {
        const Vec3 from{10 * time + x, y, 2}, to{10 * time + x, y, 0.5};
        EXPECT_EQ(tracer.occluded(poses, from, to), x < 0) << x << ' ' << y;
        EXPECT_EQ(tracer.closest(poses, from, {0, 0, -1}).polygon, x < 0 ? 0u : 1u) << x << ' ' << y;
      }
  }
  scene.materials[0].emission = {1, 1, 1};  // lamps have no holes
  EXPECT_TRUE(Tracer(scene).occluded(poses_at(scene, 0), {0.5, 0, 2}, {0.5, 0, 0.5}));
}

// Turned by any angle, a surface does not shade a point lifted off it by the offset.
TEST(Tracer, ASurfaceDoesNotShadeItself) {
  const Scene scene = turning_scene();
  const Tracer tracer(scene);
  std::vector<bool> own{false, true, false, false};
  for (uint64_t i = 0; i < 5000; ++i) {
    const auto unit = [&](uint64_t k) { return unit_from(hash_of(i, k)); };
    const std::vector<Pose> poses = poses_at(scene, 10 * unit(0));
    const Vec3 normal = rotate(poses[1], {0, 0, 1});
    const Vec3 at = poses[1] * Vec3{-0.49 + 1.08 * unit(1), -0.39 + 0.88 * unit(2), 0.1};
    const Vec3 away = rotate(poses[1], normalized({unit(3) - 0.5, unit(4) - 0.5, 0.01 + unit(5)}));
    EXPECT_FALSE(tracer.occluded_by(poses, own, at + tracer.offset() * normal, at + 3 * away)) << i;
  }
}

}  // namespace
}  // namespace strad
