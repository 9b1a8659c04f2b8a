// Facets of a smooth surface look smooth: as the round surface that they stand for would.
#include <gtest/gtest.h>

#include <array>

#include "frame/raster.h"
#include "frame/smooth_joints.h"
#include "synthetic.h"

namespace strad {
namespace {

// A column of radius 1 about the z axis, 4 m high, of `sides` quads, with round normals at its corners.
Scene column(int sides) {
  Scene scene;
  scene.objects.push_back({"column", 0});
  Material grey;
  grey.reflectance = {0.5f, 0.5f, 0.5f};
  scene.materials.push_back(grey);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    for (const double z : {-2.0, 2.0}) scene.vertices.push_back({std::cos(angle), std::sin(angle), z});
    scene.normals.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<uint32_t>(i), b = static_cast<uint32_t>((i + 1) % sides);
    scene.polygons.push_back(
        {{2 * a, 2 * b, 2 * b + 1, 2 * a + 1}, {kNone, kNone, kNone, kNone}, 0, 0, {a, b, b, a}});
  }
  return scene;
}

// A spotlight of 1e6 W/sr at a distance of 1000 m along x gives E = cos(angle) on a round column, to within
// 0.2 %, and 0 from 90 degrees on. Facets of 22.5 degrees seen from straight before the terminator: without a
// remedy those turned away would be black where the round column is lit, by up to sin(22.5 / 2) = 0.2, in
// steps.
TEST(Smooth, ColumnIsLitAsIfRoundUpToTheTerminator) {
  Scene scene = column(16);
  scene.spots.push_back({"sun", 0, 1, 1.2, {{0, {1000, 0, 0}, {0, 0, 0}, {1e6f, 1e6f, 1e6f}}}});
  add_camera(&scene, {0, -30, 0}, {0, 0, 0}, {0, 0, 1}, 4);  // 2.1 m high, x to the right
  validate(scene);
  Raster raster(scene);
  RasterOptions options;
  options.width = 100, options.height = 16;
  options.samples = 1;
  const Image image = raster.render(even_slab(scene, {}), scene.cameras[0], 0, options);
  const CameraRays rays(camera_at(scene.cameras[0], 0), options.width, options.height);
  const Instant instant = instant_at(scene, 0);
  int lit = 0, dark = 0;
  for (uint32_t y = 0; y < options.height; ++y) {
    for (uint32_t x = 0; x < options.width; ++x) {
      const Sight sight = raster.surfaces().look(instant, rays.from(), rays.direction(x + 0.5, y + 0.5));
      if (sight.point.polygon == kNone) continue;
      const Vec3 at = sight.point.position;
      const double cosine = std::max(0.0, at.x / std::hypot(at.x, at.y));
      EXPECT_NEAR(image.at(x, y).r, 0.5 / kPi * cosine, 0.003) << x;
      (cosine > 0 ? lit : dark) += 1;
    }
  }
  EXPECT_GT(lit, 100);
  EXPECT_GT(dark, 100);
}

// Indirect irradiance of i on facet i, the same at all its corners.
Slab facet_slab(const Scene& scene) {
  Slab slab = even_slab(scene, {});
  for (size_t i = 0; i < slab.indirect.coefficients.size(); ++i) {
    const float value = static_cast<float>(i / 8);  // four vertices on each side
    slab.indirect.coefficients[i] = {value, value, value};
  }
  return slab;
}

TEST(Smooth, IndirectLightIsOneSheet) {
  const Scene scene = column(8);
  const Slab slab = facet_slab(scene);
  const Reconstruction reconstruction(slab.mesh);
  const SmoothJoints joints(scene, slab.mesh, reconstruction);
  const FrameLight light(slab, reconstruction, joints, 0, 0, {});
  uint32_t leaf = kNone;
  // Where facets 2 and 3 meet it is 2.5, where 3 and 4 meet 3.5, and linear between.
  EXPECT_NEAR(light.irradiance(2, true, {1, 0.3}, &leaf).r, 2.5, 1e-6);
  EXPECT_NEAR(light.irradiance(3, true, {0, 0.3}, &leaf).r, 2.5, 1e-6);
  EXPECT_NEAR(light.irradiance(3, true, {0.75, 0.3}, &leaf).r, 3.25, 1e-6);
  EXPECT_NEAR(light.irradiance(3, false, {1, 1}, &leaf).r, 3.5, 1e-6);
  // With elements as they are, nothing is joined.
  const FrameLight flat(slab, reconstruction, joints, 0, 0, {false, true});
  EXPECT_EQ(flat.irradiance(3, true, {0, 0.3}, &leaf).r, 3);
}

TEST(Smooth, FacetsWithOneValueAreJoinedToo) {
  const Scene scene = column(8);
  Slab slab = facet_slab(scene);
  for (Element& element : slab.mesh.elements)  // one vertex for all of the face
    for (int c = 1; c < 4; ++c) element.vertices[c] = element.vertices[0];
  const Reconstruction reconstruction(slab.mesh);
  const SmoothJoints joints(scene, slab.mesh, reconstruction);
  const FrameLight light(slab, reconstruction, joints, 0, 0, {});
  uint32_t leaf = kNone;
  EXPECT_NEAR(light.irradiance(3, true, {0, 0.3}, &leaf).r, 2.5, 1e-6);
  EXPECT_NEAR(light.irradiance(3, true, {0.75, 0.3}, &leaf).r, 3.25, 1e-6);
}

// Facet 3 is divided into four, facet 2 is not. Its vertex in the middle of their common edge, of 10, would
// show a crack: it takes what lies between the corners there.
TEST(Smooth, EdgesOfUnlikeElementsHaveNoCracks) {
  const Scene scene = column(8);
  Slab slab = facet_slab(scene);
  Mesh& mesh = slab.mesh;
  const uint32_t face = mesh.face_of_side[2 * 3];
  const uint32_t root = mesh.faces[face].element;
  uint32_t v[4];
  for (int c = 0; c < 4; ++c) v[c] = mesh.elements[root].vertices[c];
  const auto add_vertex = [&](std::initializer_list<uint32_t> parents, float surplus) {
    MeshVertex vertex;
    int i = 0;
    for (const uint32_t parent : parents) vertex.parents[i++] = parent;
    mesh.vertices.push_back(vertex);
    slab.indirect.pieces.push_back({0, 0});
    slab.indirect.coefficients.push_back({surplus, surplus, surplus});
    slab.indirect.first_piece.push_back(static_cast<uint32_t>(slab.indirect.pieces.size()));
    slab.direct.first_piece.push_back(0);
    return static_cast<uint32_t>(mesh.vertices.size() - 1);
  };
  const uint32_t m01 = add_vertex({v[0], v[1]}, 0), m12 = add_vertex({v[1], v[2]}, 0);
  const uint32_t m23 = add_vertex({v[2], v[3]}, 0), m30 = add_vertex({v[0], v[3]}, 7);  // 3 + 7
  const uint32_t middle = add_vertex({v[0], v[1], v[2], v[3]}, 0);
  mesh.elements[root].first_child = static_cast<uint32_t>(mesh.elements.size());
  for (const auto& child : {std::array<uint32_t, 4>{v[0], m01, middle, m30},
                            {m01, v[1], m12, middle},
                            {middle, m12, v[2], m23},
                            {m30, middle, m23, v[3]}}) {
    Element element;
    std::copy(child.begin(), child.end(), element.vertices);
    mesh.elements.push_back(element);
  }
  const Reconstruction reconstruction(mesh);
  const SmoothJoints joints(scene, mesh, reconstruction);
  const FrameLight light(slab, reconstruction, joints, 0, 0, {});
  uint32_t leaf = kNone;
  for (const double along : {0.0, 0.25, 0.5, 0.8})
    EXPECT_NEAR(light.irradiance(3, true, {0, along}, &leaf).r,
                light.irradiance(2, true, {1, along}, &leaf).r, 1e-5);
  EXPECT_NEAR(light.irradiance(3, true, {0.5, 0.5}, &leaf).r, 3, 1e-5);  // its own middle
}

TEST(Smooth, FlatPolygonsHaveOnePointForAll) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {1, 1, 1}, {0.5f, 0.5f, 0.5f}, {});
  const Tracer tracer(scene);
  const Surfaces surfaces(scene, tracer);
  const Sight sight = surfaces.look(instant_at(scene, 0), {0.5, 0.5, 0.5}, {0, 0, 1});
  EXPECT_EQ(sight.smooth.position, sight.point.position);
  EXPECT_EQ(sight.smooth.normal, sight.point.normal);
}

}  // namespace
}  // namespace strad
