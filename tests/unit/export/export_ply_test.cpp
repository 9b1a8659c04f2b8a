// PLY frames, byte for byte.
#include <gtest/gtest.h>

#include <cstring>

#include "export/ply/ply.h"
#include "export_scene.h"
#include "image/srgb.h"

namespace strad {
namespace {

float float_at(const std::string& bytes, size_t offset) {
  float value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct Ply {
  std::string header, body;
};
Ply split(const std::string& bytes) {
  const std::string end = "end_header\n";
  const size_t at = bytes.find(end) + end.size();
  return {bytes.substr(0, at), bytes.substr(at)};
}

// L = 0.5 * (2 + 1) / pi = 0.47746 on a square that has moved by (0, 0, 3).
TEST(PlyExport, HoldsWorldPositionsAndRadiance) {
  Scene scene = square_scene();
  scene.bodies.push_back(
      {.name = "lift",
       .keys = {{.time = 0, .move = {0, 0, 0}, .quat = {}}, {.time = 1, .move = {0, 0, 6}, .quat = {}}}});
  scene.objects[0].body = 1;
  MeshBuilder builder(scene);
  builder.face(0, 0);
  const Solution solution{{lit_slab(
      scene, builder.take(), [](Vec3) { return grey(2); }, [](Vec3) { return grey(1); })}};
  const Ply ply = split(PlyExport(scene, solution).frame(0.5));
  EXPECT_EQ(ply.header.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0u);
  EXPECT_NE(ply.header.find("element vertex 4\n"), std::string::npos);
  EXPECT_NE(ply.header.find("element face 2\n"), std::string::npos);
  ASSERT_EQ(ply.body.size(), 4u * 27 + 2 * 13);
  const float radiance = static_cast<float>(0.5 * 3 / kPi);
  for (size_t v = 0; v < 4; ++v) {
    EXPECT_FLOAT_EQ(float_at(ply.body, 27 * v + 8), 3);
    EXPECT_EQ(static_cast<uint8_t>(ply.body[27 * v + 12]), srgb_byte(radiance));
    EXPECT_NEAR(float_at(ply.body, 27 * v + 15), radiance, 1e-6f);
  }
  EXPECT_EQ(ply.body[4 * 27], 3);
}

TEST(PlyExport, ExposureScalesBytesOnly) {
  const Scene scene = square_scene();
  MeshBuilder builder(scene);
  builder.face(0, 0);
  const Solution solution{{lit_slab(
      scene, builder.take(), [](Vec3) { return grey(1); }, [](Vec3) { return grey(0); })}};
  const PlyExport ply(scene, solution);
  const std::string plain = split(ply.frame(0)).body, bright = split(ply.frame(0, 1)).body;
  EXPECT_EQ(float_at(plain, 15), float_at(bright, 15));
  EXPECT_EQ(static_cast<uint8_t>(bright[12]), srgb_byte(static_cast<float>(1 / kPi)));
}

// A smooth square whose body is turned by 90 degrees about z: normals are turned with it, and on the back are
// those of the back. Its corners have the normal (3, 0, 4) / 5, which becomes (0, 3, 4) / 5.
TEST(PlyExport, HasNormalsWhereSurfacesAreSmooth) {
  Scene scene = square_scene();
  scene.normals = {{0.6, 0, 0.8}};
  for (uint32_t& normal : scene.polygons[0].normals) normal = 0;
  scene.bodies.push_back(
      {.name = "turn", .axis = {0, 0, 1}, .keys = {{.time = 0, .move = {}, .turn = kPi / 2, .quat = {}}}});
  scene.objects[0].body = 1;
  MeshBuilder builder(scene);
  builder.face(0, 0);
  builder.face(0, 1);
  const Solution solution{{lit_slab(
      scene, builder.take(), [](Vec3) { return grey(1); }, [](Vec3) { return grey(0); })}};
  const Ply ply = split(PlyExport(scene, solution).frame(0.5));
  EXPECT_NE(ply.header.find("property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                            "property uchar red\n"),
            std::string::npos);
  ASSERT_EQ(ply.body.size(), 8u * 39 + 4 * 13);
  for (size_t v = 0; v < 8; ++v) {
    const float side = v < 4 ? 1 : -1;
    EXPECT_NEAR(float_at(ply.body, 39 * v + 12), 0, 1e-6f);
    EXPECT_NEAR(float_at(ply.body, 39 * v + 16), side * 0.6f, 1e-6f);
    EXPECT_NEAR(float_at(ply.body, 39 * v + 20), side * 0.8f, 1e-6f);
  }
}

}  // namespace
}  // namespace strad
