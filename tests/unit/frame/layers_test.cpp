// Layers of frames: light adds up to the frame, and geometry is what camera rays find.
#include <gtest/gtest.h>

#include "base/error.h"
#include "frame/layered_frame.h"
#include "synthetic.h"

namespace strad {
namespace {

const std::vector<LayerKind> kAll = parse_layers("--layers", "all");

const Layer& find(const LayeredImage& image, const std::string& name) {
  for (const Layer& layer : image.layers)
    if (layer.name == name) return layer;
  throw BadInput("no layer " + name);
}

const float* pixel(const LayeredImage& image, const std::string& name, uint32_t x, uint32_t y) {
  const Layer& layer = find(image, name);
  return &layer.samples[layer.channels.size() * (size_t{y} * image.width + x)];
}

RasterOptions sized(uint32_t width, uint32_t height) {
  RasterOptions options;
  options.width = width, options.height = height;
  return options;
}

// Le = 1, rho = 0.5 everywhere, and the solution has an indirect irradiance of 2 pi: of the radiance of
// 1 + 0.5 (pi + 2 pi) / pi = 2.5, emission is 1, direct light 0.5 and indirect light 1. Twice as much with
// one stop of exposure.
TEST(Layers, LightIsDividedByItsOrigin) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  add_camera(&scene, {1, 1, 1}, {3, 2, 0.9}, {0, 0, 1}, 100);
  Raster raster(scene);
  const float pi = static_cast<float>(kPi);
  const Slab slab = even_slab(scene, {2 * pi, 2 * pi, 2 * pi});
  for (const double shutter : {0.0, 0.1}) {
    for (const int samples : {1, 16}) {
      RasterOptions options = sized(12, 8);
      options.shutter = shutter, options.samples = samples;
      const LayeredImage image = render_layers(&raster, scene, slab, scene.cameras[0], 0, options, 1, kAll);
      for (uint32_t x = 0; x < 12; ++x) {
        EXPECT_NEAR(*pixel(image, "", x, 3), 5, 1e-3);
        EXPECT_NEAR(*pixel(image, "direct", x, 3), 1, 1e-3);
        EXPECT_NEAR(*pixel(image, "indirect", x, 3), 2, 1e-3);
        EXPECT_EQ(*pixel(image, "emission", x, 3), 2);
        EXPECT_EQ(*pixel(image, "albedo", x, 3), 0.5f);
      }
    }
  }
}

// With all light from the mesh, which has as much direct as indirect light here, the parts are the same.
TEST(Layers, LightOfTheMeshIsDividedToo) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.5f, 0.5f}, {});
  add_camera(&scene, {1, 1, 1}, {3, 2, 0.9}, {0, 0, 1}, 100);
  Raster raster(scene);
  Slab slab = even_slab(scene, {3, 3, 3});
  slab.direct = slab.indirect;
  RasterOptions options = sized(6, 4);
  options.direct = DirectFrom::kMesh;
  const LayeredImage image = render_layers(&raster, scene, slab, scene.cameras[0], 0, options, 0, kAll);
  EXPECT_NEAR(*pixel(image, "", 2, 2), 3 / kPi, 1e-6);
  EXPECT_NEAR(*pixel(image, "direct", 2, 2), 1.5 / kPi, 1e-6);
  EXPECT_NEAR(*pixel(image, "indirect", 2, 2), 1.5 / kPi, 1e-6);
}

// A furnace with a radiance of 2.5 as above, all light from the mesh, with a mirror of 0.8 before the camera
// and a block of clear glass: in the mirror it is 2. Glass shares all light out among what it mirrors,
// 2 R / (1 + R) with R = 0.04, and there shows the mirror behind the camera, and what goes on to the wall:
// that is 2.5 - 0.5 * 0.08 / 1.04. All of that is specular.
TEST(Layers, WhatMirrorsAndGlassShowIsALayerOfItsOwn) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.5f, 0.5f}, {1, 1, 1});
  add_camera(&scene, {2, 1.5, 1}, {4, 1.5, 1}, {0, 0, 1}, 60);
  const auto size = [&] { return static_cast<uint32_t>(scene.materials.size()); };
  const uint32_t mirror = size();
  add_quad(&scene, {3.9, 2.9, 0.1}, {3.9, 0.1, 0.1}, {3.9, 0.1, 1.9}, {3.9, 2.9, 1.9}, {});
  scene.materials[mirror].finish.specular = {0.8f, 0.8f, 0.8f};
  const uint32_t walls = size();
  add_room(&scene, {0.1, 1, 0.5}, {0.4, 2, 1.5}, {}, {});
  Polygon* const glass = &scene.polygons[scene.polygons.size() - 6];
  for (uint32_t p = 0; p < 6; ++p) glass[p].material = walls, glass[p].object = glass[0].object;
  scene.materials[walls].finish = {{1, 1, 1}, 0, {1, 1, 1}, 1.5f, true, false};
  Raster raster(scene);
  const float pi = static_cast<float>(kPi);
  const Slab slab = even_slab(scene, {3 * pi, 3 * pi, 3 * pi});  // 1 + 0.5 * 3 pi / pi = 2.5
  RasterOptions options = sized(12, 8);
  options.direct = DirectFrom::kMesh;
  const std::vector<LayerKind> kinds = parse_layers("", "combined,direct,indirect,emission,specular");
  const LayeredImage at_mirror = render_layers(&raster, scene, slab, scene.cameras[0], 0, options, 0, kinds);
  scene.cameras[0].keys[0].to = {0, 1.5, 1};
  const LayeredImage at_glass = render_layers(&raster, scene, slab, scene.cameras[0], 0, options, 0, kinds);
  EXPECT_NEAR(*pixel(at_mirror, "specular", 1, 4), 2, 0.02);  // away from the image of the glass
  EXPECT_NEAR(*pixel(at_glass, "specular", 5, 4), 2.5 - 0.5 * 0.08 / 1.04, 0.01);
  for (const LayeredImage* image : {&at_mirror, &at_glass})
    for (uint32_t y = 0; y < 8; ++y)
      for (uint32_t x = 0; x < 12; ++x) {
        float sum = 0;
        for (const char* name : {"direct", "indirect", "emission", "specular"})
          sum += *pixel(*image, name, x, y);
        EXPECT_NEAR(sum, *pixel(*image, "", x, y), 1e-5);
      }
}

// A camera 2 m above a floor that ends at x = 0, looking down, 90 degrees high: the picture is 4 m high, and
// with 8 x 8 pixels a pixel is half a metre wide.
Scene floor_from_above() {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {0.125, -9, 0}, {0.125, 9, 0}, {-9, 9, 0}, {0.2f, 0.4f, 0.6f});
  add_camera(&scene, {0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 90);
  return scene;
}

TEST(Layers, GeometryIsWhatTheMiddleOfAPixelSees) {
  const Scene scene = floor_from_above();
  Raster raster(scene);
  const Slab slab = even_slab(scene, {1, 1, 1});
  const LayeredImage image = render_layers(&raster, scene, slab, scene.cameras[0], 0, sized(8, 8), 0,
                                           parse_layers("", "depth,normal,position"));
  ASSERT_EQ(image.layers.size(), 3u);
  EXPECT_NEAR(*pixel(image, "depth", 1, 2), 2, 1e-5);  // along the axis: the same all over the floor
  EXPECT_EQ(*pixel(image, "depth", 7, 2), 1e10f);
  // Pixel (1, 2): 2.5 pixels left of the middle, 1.5 above it.
  const float* position = pixel(image, "position", 1, 2);
  EXPECT_NEAR(position[0], -1.25, 1e-5);
  EXPECT_NEAR(position[1], 0.75, 1e-5);
  EXPECT_NEAR(position[2], 0, 1e-5);
  EXPECT_EQ(pixel(image, "normal", 1, 2)[2], 1);
}

TEST(Layers, MattesAndAlbedoCoverAsMuchAsIsSeen) {
  const Scene scene = floor_from_above();
  Raster raster(scene);
  const Slab slab = even_slab(scene, {1, 1, 1});
  RasterOptions options = sized(8, 8);
  options.samples = 64;
  const LayeredImage image = render_layers(&raster, scene, slab, scene.cameras[0], 0, options, 0,
                                           parse_layers("", "object,material,albedo"));
  // The floor ends a quarter of the way through the pixel right of the middle.
  EXPECT_EQ(pixel(image, "CryptoObject00", 3, 5)[1], 1);
  EXPECT_NEAR(pixel(image, "CryptoObject00", 4, 5)[1], 0.25, 0.02);
  EXPECT_NEAR(pixel(image, "CryptoMaterial00", 4, 5)[1], 0.25, 0.02);
  EXPECT_EQ(pixel(image, "CryptoObject00", 5, 5)[1], 0);
  EXPECT_NEAR(pixel(image, "albedo", 4, 5)[1], 0.25 * 0.4, 0.01);
}

// A box that moves and turns, before a camera that moves too. The point that is seen at a pixel is seen
// again, by camera rays of the next frame, where the motion vector says: at the same place on the box.
TEST(Layers, MotionVectorsFindTheSamePointAgain) {
  Scene scene;
  add_room(&scene, {-1, -1, -1}, {1, 1, 1}, {0.5f, 0.5f, 0.5f}, {});
  scene.end = 2;
  scene.rate = 10;
  scene.bodies.push_back({"box", 0, {0.3, 0, 0}, {0, 1, 0}, Ease::kLinear, {}, {}});
  scene.bodies[1].keys = {{0, {0, 0, 0}, 0, false, {}}, {2, {3, 0.5, -1}, 4, false, {}}};
  for (Object& object : scene.objects) object.body = 1;
  scene.cameras.push_back(
      {"main", {{0, {1, 2, 6}, {0, 0, 0}, {0, 1, 0}, 0.9}, {2, {2, 3, 7}, {3, 0, 0}, {0, 1, 0}, 0.7}}});
  Raster raster(scene);
  const Slab slab = even_slab(scene, {1, 1, 1});
  const uint32_t width = 60, height = 40;
  const LayeredImage image =
      render_layers(&raster, scene, slab, scene.cameras[0], 1, sized(width, height), 0, kAll);
  const auto rest_at = [&](double time, double x, double y) {
    const Instant instant = instant_at(scene, time);
    const CameraRays rays(camera_at(scene.cameras[0], time), width, height);
    const Sight sight = raster.surfaces().look(instant, rays.from(), rays.direction(x, y));
    return std::pair{sight.point.polygon, inverse(instant.world_from_body[1]) * sight.point.position};
  };
  int found = 0;
  double moved = 0;  // pixels
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const auto [polygon, here] = rest_at(1, x + 0.5, y + 0.5);
      if (polygon == kNone) continue;
      for (const double step : {0.1, -0.1}) {
        const float* uv = pixel(image, step > 0 ? "forward" : "backward", x, y);
        moved += std::abs(uv[0]) + std::abs(uv[1]);
        const auto [again, there] = rest_at(1 + step, x + 0.5 + uv[0], y + 0.5 - uv[1]);
        if (again != polygon) continue;  // hidden by then, or just beyond an edge
        // A pixel is about 0.1 m wide on the box: a thousandth of that.
        EXPECT_NEAR(length(there - here), 0, 1e-4);
        ++found;
      }
    }
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(moved / found, 0.5);
}

TEST(Layers, ListsAreReadStrictly) {
  EXPECT_EQ(kAll.size(), 11u);
  EXPECT_EQ(parse_layers("--layers", "depth,combined,depth"),
            (std::vector<LayerKind>{LayerKind::kDepth, LayerKind::kCombined}));
  for (const char* bad : {"", "depth,", ",depth", "shadow", "all,depth", "Depth"})
    EXPECT_THROW(parse_layers("--layers", bad), BadInput) << bad;
}

TEST(Layers, FilesAreNamedBeforeTheirNumber) {
  EXPECT_EQ(layer_path("a/room.0001.png", "direct"), "a/room.direct.0001.png");
  EXPECT_EQ(layer_path("room_12.png", "direct"), "room.direct_12.png");
  EXPECT_EQ(layer_path("0001.png", "direct"), "direct.0001.png");
  EXPECT_EQ(layer_path("room4.png", "direct"), "room4.direct.png");
}

}  // namespace
}  // namespace strad
