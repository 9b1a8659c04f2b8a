// Glass: what is solid, what is mirrored, and what goes straight through.
#include "scene/glass.h"

#include <gtest/gtest.h>

#include "light/tracer.h"

namespace strad {
namespace {

// A box of glass from (0, 0, 0) to (1, 1, 1), each side with corners of its own, before a wall at z = -1.
Scene glass_box(bool inwards, bool open) {
  Scene scene;
  scene.materials.resize(2);
  scene.materials[0].reflectance = {};
  scene.materials[0].finish = {{1, 1, 1}, 0, {0.5f, 1, 1}, 1.5f, true, false};
  scene.objects = {{"box", 0}, {"wall", 0}};
  const auto add = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d, uint32_t which) {
    if (inwards) std::swap(b, d);
    const auto first = static_cast<uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {a, b, c, d});
    Polygon polygon;
    for (uint32_t i = 0; i < 4; ++i) polygon.corners[i] = first + i;
    polygon.material = polygon.object = which;
    scene.polygons.push_back(polygon);
  };
  add({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, 0);
  add({1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, 0);
  add({1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, 0);
  add({0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}, 0);
  add({0, 1, 1}, {1, 1, 1}, {1, 1, 0}, {0, 1, 0}, 0);
  if (!open) add({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, 0);
  add({-1, -1, -1}, {2, -1, -1}, {2, 2, -1}, {-1, 2, -1}, 1);
  return scene;
}

TEST(Glass, IsSolidWhereItEnclosesASpace) {
  EXPECT_EQ(glass_kinds(glass_box(false, false))[0], GlassKind::kSolid);
  EXPECT_EQ(glass_kinds(glass_box(true, false))[0], GlassKind::kInverted);
  EXPECT_EQ(glass_kinds(glass_box(false, true))[0], GlassKind::kSheet);
  EXPECT_EQ(glass_kinds(glass_box(false, false))[6], GlassKind::kNone);
  Scene plain = glass_box(false, false);
  plain.materials[0].finish = {};
  EXPECT_TRUE(glass_kinds(plain).empty());
}

TEST(Glass, MirrorsWhatFresnelSays) {
  EXPECT_NEAR(fresnel_reflectance(1, 1.5), 0.04, 1e-12);  // ((1.5 - 1) / (1.5 + 1))^2
  EXPECT_NEAR(fresnel_reflectance(1, 1 / 1.5), 0.04, 1e-12);
  EXPECT_EQ(fresnel_reflectance(0, 1.5), 1);
  EXPECT_EQ(fresnel_reflectance(0.7, 1 / 1.5), 1);  // the critical angle is at a cosine of 0.745
  // At Brewster's angle, tan = n, only light across the plane of incidence: ((n^2 - 1) / (n^2 + 1))^2 / 2.
  EXPECT_NEAR(fresnel_reflectance(1 / std::sqrt(1 + 2.25), 1.5), 0.5 * std::pow(1.25 / 3.25, 2), 1e-12);
}

TEST(Glass, LightGoesStraightThrough) {
  for (const bool inwards : {false, true}) {
    const Scene scene = glass_box(inwards, false);
    const Tracer tracer(scene);
    const std::vector<Pose> poses(1);
    Rgb passed{1, 1, 1};
    EXPECT_FALSE(tracer.occluded(poses, {0.3, 0.4, 3}, {0.3, 0.4, -0.5}, &passed));
    EXPECT_NEAR(passed.r, 0.96f * 0.96f * 0.25f, 1e-5f);  // two surfaces: each 1 - 0.04, and its tint
    EXPECT_NEAR(passed.g, 0.96f * 0.96f, 1e-5f);
    EXPECT_TRUE(tracer.occluded(poses, {0.3, 0.4, 3}, {0.3, 0.4, -2}, &passed));
    passed = {1, 1, 1};
    const SurfaceHit hit = tracer.closest_through(poses, {0.3, 0.4, 3}, {0, 0, -1}, &passed);
    EXPECT_EQ(hit.polygon, 6u);
    EXPECT_NEAR(passed.r, 0.96f * 0.96f * 0.25f, 1e-5f);
    EXPECT_EQ(tracer.closest(poses, {0.3, 0.4, 3}, {0, 0, -1}).polygon, 0u);  // the eye sees the glass
  }
  // Of a pane, 2 R / (1 + R) is mirrored by both sides.
  Finish finish = glass_box(false, true).materials[0].finish;
  EXPECT_NEAR(straight_share(finish, GlassKind::kSheet, 1).g, 1 - 0.08f / 1.04f, 1e-6f);
}

// Of glass that also reflects diffusely, many rays see both parts with their weights.
TEST(Glass, RaysMeetItsDiffusePartNowAndThen) {
  Scene scene = glass_box(false, true);
  scene.materials[0].finish = {{}, 0, {0.5f, 0.5f, 0.5f}, 1.5f, false, false};
  scene.materials[0].reflectance = {0.25f, 0.25f, 0.25f};
  const Tracer tracer(scene);
  const std::vector<Pose> poses(1);
  double met = 0, behind = 0;
  constexpr int kRays = 20000;
  for (int i = 0; i < kRays; ++i) {
    Rgb passed{1, 1, 1};
    const Vec3 from{0.1 + 0.8 * i / kRays, 0.5, 0.5};
    const SurfaceHit hit = tracer.closest_through(poses, from, {0, 0, -1}, &passed);
    (hit.polygon == 1 ? met : behind) += double{passed.r} / kRays;
  }
  // A third of the rays with weight 3, and two thirds with weight 0.5 / (2 / 3): deviations of 1 % and 0.3 %.
  EXPECT_NEAR(met, 1, 0.05);
  EXPECT_NEAR(behind, 0.5, 0.02);
}

}  // namespace
}  // namespace strad
