// Emitter groups and spotlights at single points.
#include "frame/emitter_groups.h"

#include <gtest/gtest.h>

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
  const std::vector<EmitterGroup> lights = emitter_groups(scene);
  const LitInstant lit = lit_instant(scene, lights, 0);
  UnoccludedIrradiance unoccluded;
  find_unoccluded(lit.emitters[0], point, &unoccluded);
  *irradiance = unoccluded.total;
  ShadowRays shadow;
  add_shadow_rays(tracer, lit, lit.emitters[0], point, unoccluded, 0, count, &shadow);
  return shadow;
}

TEST(EmitterGroups, UnshadowedSquareIsExact) {
  Scene scene;
  add_lamp(&scene);
  double irradiance = 0;
  const ShadowRays shadow = rays(scene, kOrigin, 64, &irradiance);
  EXPECT_NEAR(irradiance, square_irradiance(1, 2), 1e-9);
  EXPECT_EQ(shadow.free, 64);
  EXPECT_NEAR(shadow.all / 64, 1, 0.02);  // weights have mean 1
  EXPECT_EQ(free_fraction(shadow), 1);
}

TEST(EmitterGroups, PiecesOfOneObjectAreOneLight) {
  const Scene scene = pieces_scene();
  EXPECT_EQ(emitter_groups(scene).size(), 1u);
  double irradiance = 0;
  const ShadowRays shadow = rays(scene, kOrigin, 256, &irradiance);
  EXPECT_NEAR(irradiance, square_irradiance(1, 2), 1e-9);
  EXPECT_NEAR(shadow.all / 256, 1, 0.02);
}

TEST(EmitterGroups, HalfHiddenByAScreen) {
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

TEST(EmitterGroups, NothingFromBehindTheLampOrTheSurface) {
  Scene scene;
  add_lamp(&scene);
  double irradiance = 0;
  rays(scene, {{0, 0, 3}, {0, 0, -1}, kNone}, 4, &irradiance);
  EXPECT_EQ(irradiance, 0);
  rays(scene, {{0, 0, 0}, {0, 0, -1}, kNone}, 4, &irradiance);
  EXPECT_EQ(irradiance, 0);
}

TEST(EmitterGroups, SpotFallsWithTheSquareOfDistance) {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
  scene.spots.push_back({"key", 0, 0.3, 0.5, {{0, {0, 0, 2}, {0, 0, 0}, {8, 4, 2}}}});
  const Tracer tracer(scene);
  const LitInstant lit = lit_instant(scene, {}, 0);
  SpotRays under, beside;
  const Rgb light = spots_irradiance(tracer, lit.cones, lit.instant, {{0, 0, 0}, {0, 0, 1}, 0}, &under);
  EXPECT_NEAR(light.r, 8 / 4.0, 1e-6);  // I cos / r^2
  EXPECT_NEAR(light.b, 2 / 4.0, 1e-6);
  const Rgb none = spots_irradiance(tracer, lit.cones, lit.instant, {{3, 0, 0}, {0, 0, 1}, 0}, &beside);
  EXPECT_EQ(none, Rgb{});
  EXPECT_NE(under.reached, beside.reached);
}

}  // namespace
}  // namespace strad
