// Six lobes: no power lost, boxes along the axes exact.
#include "solve/links/lobes.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "workbench.h"

namespace strad {
namespace {

Vec3 direction(uint64_t seed) {
  const double z = 2 * unit_from(hash_of(seed, 1)) - 1, phi = 2 * kPi * unit_from(hash_of(seed, 2));
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

TEST(Lobes, WeightsOfANormalAddUpToOne) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    const Vec3 n = direction(seed);
    const LobeWeights w = lobes_of_normal(n);
    float sum = 0;
    for (int l = 0; l < 3; ++l) {
      sum += w.weight[l];
      EXPECT_EQ(w.lobe[l] / 2, l);
      EXPECT_EQ(w.lobe[l] % 2, n[l] < 0 ? 1 : 0);
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

// What arrives from a direction has the kernel for its mean over the area, whichever way the surfaces face.
TEST(Lobes, WeightsTowardsADirectionHaveMeanOne) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    float share[kLobes], all = 0;
    for (uint64_t l = 0; l < kLobes; ++l)
      all += share[l] = 0.1f + static_cast<float>(unit_from(hash_of(seed, l, 3)));
    for (float& s : share) s /= all;
    const double far = 0.01 + 100 * unit_from(hash_of(seed, 7));
    const LobeWeights w = lobes_towards(far * direction(seed), share);
    float mean = 0;
    for (int l = 0; l < 3; ++l) mean += share[w.lobe[l]] * w.weight[l];
    EXPECT_NEAR(mean, 1, 1e-5);
  }
}

// Where next to nothing faces, weights stay bounded.
TEST(Lobes, NothingIsShownFromBehind) {
  const float share[kLobes] = {0, 1, 0, 0, 0, 0};  // all of it faces -x
  const LobeWeights w = lobes_towards({1, 0.001, 0}, share);
  for (int l = 0; l < 3; ++l) {
    EXPECT_EQ(w.lobe[l] == 1 ? w.weight[l] : 0, 0);
    EXPECT_LT(w.weight[l], 60);
  }
}

// A box along the axes has the outline of its three visible sides, each by the cosine, and each side receives
// from far away by its cosine alone.
TEST(Lobes, ABoxIsExact) {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {3, 2, 1}, false);
  const Workbench bench(scene, 1, 1, Roots::kClusters);
  const float* share = bench.cluster(0).lobe_share;
  const double area_of[3] = {2, 3, 6};  // of a side across x, y, z
  EXPECT_NEAR(bench.node(0).area, 22, 1e-5);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) EXPECT_NEAR(share[2 * axis + side] * 22, area_of[axis], 1e-5);
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const Vec3 d = direction(seed);
    const double outline =
        area_of[0] * std::abs(d.x) + area_of[1] * std::abs(d.y) + area_of[2] * std::abs(d.z);
    const LobeWeights w = lobes_towards(d, share);
    for (int l = 0; l < 3; ++l)
      EXPECT_NEAR(w.weight[l], std::abs(d[l]) * 22 / outline, 1e-4);  // 1 is the mean of all 22 m^2
  }
}

}  // namespace
}  // namespace strad
