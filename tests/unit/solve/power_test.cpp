// The light that a scene is expected to hold: rho / pi * power / area / (1 - rho), by hand.
#include "solve/prepare/power.h"

#include <gtest/gtest.h>

#include "../light/light_test_scene.h"

namespace strad {
namespace {

std::vector<Instant> instants_of(const Scene& scene, const std::vector<double>& times) {
  std::vector<Instant> instants;
  for (const double time : times) instants.push_back(instant_at(scene, time));
  return instants;
}

// A furnace of Le = 1 and rho = 0.5: each m^2 emits pi, so what is reflected is
// 0.5 / pi * pi / (1 - 0.5) = 1, and with Le the known 2 = Le / (1 - rho).
TEST(Power, FurnaceReflectsOne) {
  Scene scene;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  EXPECT_NEAR(expected_mean_radiance(scene, instants_of(scene, {0})), 1, 1e-6);
}

// A room of 52 m^2 and rho = 0.2 with a lamp of 1 m^2, rho = 0 and Le = (3, 6, 9), mean 6: power 6 pi, area
// 53, mean rho = 0.2 * 52 / 53. A glow that falls from 1 to 0 leaves half the mean of its two ends.
TEST(Power, LampAndItsGlow) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.2f, 0.2f, 0.2f});
  const uint32_t lamp =
      add_polygon(&scene, {{1, 1, 1.9}, {1, 2, 1.9}, {2, 2, 1.9}, {2, 1, 1.9}}, 0, {}, {3, 6, 9});
  const double rho = 0.2 * 52 / 53, expected = rho / kPi * 6 * kPi / 53 / (1 - rho);
  EXPECT_NEAR(expected_mean_radiance(scene, instants_of(scene, {0, 1})), expected, 1e-6);
  Glow glow;
  glow.material = scene.polygons[lamp].material;
  glow.keys = {{0, 1}, {1, 0}};
  scene.glows.push_back(glow);
  EXPECT_NEAR(expected_mean_radiance(scene, instants_of(scene, {0, 1})), expected / 2, 1e-6);
}

// A spotlight's falloff s = smoothstep(cos outer, cos inner, cos) has the mean 1/2 between its cones, by the
// symmetry of s(x) + s(1 - x) = 1. So its power is 2 pi ((1 - cos inner) + (cos inner - cos outer) / 2): for
// cones of 60 and 90 degrees 2 pi (0.5 + 0.25) = 1.5 pi of the intensity.
TEST(Power, Spotlight) {
  Scene scene;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true, 0, {0.5f, 0.5f, 0.5f});
  add_spot(&scene, {2, 1, 1}, {2, 1, 0}, kPi / 3, kPi / 2, {2, 2, 2});
  EXPECT_NEAR(expected_mean_radiance(scene, instants_of(scene, {0})),
              0.5 / kPi * 2 * 1.5 * kPi / 52 / (1 - 0.5), 1e-6);
}

// White surfaces in an open scene lose light that the formula does not know of: rho counts as 0.9 at most.
TEST(Power, WhiteCountsAsNineTenths) {
  Scene scene;
  add_box(&scene, {0, 0, 0}, {1, 1, 1}, true, 0, {1, 1, 1}, {1, 1, 1});
  EXPECT_NEAR(expected_mean_radiance(scene, instants_of(scene, {0})), 0.9 / (1 - 0.9), 1e-5);
}

TEST(Power, NothingFromNothing) {
  EXPECT_EQ(expected_mean_radiance(Scene{}, instants_of(Scene{}, {0})), 0);
  Scene dark;
  add_box(&dark, {0, 0, 0}, {1, 1, 1}, true);
  EXPECT_EQ(expected_mean_radiance(dark, instants_of(dark, {0})), 0);
}

}  // namespace
}  // namespace strad
