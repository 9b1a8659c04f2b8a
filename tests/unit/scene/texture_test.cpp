// Colours of textures.
#include "scene/texture.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

// Two columns, two rows: upper row red, black; lower row white, blue.
Texture four_texels() {
  Texture texture;
  texture.width = texture.height = 2;
  texture.srgb = {255, 0, 0, 0, 0, 0, 255, 255, 255, 0, 0, 255};
  return texture;
}

TEST(Texture, TexelCentres) {
  const Texture texture = four_texels();
  EXPECT_EQ(texture_colour(texture, {0.25, 0.75}), (Rgb{1, 0, 0}));  // v points up
  EXPECT_EQ(texture_colour(texture, {0.25, 0.25}), (Rgb{1, 1, 1}));
  EXPECT_EQ(texture_colour(texture, {0.75, 0.25}), (Rgb{0, 0, 1}));
}

TEST(Texture, LinearBetweenCentres) {
  const Rgb middle = texture_colour(four_texels(), {0.5, 0.5});
  EXPECT_NEAR(middle.r, 0.5, 1e-6);
  EXPECT_NEAR(middle.g, 0.25, 1e-6);
  EXPECT_NEAR(middle.b, 0.5, 1e-6);
}

TEST(Texture, Repeats) {
  const Texture texture = four_texels();
  for (const Vec2 uv : {Vec2{0.1, 0.3}, Vec2{0.9, 0.99}}) {
    const Rgb here = texture_colour(texture, uv), far = texture_colour(texture, {uv.x - 3, uv.y + 2});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(here[c], far[c], 1e-5);
  }
}

TEST(Texture, ClampedOnesGoOnFromTheirEdges) {
  Texture texture = four_texels();
  texture.clamp = true;
  for (const Vec2 uv : {Vec2{0.25, 0.75}, Vec2{0, 1}, Vec2{-3, 7}, Vec2{0.1, 100}})
    EXPECT_EQ(texture_colour(texture, uv), (Rgb{1, 0, 0}));
  EXPECT_EQ(texture_colour(texture, {1e30, -1e30}), (Rgb{0, 0, 1}));
  EXPECT_NEAR(texture_colour(texture, {0.5, 5}).r, 0.5, 1e-6);  // between red and black
}

TEST(Texture, BytesAreOnTheSrgbCurve) {
  Texture grey;
  grey.width = grey.height = 1;
  grey.srgb = {188, 188, 188};  // half in linear light: ((188/255 + 0.055) / 1.055)^2.4 = 0.503
  EXPECT_NEAR(texture_colour(grey, {0.3, 0.3}).g, 0.503, 5e-4);
}

// Upper row red and black, lower row white and blue: each polygon has the mean of what it shows.
TEST(Texture, MeansAreOfThePartThatIsShown) {
  const Texture texture = four_texels();
  Scene scene;
  scene.uvs = {{0, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Polygon part{{0, 1, 2, 3}, {0, 1, 2, 3}, 0, 0}, all{{0, 1, 2, 3}, {4, 5, 6, 7}, 0, 0};
  const Rgb whole = mean_colour(texture), sampled = mean_colour(scene, all, texture);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(whole[c], c == 1 ? 0.25 : 0.5, 1e-6);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sampled[c], whole[c], 0.1);
  const Rgb red = mean_colour(scene, part, texture);
  EXPECT_GT(red.r, 2 * red.g);
  EXPECT_GT(red.r, 2 * red.b);
}

TEST(Texture, HostileCoordinatesGiveBlack) {
  EXPECT_EQ(texture_colour(four_texels(), {NAN, 0}), Rgb{});
  EXPECT_EQ(texture_colour(four_texels(), {0, INFINITY}), Rgb{});
}

TEST(Texture, CoordinatesFollowTheCorners) {
  Scene scene;
  scene.uvs = {{0, 0}, {2, 0}, {2, 4}, {0, 4}};
  const Polygon quad{{0, 1, 2, 3}, {0, 1, 2, 3}, 0, 0};
  EXPECT_EQ(texture_uv(scene, quad, {0.5, 0.25}), (Vec2{1, 1}));
  const Polygon triangle{{0, 1, 2, kNone}, {0, 1, 2, kNone}, 0, 0};
  EXPECT_EQ(texture_uv(scene, triangle, {0.25, 0.5}), (Vec2{1.5, 2}));  // corner 1 weighs 1/4, corner 2 1/2
}

}  // namespace
}  // namespace strad
