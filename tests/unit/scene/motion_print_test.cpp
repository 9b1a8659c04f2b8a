// A motion that is printed and compiled again is the same to the bit.
#include "scene/motion_print.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/rng.h"
#include "motion_test_scene.h"
#include "scene/motion_io.h"
#include "scene/motion_text.h"

namespace strad {
namespace {

Bytes bytes_of(const Scene& scene) {
  Bytes bytes = motion_of_light(scene);
  put_motion(&bytes, scene);
  return bytes;
}

// Applied to the scene itself, and to the scene at rest.
void expect_same_again(const Scene& scene) {
  const std::string text = print_motion(scene);
  Scene again = scene, at_rest = motion_test_scene();
  apply_motion(text, "printed", again);
  EXPECT_EQ(bytes_of(again), bytes_of(scene)) << text;
  apply_motion(text, "printed", at_rest);
  EXPECT_EQ(bytes_of(at_rest), bytes_of(scene)) << text;
}

// A number in -1 to 1 that uses all digits of a double.
double any(uint64_t seed, uint64_t index) {
  return static_cast<double>(hash_of(seed, index) >> 11) * 0x1p-52 - 1;
}
Vec3 any_vector(uint64_t seed, uint64_t index) {
  return {any(seed, index), any(seed, index + 1), any(seed, index + 2)};
}

TEST(MotionPrint, every_setting_in_words) {
  Scene scene = motion_test_scene();
  const std::string text =
      "time -0.5 24\nrate 24000/1001\n"
      "\nbody rail\n  parts floor\n  key 0  move 0 0 0\n  key 2  move 1 0.1 -2e-07\n"
      "\nbody crane\n  parts crane_* hook\n  on rail\n  pivot 0 0 3\n  axis 0 0 1\n  ease smooth\n"
      "  key 0  turn 90\n  key 1  turn -720.5\n"
      "\nspot \"head light\"\n  on crane\n  cone 18 31\n  key 0  at 0 1 2  aim 3 4 5  intensity 0.1 2 30\n"
      "\nglow \"lamp glass\"\n  key 0  value 1\n  key 3  value 0.3\n"
      "\ncamera main\n  key 0  from 0 1 5  to 0 1 0  up 0 1 0  fov 60\n";
  apply_motion(text, "given", scene);
  EXPECT_EQ(print_motion(scene), text);
  expect_same_again(scene);
}

// Angles that no number of degrees gives, quaternions and axes that were normalized, floats, negative zeros.
TEST(MotionPrint, numbers_to_the_bit) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Scene scene = motion_test_scene();
    scene.end = 1 + any(seed, 1);
    scene.rate = 3 + any(seed, 2);
    Body body{"crane",       0,  any_vector(seed, 3), normalized(any_vector(seed, 6)),
              Ease::kLinear, {}, {"crane_*"}};
    for (uint64_t k = 0; k < 4; ++k) {
      const bool has_quat = k % 2 == 1;
      const Vec3 v = any_vector(seed, 20 + 10 * k);
      const double w = any(seed, 23 + 10 * k), norm = std::sqrt(w * w + length2(v));
      body.keys.push_back({static_cast<double>(k), k == 2 ? Vec3{-0.0, 0, 1} : v,
                           has_quat ? 0 : any(seed, 9 + k), has_quat,
                           has_quat ? Quat{w / norm, v.x / norm, v.y / norm, v.z / norm} : Quat{}});
    }
    scene.bodies.push_back(body);
    scene.objects[1].body = scene.objects[2].body = 1;
    const float third = static_cast<float>(1 + any(seed, 70)) / 3;
    scene.spots.push_back({"spot",
                           1,
                           0.5 + 0.1 * any(seed, 71),
                           0.9 + 0.1 * any(seed, 72),
                           {{0, any_vector(seed, 73), any_vector(seed, 76), {third, 7 * third, third / 7}}}});
    scene.glows.push_back({1, {{0, third}}});
    scene.cameras.push_back(
        {"main", {{0, any_vector(seed, 80), any_vector(seed, 83), {0, 1, 0}, 1 + any(seed, 86)}}});
    expect_same_again(scene);
  }
}

TEST(MotionPrint, names_with_blanks_and_signs) {
  Scene scene = motion_test_scene();
  scene.cameras.push_back({"# 1", {{0, {}, {1, 0, 0}, {0, 1, 0}, 1}}});
  scene.cameras.push_back({"a\"b", {{0, {}, {1, 0, 0}, {0, 1, 0}, 1}}});
  scene.objects[0].name = "a*[1]";  // claimed without a pattern, as if by an importer
  scene.bodies.push_back({"odd", 0, {}, {0, 1, 0}, Ease::kLinear, {}, {}});
  scene.objects[0].body = 1;
  Scene again = scene;
  const std::string text = print_motion(scene);
  apply_motion(text, "printed", again);
  EXPECT_EQ(again.objects[0].body, 1u);
  EXPECT_EQ(again.cameras.size(), 2u) << text;
}

TEST(MotionPrint, refuses_a_name_that_cannot_be_written) {
  Scene scene = motion_test_scene();
  scene.cameras.push_back({"a \"b\"", {{0, {}, {1, 0, 0}, {0, 1, 0}, 1}}});
  EXPECT_THROW(print_motion(scene), BadInput);
}

}  // namespace
}  // namespace strad
