// Emitter groups and spotlights at single points.
#include "frame/lit_groups.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "synthetic.h"

namespace strad {
namespace {

// A lamp of 2 x 2 m at height 2 that looks down on the origin, optionally in several pieces of one object.
void add_lamp(Scene* scene) {
  add_quad(scene, {-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {}, {1, 1, 1});
}
Scene pieces_scene() {
  Scene scene;
  for (const double x : {-1.0, -0.5, 0.25}) {
    const double end = x == -1.0 ? -0.5 : x == -0.5 ? 0.25 : 1;
    add_quad(&scene, {x, -1, 2}, {x, 1, 2}, {end, 1, 2}, {end, -1, 2}, {}, {1, 1, 1});
    scene.polygons.back().object = 0;
    scene.polygons.back().material = 0;
  }
  return scene;
}
const SurfacePoint kOrigin{{0, 0, 0}, {0, 0, 1}, kNone};

// A square of half side a at height h over a point: 4 h-independent pieces, each the form factor of a
// rectangle with one corner overhead (Howell C-11): E = 4 * (X / sqrt(1 + X^2)) * atan(X / sqrt(1 + X^2))
// with X = a / h, times radiance (E = pi F for unit radiance, F = 4 * (1 / 2 pi) * 2 * ...).
double square_irradiance(double a, double h) {
  const double x = a / h, r = x / std::sqrt(1 + x * x);
  return 4 * r * std::atan(r);
}

ShadowRays rays(const Scene& scene, const SurfacePoint& point, uint32_t count, double* irradiance) {
  const Tracer tracer(scene);
  const std::vector<EmitterGroup> groups = emitter_groups(scene);
  const LightsAtInstant lights = lights_at(scene, groups, 0);
  GroupSight sight;
  see_group(lights.groups[0], point, &sight);
  *irradiance = unoccluded_irradiance(lights.groups[0], point, sight);
  ShadowRays shadow;
  add_shadow_rays(tracer, lights.instant, lights.groups[0], point, *irradiance, {0, count, 0}, &sight,
                  &shadow);
  return shadow;
}

TEST(LitGroups, UnshadowedSquareIsExact) {
  Scene scene;
  add_lamp(&scene);
  double irradiance = 0;
  const ShadowRays shadow = rays(scene, kOrigin, 64, &irradiance);
  EXPECT_NEAR(irradiance, square_irradiance(1, 2), 1e-9);
  EXPECT_EQ(shadow.free, 64);
  EXPECT_NEAR(shadow.all / 64, 1, 0.02);  // weights have mean 1
  EXPECT_EQ(free_fraction(shadow), 1);
}

TEST(LitGroups, PiecesOfOneObjectAreOneLight) {
  const Scene scene = pieces_scene();
  EXPECT_EQ(emitter_groups(scene).size(), 1u);
  double irradiance = 0;
  const ShadowRays shadow = rays(scene, kOrigin, 256, &irradiance);
  EXPECT_NEAR(irradiance, square_irradiance(1, 2), 1e-9);
  EXPECT_NEAR(shadow.all / 256, 1, 0.02);
}

TEST(LitGroups, HalfHiddenByAScreen) {
  for (const bool pieces : {false, true}) {
    Scene scene = pieces ? pieces_scene() : Scene{};
    if (!pieces) add_lamp(&scene);
    // At half height, hiding exactly what lies at x > 0 as seen from the origin: half of the light, by
    // symmetry.
    add_quad(&scene, {0, -5, 1}, {5, -5, 1}, {5, 5, 1}, {0, 5, 1});
    double irradiance = 0;
    const ShadowRays shadow = rays(scene, kOrigin, 256, &irradiance);
    EXPECT_EQ(shadow.rays, 256);
    EXPECT_NEAR(free_fraction(shadow), 0.5, 0.01);
  }
}

// A ball of 8 x 4 quads and triangles about `centre`, each facet an object of its own, with one material.
void add_ball(Scene* scene, Vec3 centre, double radius) {
  const auto at = [&](int ring, int segment) {
    const double t = kPi * ring / 4, p = kPi * segment / 4;
    if (ring == 0 || ring == 4) return centre + radius * Vec3{0, 0, ring == 0 ? 1.0 : -1.0};
    return centre + radius * Vec3{std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
  };
  for (int r = 0; r < 4; ++r) {
    for (int s = 0; s < 8; ++s) {
      const uint32_t p =
          add_quad(scene, at(r, s), at(r + 1, s), at(r + 1, (s + 1) % 8), at(r, (s + 1) % 8), {}, {1, 1, 1});
      Polygon& polygon = scene->polygons[p];
      polygon.material = 0;
      if (r == 0) polygon.corners[3] = kNone;
      if (r == 3) polygon.corners[2] = polygon.corners[3], polygon.corners[3] = kNone;
    }
  }
}

// The outlines of a ball give what its facets give one by one, where it is above the horizon, where the
// horizon cuts it and from within its reach.
TEST(LitGroups, OutlinesGiveTheSumOfFacets) {
  Scene scene;
  add_ball(&scene, {0, 0, 0}, 1);
  const std::vector<EmitterGroup> groups = emitter_groups(scene);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].polygons.size(), 32u);
  EXPECT_EQ(groups[0].vertices.size(), 26u);  // 3 rings of 8 and the poles
  EXPECT_EQ(groups[0].edges.size(), 56u);     // Euler: V - E + F = 2
  const LightsAtInstant lights = lights_at(scene, groups, 0);
  GroupSight sight;
  int cut = 0, far = 0;
  for (uint32_t i = 0; i < 200; ++i) {
    const Point2 at = r2_point(i, 0.1, 0.2), towards{unit_from(hash_of(i, 1)), unit_from(hash_of(i, 2))};
    const double z = 2 * at.u - 1, ring = std::sqrt(1 - z * z), distance = 1.05 + 0.05 * i;
    const double nz = 2 * towards.u - 1, nring = std::sqrt(1 - nz * nz);
    SurfacePoint point;
    point.position = distance * Vec3{ring * std::cos(2 * kPi * at.v), ring * std::sin(2 * kPi * at.v), z};
    point.normal = {nring * std::cos(2 * kPi * towards.v), nring * std::sin(2 * kPi * towards.v), nz};
    see_group(lights.groups[0], point, &sight);
    double sum = 0;
    for (const Emitter& facet : lights.groups[0].facets) {
      if (is_before(facet, point.position))
        sum += unit_irradiance(point.position, point.normal, facet.corners.data(), facet.count);
    }
    EXPECT_NEAR(unoccluded_irradiance(lights.groups[0], point, sight), sum, 1e-12) << i;
    cut += sight.below_horizon && sum > 0;
    far += sight.view != nullptr;
    EXPECT_TRUE(sight.view == nullptr || distance > 3);
  }
  EXPECT_GT(cut, 20);
  EXPECT_GT(far, 40);
}

// Samples of it are weighted to a mean of 1 and none is lost: about as many as facets that are seen.
TEST(LitGroups, SamplesOfABallHaveMeanOne) {
  Scene scene;
  add_ball(&scene, {0, 0, 2}, 0.5);
  double irradiance = 0;
  const ShadowRays shadow = rays(scene, kOrigin, 1024, &irradiance);
  EXPECT_NEAR(shadow.all / 1024, 1, 0.02);
  EXPECT_EQ(free_fraction(shadow), 1);
}

// One material, but neither one object nor any corner in common.
TEST(LitGroups, LampsApartAreTwo) {
  Scene scene;
  add_lamp(&scene);
  add_quad(&scene, {2, -1, 2}, {2, 1, 2}, {3, 1, 2}, {3, -1, 2}, {}, {1, 1, 1});
  scene.polygons.back().material = 0;
  EXPECT_EQ(emitter_groups(scene).size(), 2u);
}

// A lamp that the horizon cuts: no ray is lost on the part below, so few rays always find it. The floor's
// point looks along x, and of the lamp [-1, 1] x [-1, 1] only what lies at x > 0.9 is above its horizon.
TEST(LitGroups, RaysGoAboveTheHorizon) {
  Scene scene;
  add_lamp(&scene);
  double irradiance = 0;
  const ShadowRays shadow = rays(scene, {{0.9, 0, 0}, {1, 0, 0}, kNone}, 64, &irradiance);
  EXPECT_EQ(shadow.rays, 64);
  EXPECT_NEAR(shadow.all / 64, 1, 0.1);
  EXPECT_EQ(free_fraction(shadow), 1);
}

TEST(LitGroups, NothingFromBehindTheLampOrTheSurface) {
  Scene scene;
  add_lamp(&scene);
  double irradiance = 0;
  rays(scene, {{0, 0, 3}, {0, 0, -1}, kNone}, 4, &irradiance);
  EXPECT_EQ(irradiance, 0);
  rays(scene, {{0, 0, 0}, {0, 0, -1}, kNone}, 4, &irradiance);
  EXPECT_EQ(irradiance, 0);
}

TEST(LitGroups, SpotFallsWithTheSquareOfDistance) {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
  scene.spots.push_back({"key", 0, 0.3, 0.5, {{0, {0, 0, 2}, {0, 0, 0}, {8, 4, 2}}}});
  const Tracer tracer(scene);
  const LightsAtInstant lights = lights_at(scene, {}, 0);
  SpotRays under, beside;
  const Rgb light = spots_irradiance(tracer, lights.cones, lights.instant, {{0, 0, 0}, {0, 0, 1}, 0}, &under);
  EXPECT_NEAR(light.r, 8 / 4.0, 1e-6);  // I cos / r^2
  EXPECT_NEAR(light.b, 2 / 4.0, 1e-6);
  const Rgb none = spots_irradiance(tracer, lights.cones, lights.instant, {{3, 0, 0}, {0, 0, 1}, 0}, &beside);
  EXPECT_EQ(none, Rgb{});
  EXPECT_NE(under.reached, beside.reached);
}

}  // namespace
}  // namespace strad
