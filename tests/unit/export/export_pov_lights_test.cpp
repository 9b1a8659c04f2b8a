// Lights for POV-Ray carry the power of the surfaces they stand for.
#include <gtest/gtest.h>

#include "export/pov/lights.h"
#include "export_scene.h"

namespace strad {
namespace {

double total_area(const std::vector<PovLamp>& lamps) {
  double sum = 0;
  for (const PovLamp& lamp : lamps) sum += lamp.area;
  return sum;
}

Vec3 centroid(const std::vector<PovLamp>& lamps) {
  Vec3 sum;
  for (const PovLamp& lamp : lamps) sum += lamp.area / total_area(lamps) * lamp.centre;
  return sum;
}

Scene lamp_scene() {
  Scene scene = square_scene();
  scene.materials[0].emission = {4, 2, 1};
  return scene;
}

TEST(PovLamps, QuadIsFourPiecesJustBeforeIt) {
  const Scene scene = lamp_scene();
  const auto lamps = pov_lamps(scene, 16);
  ASSERT_EQ(lamps.size(), 4u);
  for (const PovLamp& lamp : lamps) {
    EXPECT_EQ(lamp.samples, 8);
    EXPECT_NEAR(lamp.area, 0.25, 1e-12);
    EXPECT_EQ(lamp.normal, (Vec3{0, 0, 1}));
    EXPECT_NEAR(lamp.centre.z, export_lift(scene), 1e-15);
  }
  EXPECT_NEAR(length(centroid(lamps) - Vec3{0.5, 0.5, export_lift(scene)}), 0, 1e-12);
}

TEST(PovLamps, TwoTrianglesOfAQuadAreJoined) {
  Scene scene = lamp_scene();
  scene.polygons = {{.corners = {0, 1, 2, kNone}}, {.corners = {2, 3, 0, kNone}}};
  const auto lamps = pov_lamps(scene, 16);
  ASSERT_EQ(lamps.size(), 4u);
  EXPECT_NEAR(total_area(lamps), 1, 1e-12);
  EXPECT_NEAR(length(centroid(lamps) - Vec3{0.5, 0.5, export_lift(scene)}), 0, 1e-12);
}

TEST(PovLamps, TrianglesOfTwoObjectsStayApart) {
  Scene scene = lamp_scene();
  scene.objects.push_back({.name = "other"});
  scene.polygons = {{.corners = {0, 1, 2, kNone}}, {.corners = {2, 3, 0, kNone}, .object = 1}};
  EXPECT_GT(pov_lamps(scene, 16).size(), 4u);
  EXPECT_NEAR(total_area(pov_lamps(scene, 16)), 1, 1e-12);
}

TEST(PovLamps, TriangleAndTrapezoidKeepAreaAndCentroid) {
  Scene scene = lamp_scene();
  scene.polygons = {{.corners = {0, 1, 3, kNone}}};
  EXPECT_NEAR(total_area(pov_lamps(scene, 16)), 0.5, 1e-12);
  EXPECT_NEAR(length(centroid(pov_lamps(scene, 16)) - Vec3{1.0 / 3, 1.0 / 3, export_lift(scene)}), 0, 1e-12);
  scene.polygons = {{.corners = {0, 1, 2, 3}}};
  scene.vertices[2].x = 0.5;  // triangles (0, 1, 2) of area 1/2 and (0, 2, 3) of area 1/4
  EXPECT_NEAR(total_area(pov_lamps(scene, 16)), 0.75, 1e-12);
}

// A lamp of a hundred small quads has about as many lights as one large quad.
TEST(PovLamps, ManySmallPolygonsShareTheLights) {
  Scene scene = lamp_scene();
  scene.vertices.clear();
  scene.polygons.clear();
  for (int i = 0; i < 100; ++i) {
    const auto v = static_cast<uint32_t>(scene.vertices.size());
    const double x = i % 10, y = static_cast<double>(i / 10);
    scene.vertices.insert(scene.vertices.end(), {{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}});
    scene.polygons.push_back({.corners = {v, v + 1, v + 2, v + 3}});
  }
  int lights = 0;
  for (const PovLamp& lamp : pov_lamps(scene, 16)) lights += lamp.samples * lamp.samples;
  EXPECT_GE(lights, 100);
  EXPECT_LE(lights, 500);
  EXPECT_NEAR(total_area(pov_lamps(scene, 16)), 100, 1e-9);
}

TEST(PovLights, WideSpotsAreThreeCones) {
  const Spot narrow{.name = "a", .inner = 0.2, .outer = 0.4, .keys = {}},
      wide{.name = "b", .inner = 0.5, .outer = 2, .keys = {}};
  const SpotState state{.position = {}, .direction = {0, 0, 1}, .intensity = {1, 1, 1}};
  const auto count = [&](const Spot& spot) {
    PovText out;
    write_spot(spot, state, "x", &out);
    const std::string text = out.take();
    size_t n = 0;
    for (size_t at = text.find("light_source"); at != std::string::npos;
         at = text.find("light_source", at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(count(narrow), 1u);
  EXPECT_EQ(count(wide), 3u);
}

}  // namespace
}  // namespace strad
