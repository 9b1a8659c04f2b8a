// A picture on several polygons is a mean for each, and a lamp keeps its material.
#include "solve/prepare/mean_reflectance.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

TEST(MeanReflectance, EachPolygonHasThatOfItsPart) {
  Scene scene;
  scene.objects.push_back({"wall", 0});
  // 64 texels in a row: the left half black, the right half white.
  Texture texture{"halves", 64, 1, {}};
  for (int i = 0; i < 64; ++i) texture.srgb.insert(texture.srgb.end(), 3, i < 32 ? 0 : 255);
  scene.textures.push_back(texture);
  scene.materials.push_back({"picture", {0.8f, 0.6f, 0.4f}, {}, 0});
  scene.materials.push_back({"lamp", {0.5f, 0.5f, 0.5f}, {1, 1, 1}, 0});
  scene.materials.push_back({"plain", {0.1f, 0.2f, 0.3f}, {}, kNone});
  const auto add = [&](double u0, double u1, uint32_t material, bool coordinates) {
    Polygon polygon;
    for (const Vec2 uv : {Vec2{u0, 0}, Vec2{u1, 0}, Vec2{u1, 1}, Vec2{u0, 1}}) {
      const size_t c = scene.vertices.size() % 4;
      polygon.corners[c] = static_cast<uint32_t>(scene.vertices.size());
      if (coordinates) polygon.uvs[c] = static_cast<uint32_t>(scene.uvs.size());
      scene.vertices.push_back({uv.x, uv.y, 0});
      scene.uvs.push_back(uv);
    }
    polygon.material = material;
    scene.polygons.push_back(polygon);
  };
  add(0.1, 0.4, 0, true);    // black
  add(0.6, 0.9, 0, true);    // white
  add(0.25, 0.75, 0, true);  // half of each
  add(0.6, 0.7, 0, true);    // white again: the same material
  add(0, 1, 1, true);        // the lamp
  add(0, 1, 0, false);       // no coordinates: no texture, as in frames
  add(0, 1, 2, true);
  const Scene flat = with_mean_reflectances(scene);
  EXPECT_TRUE(flat.textures.empty());
  const auto reflectance = [&](size_t p) { return flat.materials[flat.polygons[p].material].reflectance; };
  EXPECT_NEAR(reflectance(0).r, 0, 1e-4);
  EXPECT_NEAR(reflectance(1).r, 0.8, 1e-4);
  EXPECT_NEAR(reflectance(1).b, 0.4, 1e-4);
  EXPECT_NEAR(reflectance(2).r, 0.4, 0.02);
  EXPECT_EQ(flat.polygons[3].material, flat.polygons[1].material);
  EXPECT_EQ(flat.polygons[4].material, 1u);  // glows are told by material
  EXPECT_NEAR(reflectance(4).r, 0.25, 0.01);
  EXPECT_EQ(reflectance(5), (Rgb{0.8f, 0.6f, 0.4f}));
  EXPECT_EQ(reflectance(6), (Rgb{0.1f, 0.2f, 0.3f}));
}

}  // namespace
}  // namespace strad
