// Pictures of small scenes with known answers.
#include "frame/raster.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "frame/tile.h"
#include "synthetic.h"

namespace strad {
namespace {

RasterOptions small(uint32_t width = 24, uint32_t height = 16) {
  RasterOptions options;
  options.width = width, options.height = height;
  return options;
}

void expect_even(const Image& image, Rgb value, float tolerance) {
  for (const Rgb& pixel : image.pixels) {
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], value[c], tolerance);
  }
}

// A room that neither emits nor is lit but by its solution: L = rho E / pi at every pixel.
TEST(Raster, EvenSolutionGivesAnEvenPicture) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.25f, 0.8f}, {});
  add_camera(&scene, {1, 1, 1}, {3, 2, 0.9}, {0, 0, 1}, 100);
  Raster raster(scene);
  const Slab slab = even_slab(scene, {2, 4, 1});
  const Rgb expected{static_cast<float>(1 / kPi), static_cast<float>(1 / kPi), static_cast<float>(0.8 / kPi)};
  for (const bool flat : {false, true}) {
    for (const DirectFrom direct : {DirectFrom::kPixel, DirectFrom::kMesh}) {
      RasterOptions options = small();
      options.flat = flat, options.direct = direct;
      expect_even(raster.render(slab, scene.cameras[0], 0, options), expected, 1e-6f);
    }
  }
}

// A furnace: Le = 1 and rho = 0.5 everywhere, so L = Le / (1 - rho) = 2. Of E = 2 pi, emitters bring pi
// directly (which the renderer finds itself) and the solution has the other pi.
TEST(Raster, FurnaceWithDirectLightPerPixel) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  add_camera(&scene, {1, 1, 1}, {3, 2, 0.9}, {0, 0, 1}, 100);
  Raster raster(scene);
  const float pi = static_cast<float>(kPi);
  const Slab slab = even_slab(scene, {pi, pi, pi});
  for (const double shutter : {0.0, 0.1}) {
    RasterOptions options = small();
    options.shutter = shutter;
    expect_even(raster.render(slab, scene.cameras[0], 0, options), {2, 2, 2}, 1e-4f);
  }
}

// E = x on a floor seen from straight above: pixels are means of a linear function, so each has its middle's
// value.
TEST(Raster, LinearSolutionGivesALinearPicture) {
  Scene scene;
  add_quad(&scene, {0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {1, 1, 1});
  add_camera(&scene, {4, 4, 4}, {4, 4, 0}, {0, 1, 0}, 90);  // sees x and y in [0, 8]
  Raster raster(scene);
  const Slab slab = plain_slab(scene, 0, 0, [](Vec3 p) {
    const float e = static_cast<float>(kPi * (3 + p.x));
    return Rgb{e, e, e};
  });
  const Image image = raster.render(slab, scene.cameras[0], 0, small(16, 16));
  // Pixels at the border are left out: their corners touch the floor's very edge.
  for (uint32_t y = 1; y < 15; ++y) {
    for (uint32_t x = 1; x < 15; ++x) EXPECT_NEAR(image.at(x, y).r, 3 + (x + 0.5) / 2, 2e-5);
  }
}

// A bright half plane whose edge cuts pixels at a known place: each is covered by its share.
TEST(Raster, EdgesAreCoveredByArea) {
  Scene scene;
  add_quad(&scene, {4.0 + 3 / 8.0, -50, 0}, {60, -50, 0}, {60, 60, 0}, {4.0 + 3 / 8.0, 60, 0}, {1, 1, 1});
  add_camera(&scene, {4, 4, 4}, {4, 4, 0}, {0, 1, 0}, 90);
  Raster raster(scene);
  const float pi = static_cast<float>(kPi);
  RasterOptions options = small(8, 8);  // pixels of 1 m
  options.samples = 64;
  const Image image = raster.render(even_slab(scene, {pi, pi, pi}), scene.cameras[0], 0, options);
  for (uint32_t y = 0; y < 8; ++y) {
    EXPECT_EQ(image.at(3, y).r, 0);
    EXPECT_NEAR(image.at(4, y).r, 5 / 8.0, 1 / 32.0);
    EXPECT_NEAR(image.at(5, y).r, 1, 1e-6);
  }
}

// A lamp over a floor: the middle of the picture has the closed form's value (see lights_test), to the noise
// of none.
TEST(Raster, LampOverAFloor) {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {1, 1, 1});
  add_quad(&scene, {-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {}, {3, 3, 3});
  add_camera(&scene, {0, 0, 1.5}, {0, 0, 0}, {0, 1, 0}, 5);
  Raster raster(scene);
  const Image image = raster.render(even_slab(scene, {}), scene.cameras[0], 0, small(9, 9));
  const double r = 0.5 / std::sqrt(1.25), expected = 3 * 4 * r * std::atan(r) / kPi;
  EXPECT_NEAR(image.at(4, 4).r, expected, 1e-3 * expected);
}

// Its shadow under a screen: half way between light and dark exactly under the screen's edge, and even along
// it.
TEST(Raster, PenumbraIsSmooth) {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {1, 1, 1});
  add_quad(&scene, {-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}, {}, {3, 3, 3});
  add_quad(&scene, {0, -5, 1}, {5, -5, 1}, {5, 5, 1}, {0, 5, 1});
  add_camera(&scene, {-0.4, 0, 0.8}, {0, 0, 0}, {0, 1, 0}, 40);
  Raster raster(scene);
  const Image image = raster.render(even_slab(scene, {}), scene.cameras[0], 0, small(48, 32));
  double high = 0;
  for (const Rgb& pixel : image.pixels) high = std::max(high, static_cast<double>(pixel.g));
  for (uint32_t y = 1; y < 32; ++y) {
    for (uint32_t x = 1; x < 48; ++x) {
      EXPECT_LE(image.at(x, y).g, image.at(x - 1, y).g + 0.01 * high);   // ever darker towards the screen
      EXPECT_NEAR(image.at(x, y).g, image.at(x, y - 1).g, 0.03 * high);  // and the same along its edge
    }
  }
  EXPECT_NEAR(image.at(23, 16).g, 0.5 * high, 0.1 * high);
}

Scene busy_scene() {
  Scene scene;
  scene.end = 1;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.6f, 0.7f}, {});
  add_quad(&scene, {1, 1, 1.99}, {1, 2, 1.99}, {2, 2, 1.99}, {2, 1, 1.99}, {}, {5, 5, 5});
  add_quad(&scene, {1.5, 1, 0.5}, {2.5, 1, 0.5}, {2.5, 2, 0.8}, {1.5, 2, 0.8});
  scene.bodies.push_back({});
  scene.bodies.back().name = "board";
  scene.bodies.back().keys = {{0, {0, 0, 0}, 0, false, {}}, {1, {1, 0.5, 0.3}, 1, false, {}}};
  scene.objects.back().body = 1;
  scene.spots.push_back({"key", 1, 0.3, 0.5, {{0, {2, 1.5, 1.8}, {2, 1.5, 0}, {8, 4, 2}}}});
  add_camera(&scene, {0.3, 0.3, 1.5}, {3, 2, 0.5}, {0, 0, 1}, 80);
  return scene;
}

TEST(Raster, AnyNumberOfThreadsGivesTheSamePicture) {
  const Scene scene = busy_scene();
  const Slab slab = even_slab(scene, {1, 1, 1});
  for (const double shutter : {0.0, 0.2}) {
    RasterOptions options = small(100, 70);
    options.shutter = shutter;
    set_thread_count(1);
    const Image one = Raster(scene).render(slab, scene.cameras[0], 0.4, options);
    set_thread_count(2);
    const Image two = Raster(scene).render(slab, scene.cameras[0], 0.4, options);
    EXPECT_EQ(one, two);
  }
}

TEST(Raster, PicturesDoNotDependOnEarlierOnes) {
  const Scene scene = busy_scene();
  const Slab slab = even_slab(scene, {1, 1, 1});
  Raster raster(scene);
  raster.render(slab, scene.cameras[0], 0.1, small());
  EXPECT_EQ(raster.render(slab, scene.cameras[0], 0.4, small()),
            Raster(scene).render(slab, scene.cameras[0], 0.4, small()));
}

// Halves of a floor that light up and darken with the screen that passes between lamp and floor: the
// shutter's mean is near that of many still pictures.
TEST(Raster, BlurIsTheMeanOfInstants) {
  const Scene scene = busy_scene();
  const Slab slab = even_slab(scene, {1, 1, 1});
  Raster raster(scene);
  RasterOptions options = small(36, 24);
  Image sum(36, 24);
  const int count = 64;
  for (int i = 0; i < count; ++i) {
    const Image still = raster.render(slab, scene.cameras[0], 0.3 + 0.4 * (i + 0.5) / count, options);
    for (size_t p = 0; p < sum.pixels.size(); ++p) sum.pixels[p] += (1.0f / count) * still.pixels[p];
  }
  options.shutter = 0.4;
  options.samples = 64;
  const Image blurred = raster.render(slab, scene.cameras[0], 0.3, options);
  double error = 0, mean = 0;
  for (size_t p = 0; p < sum.pixels.size(); ++p) {
    error += std::pow(luminance(blurred.pixels[p]) - luminance(sum.pixels[p]), 2);
    mean += luminance(sum.pixels[p]);
  }
  const double pixels = static_cast<double>(sum.pixels.size());
  EXPECT_LT(std::sqrt(error / pixels), 0.04 * mean / pixels);
}

// A bump of light in time only: open for the whole of it, the shutter sees its mean.
TEST(Raster, ShutterTakesTheMeanOfTheSolution) {
  Scene scene;
  scene.end = 1;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {1, 1, 1}, {});
  add_camera(&scene, {1, 1, 1}, {3, 2, 0.9}, {0, 0, 1}, 100);
  Slab slab = even_slab(scene, {0, 0, 0});
  // E(t) = 12 pi t^2 in every row: Gauss nodes of order 3; its mean over [0, 1] is 4 pi, over [0, 1/2] pi.
  slab.grid.order = slab.indirect.order = slab.direct.order = 3;
  slab.indirect.coefficients.clear();
  for (size_t row = 0; row < slab.mesh.vertices.size(); ++row) {
    for (int i = 0; i < 3; ++i) {
      const float e = static_cast<float>(12 * kPi * gauss_nodes(3)[i] * gauss_nodes(3)[i]);
      slab.indirect.coefficients.push_back({e, e, e});
    }
  }
  Raster raster(scene);
  RasterOptions options = small();
  options.shutter = 1;
  expect_even(raster.render(slab, scene.cameras[0], 0, options), {4, 4, 4}, 1e-4f);
  options.shutter = 0.5;
  expect_even(raster.render(slab, scene.cameras[0], 0, options), {1, 1, 1}, 1e-4f);
}

// Sides without a face get no indirect light; emitters show from their front only.
TEST(Raster, DarkSidesAndEmitters) {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {0.5f, 0.5f, 0.5f}, {7, 6, 5});
  Slab slab = even_slab(scene, {2, 2, 2});
  slab.mesh.face_of_side[1] = kNone;
  add_camera(&scene, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 60);
  add_camera(&scene, {0, 0, -1}, {0, 0, 0}, {0, 1, 0}, 60);
  Raster raster(scene);
  const float reflected = static_cast<float>(0.5 * 2 / kPi);
  expect_even(raster.render(slab, scene.cameras[0], 0, small()),
              {7 + reflected, 6 + reflected, 5 + reflected}, 1e-5f);
  expect_even(raster.render(slab, scene.cameras[1], 0, small()), {0, 0, 0}, 0);
}

}  // namespace
}  // namespace strad
