// Rays that look only into the bodies whose bounds they meet find what all rays find.
#include "light/posed_tracer.h"

#include <gtest/gtest.h>

#include <array>

#include "base/rng.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

Vec3 random_point(uint64_t key, double size) {
  return {size * (unit_from(hash_of(key, 1)) - 0.5), size * (unit_from(hash_of(key, 2)) - 0.5),
          size * (unit_from(hash_of(key, 3)) - 0.5)};
}

// A floor at rest and `count` tetrahedra that move and turn.
Scene cloud(uint32_t count, double away) {
  Scene scene;
  scene.end = 1;
  scene.materials.emplace_back();
  const auto add = [&](Vec3 a, Vec3 b, Vec3 c, uint32_t object) {
    const auto first = static_cast<uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {a, b, c});
    scene.polygons.push_back({{first, first + 1, first + 2, kNone}, {kNone, kNone, kNone, kNone}, 0, object});
  };
  const Vec3 shift{away, -away, 0};
  scene.objects.push_back({"floor", 0});
  add(shift + Vec3{-9, -3, -9}, shift + Vec3{9, -3, -9}, shift + Vec3{0, -3, 9}, 0);
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 at = shift + random_point(hash_of(i, 7), 8);
    Body body{"body" + std::to_string(i), 0, at, {0, 1, 0}, Ease::kLinear, {}, {}};
    body.keys = {{0, {}, 0, false, {}}, {1, random_point(hash_of(i, 8), 2), 3, false, {}}};
    scene.bodies.push_back(body);
    scene.objects.push_back({"tetrahedron", i + 1});
    const Vec3 p[] = {at, at + Vec3{1, 0, 0}, at + Vec3{0, 1, 0}, at + Vec3{0, 0, 1}};
    for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
      add(p[face[0]], p[face[1]], p[face[2]], i + 1);
  }
  return scene;
}

TEST(PosedTracer, FindsWhatTheTracerFinds) {
  for (const uint32_t count : {3u, 40u}) {
    for (const double away : {0.0, 1000.0}) {
      const Scene scene = cloud(count, away);
      const Tracer tracer(scene);
      const std::vector<Pose> poses = poses_at(scene, 0.6);
      const PosedTracer posed(tracer, scene, poses);
      int hits = 0, blocked = 0, on_bodies = 0;
      for (uint64_t i = 0; i < 4000; ++i) {
        const Vec3 shift{away, -away, 0};
        const Vec3 from = shift + random_point(hash_of(i, 1), 10),
                   to = shift + random_point(hash_of(i, 2), 10);
        Vec3 direction = normalized(to - from);
        if (i % 4 == 0) direction = {0, -1, 0};
        const SurfaceHit a = tracer.closest(poses, from, direction), b = posed.closest(from, direction);
        ASSERT_EQ(a.polygon, b.polygon) << i;
        ASSERT_EQ(a.distance, b.distance);
        ASSERT_EQ(a.rest_point, b.rest_point);
        ASSERT_EQ(tracer.occluded(poses, from, to), posed.occluded(from, to)) << i;
        hits += a.polygon != kNone;
        on_bodies += a.polygon != kNone && a.polygon > 0;
        blocked += posed.occluded(from, to);
      }
      EXPECT_GT(hits, 400);
      EXPECT_GT(on_bodies, 20);
      EXPECT_GT(blocked, 20);
    }
  }
}

}  // namespace
}  // namespace strad
