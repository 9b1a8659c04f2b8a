// Previews have the light of unshadowed lamps, plans show where things are, warnings tell what is wrong.
#include "frame/preview.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "frame/plan.h"
#include "frame/warnings.h"

namespace strad {
namespace {

uint32_t add_object(Scene* scene, const std::string& name, uint32_t body = 0) {
  scene->objects.push_back({name, body});
  return static_cast<uint32_t>(scene->objects.size() - 1);
}

void add_quad(Scene* scene, uint32_t object, Vec3 at, Vec3 u, Vec3 v, uint32_t material = 0) {
  Polygon polygon;
  for (int k = 0; k < 4; ++k) {
    polygon.corners[k] = static_cast<uint32_t>(scene->vertices.size());
    scene->vertices.push_back(at + (k == 1 || k == 2 ? u : Vec3{}) + (k >= 2 ? v : Vec3{}));
  }
  polygon.object = object;
  polygon.material = material;
  scene->polygons.push_back(polygon);
}

void add_cube(Scene* scene, uint32_t object, Vec3 lower, double size) {
  const Vec3 x{size, 0, 0}, y{0, size, 0}, z{0, 0, size}, upper = lower + x + y + z;
  add_quad(scene, object, lower, y, x), add_quad(scene, object, lower, z, y),
      add_quad(scene, object, lower, x, z);
  add_quad(scene, object, upper, -x, -y), add_quad(scene, object, upper, -y, -z),
      add_quad(scene, object, upper, -z, -x);
}

// A wall of reflectance 0.5 in the plane z = 0, 20 m wide, and a camera 4 m before it that sees 8 m of it.
Scene wall() {
  Scene scene;
  scene.end = 1;
  scene.materials.push_back({"wall", {0.5f, 0.5f, 0.5f}, {}, kNone});
  add_quad(&scene, add_object(&scene, "wall"), {-10, -10, 0}, {20, 0, 0}, {0, 20, 0});
  scene.cameras.push_back({"main", {{0, {0, 0, 4}, {0, 0, 0}, {0, 1, 0}, kPi / 2}}});
  return scene;
}

// The middle of a picture of 1001 pixels is the point that the camera looks at, within 4 mm.
float middle(const Scene& scene) { return Preview(scene).render(scene.cameras[0], 0, 1001, 1).at(500, 0).r; }

TEST(Preview, lamps_have_their_strength) {
  Scene scene = wall();
  EXPECT_NEAR(middle(scene), 0.5, 1e-4);  // a headlight alone: the reflectance
  // 10 W/sr at 2 m: irradiance 2.5, radiance 0.5 * 2.5 / pi; and a tenth of the headlight.
  scene.spots.push_back({"spot", 0, 0.5, 0.6, {{0, {0, 0, 2}, {0, 0, 0}, {10, 10, 10}}}});
  EXPECT_NEAR(middle(scene), 0.5 * 2.5 / kPi + 0.05, 1e-4);
  // A lamp of 0.04 m^2 and 30 W/(sr m^2), 2 m from the wall: as if it were small, irradiance 30 * 0.04 / 4,
  // less one part in 300 for its size. It stands beside the axis by 0, but faces the wall, so the camera sees
  // its back: it is put 1.5 m aside, where both cosines are 2 / 2.5.
  scene.spots.clear();
  scene.materials.push_back({"lamp", {}, {30, 30, 30}, kNone});
  add_quad(&scene, add_object(&scene, "lamp"), {1.4, -0.1, 2}, {0, 0.2, 0}, {0.2, 0, 0}, 1);
  const double form = 0.04 * 0.8 * 0.8 / (6.25 + 0.04 / kPi);
  EXPECT_NEAR(middle(scene), 0.5 * 30 * form / kPi + 0.05, 1e-4);
}

TEST(Preview, is_the_same_for_any_number_of_threads) {
  const Scene scene = wall();
  const Preview preview(scene);
  set_thread_count(1);
  const Image one = preview.render(scene.cameras[0], 0, 40, 30);
  set_thread_count(0);
  EXPECT_EQ(one, preview.render(scene.cameras[0], 0, 40, 30));
}

TEST(Plan, shows_what_stands_where) {
  Scene scene = wall();
  scene.bodies.push_back({"cart",
                          0,
                          {},
                          {0, 1, 0},
                          Ease::kLinear,
                          {{0, {0, 0, 0}, 0, false, {}}, {1, {4, 0, 0}, 0, false, {}}},
                          {}});
  add_cube(&scene, add_object(&scene, "cart", 1), {-8, 0, 5}, 2);
  PlanOptions options;
  options.width = options.height = 100;
  const Image plan = plan_of(scene, &scene.cameras[0], 0, options);
  // Seen along -y are x from -10 to 10 and z from 0 to 7: 90 pixels for 20 m, the middle at (0, 3.5).
  const auto at = [&](double x, double z) {
    return plan.at(static_cast<uint32_t>(50 + 4.5 * x), static_cast<uint32_t>(50 + 4.5 * (z - 3.5)));
  };
  EXPECT_EQ(at(9, 6), (Rgb{1, 1, 1}));    // nothing there
  EXPECT_LT(luminance(at(5, 0)), 0.99f);  // the wall, from above a line
  EXPECT_LT(luminance(at(-5, 6)), 0.8f);  // the path of the cart's middle, from (-7, 6) to (-3, 6)
  EXPECT_GT(at(0, 4).b, 2 * at(0, 4).r);  // the camera
  scene.cameras.clear();
  EXPECT_EQ(plan_of(scene, nullptr, 0, options).width, 100u);
}

std::string told(const Scene& scene) {
  std::string all;
  for (const std::string& line : warnings_of(scene)) all += line + "\n";
  return all;
}

TEST(Warnings, tell_what_is_probably_wrong) {
  Scene scene = wall();
  EXPECT_EQ(told(scene), "the scene has no light: no material emits and there is no spotlight\n");
  scene.spots.push_back({"spot", 0, 0.5, 0.6, {{0, {0, 0, 2}, {0, 0, 0}, {10, 10, 10}}}});
  EXPECT_EQ(told(scene), "");
  add_cube(&scene, add_object(&scene, "crate"), {-0.5, -0.5, 1.5}, 1);
  EXPECT_EQ(told(scene), "spot spot is inside the object crate at 0 s: its light does not come out\n");
  scene.spots[0].keys[0].at = {3, 0, 2};
  scene.spots[0].keys.push_back({2, {3, 0, 2}, {0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(told(scene), "spot spot has 1 key after the end, 1 s: the last is at 2 s\n");
  scene.spots[0].keys.pop_back();
  scene.cameras[0].keys[0].to = {0, 0, 9};
  EXPECT_EQ(told(scene), "camera main sees nothing at 0 s\n");
  scene.cameras[0].keys[0] = {0, {0.2, 0, 2}, {0, 0, 0}, {0, 1, 0}, 1};
  EXPECT_EQ(told(scene), "camera main is inside the object crate at 0 s\n");
}

TEST(Warnings, tell_of_bodies_that_go_through_each_other) {
  Scene scene = wall();
  scene.spots.push_back({"spot", 0, 0.5, 0.6, {{0, {0, 0, 2}, {0, 0, 0}, {10, 10, 10}}}});
  const auto body = [](const std::string& name, Vec3 to) {
    return Body{name, 0, {}, {0, 1, 0}, Ease::kLinear, {{0, {}, 0, false, {}}, {1, to, 0, false, {}}}, {}};
  };
  scene.bodies.push_back(body("cart", {23, 0, 0}));
  scene.bodies.push_back(body("crane", {}));
  add_cube(&scene, add_object(&scene, "cart", 1), {-9, 4, 1}, 1);
  add_cube(&scene, add_object(&scene, "crane", 2), {0.5, 3.5, 0.5}, 2);
  // The cart moves by 1 m from one of 24 instants to the next. Its right side is at -8 and is in the inner 80
  // % of the crane, from 0.7 to 2.3 m, after 9 steps.
  EXPECT_EQ(told(scene), "body cart is in the box of body crane at 0.391304 s\n");
  scene.bodies[1].parent = 0, scene.bodies[2].parent = 1;  // carried along
  EXPECT_EQ(told(scene), "");
}

}  // namespace
}  // namespace strad
