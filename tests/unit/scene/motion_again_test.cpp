// Motion upon motion: later statements win.
#include <gtest/gtest.h>

#include "motion_test_scene.h"
#include "scene/motion_io.h"
#include "scene/motion_text.h"

namespace strad {
namespace {

constexpr char kFirst[] =
    "time 0 24\nrate 25\n"
    "body rail\n  parts floor\n  key 0 move 0 0 0\n  key 24 move 1 0 0\n"
    "body crane\n  on rail\n  parts crane_*\n  key 0 turn 0\n  key 24 turn 90\n"
    "spot a\n  on crane\n  cone 10 20\n  key 0 at 0 0 0 aim 1 0 0 intensity 1 1 1\n"
    "spot b\n  cone 10 20\n  key 0 at 0 0 0 aim 1 0 0 intensity 2 2 2\n"
    "glow \"lamp glass\"\n  key 0 value 1\n"
    "camera main\n  key 0 from 0 0 0 to 1 0 0\n";

constexpr char kSecond[] =
    "rate 50\n"
    "body hand\n  on crane\n  parts hook\n"
    "body crane\n  parts crane_arm\n  key 3 turn 7\n"
    "spot a\n  on hand\n  cone 1 2\n  key 0 at 0 0 0 aim 0 1 0 intensity 9 9 9\n"
    "glow \"lamp glass\"\n  key 0 value 0.5\n"
    "camera main\n  key 0 from 0 0 0 to 0 0 1\n"
    "camera side\n  key 0 from 0 0 0 to 0 0 1\n";

Scene after(std::initializer_list<std::string> texts) {
  Scene scene = motion_test_scene();
  for (const std::string& text : texts) apply_motion(text, "test.motion", scene);
  return scene;
}

// All that a motion file can change, as bytes of a stream.
Bytes motion_bytes(const Scene& scene) {
  Bytes bytes;
  put_motion(&bytes, scene);
  for (const Object& object : scene.objects) put_u32(&bytes, object.body);
  return bytes;
}

TEST(MotionAgain, later_statements_win_and_all_else_stays) {
  const Scene scene = after({kFirst, kSecond});
  EXPECT_EQ(scene.end, 24);
  EXPECT_EQ(scene.rate, 50);
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(scene.bodies[1].name, "rail");
  EXPECT_EQ(scene.bodies[2].name, "crane");
  EXPECT_EQ(scene.bodies[3].name, "hand");
  EXPECT_EQ(scene.bodies[2].parent, 0u);
  EXPECT_EQ(scene.bodies[2].keys.size(), 1u);
  EXPECT_EQ(scene.bodies[3].parent, 2u);
  EXPECT_EQ(scene.objects[0].body, 1u);
  EXPECT_EQ(scene.objects[1].body, 0u);  // the mast is no longer the crane's
  EXPECT_EQ(scene.objects[2].body, 2u);
  EXPECT_EQ(scene.objects[3].body, 3u);
  ASSERT_EQ(scene.spots.size(), 2u);
  EXPECT_EQ(scene.spots[0].body, 3u);
  EXPECT_EQ(scene.spots[0].keys[0].intensity.r, 9);
  EXPECT_EQ(scene.spots[1].keys[0].intensity.r, 2);
  ASSERT_EQ(scene.glows.size(), 1u);
  EXPECT_EQ(scene.glows[0].keys[0].value, 0.5f);
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[0].keys[0].to, (Vec3{0, 0, 1}));
}

TEST(MotionAgain, two_texts_are_as_good_as_their_concatenation) {
  EXPECT_EQ(motion_bytes(after({kFirst, kSecond})), motion_bytes(after({std::string(kFirst) + kSecond})));
}

TEST(MotionAgain, the_same_text_twice_changes_nothing) {
  EXPECT_EQ(motion_bytes(after({kFirst, kFirst})), motion_bytes(after({kFirst})));
  EXPECT_EQ(motion_bytes(after({kFirst, kSecond, kSecond})), motion_bytes(after({kFirst, kSecond})));
}

TEST(MotionAgain, riders_of_a_replaced_body_stay_on_it) {
  const Scene scene = after({kFirst, "body crane\n  key 0 turn 5\n"});
  EXPECT_EQ(scene.bodies[scene.spots[0].body].name, "crane");
}

}  // namespace
}  // namespace strad
