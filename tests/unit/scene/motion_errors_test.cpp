// Errors in motion files are one line: file and line number, what was found, what was expected.
#include <gtest/gtest.h>

#include "base/error.h"
#include "motion_test_scene.h"
#include "scene/motion_text.h"

namespace strad {
namespace {

std::string complaint_about(const std::string& text) {
  Scene scene = motion_test_scene();
  try {
    apply_motion(text, "m", scene);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

struct Case {
  const char* name;
  const char* text;
  const char* complaint;  // the whole message
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class MotionErrors : public testing::TestWithParam<Case> {};

TEST_P(MotionErrors, are_told) { EXPECT_EQ(complaint_about(GetParam().text), GetParam().complaint); }

const Case kStatements[] = {
    {"unknown", "time 0 1\nbudy arm\n",
     "m:2: found \"budy\", expected time, rate, body, spot, glow or camera"},
    {"indented_first", "\n  key 0\n",
     "m:2: found an indented \"key\" under no statement, expected time, rate, body, spot, glow or camera in "
     "column "
     "one"},
    {"indented_after_time", "time 0 1\n  rate 25\n",
     "m:2: found an indented \"rate\" under time, expected a statement in column one"},
    {"time_backward", "time 2 1\n", "m:1: found an end at 1, expected one at 2 or later"},
    {"time_short", "time 2\n", "m:1: found end of line, expected start and end in seconds"},
    {"time_long", "time 0 1 2\n", "m:1: found \"2\", expected end of line"},
    {"rate_zero", "rate 0\n",
     "m:1: found \"0\", expected frames per second, above 0, such as 25 or 24000/1001"},
    {"rate_over_zero", "rate 25/0\n",
     "m:1: found \"25/0\", expected frames per second, above 0, such as 25 or 24000/1001"},
    {"rate_of_words", "rate 25/x\n",
     "m:1: found \"25/x\", expected frames per second, above 0, such as 25 or 24000/1001"},
    {"turn_in_gradians", "body b\n  key 0 turn 3grad\n",
     "m:2: found \"3grad\", expected an angle in degrees"},
    {"rate_missing", "rate\n",
     "m:1: found end of line, expected frames per second, above 0, such as 25 or 24000/1001"},
    {"open_quote", "glow \"lamp glass\n", "m:1: found end of line, expected a closing quote"},
    {"quote_glued", "glow \"lamp\"glass\n", "m:1: found \"glass\", expected a blank after the closing quote"},
};

const Case kNumbers[] = {
    {"word", "time 0 soon\n", "m:1: found \"soon\", expected start and end in seconds"},
    {"trailing", "time 0 1s\n", "m:1: found \"1s\", expected start and end in seconds"},
    {"comma", "time 0,5 1\n", "m:1: found \"0,5\", expected start and end in seconds"},
    {"hexadecimal", "time 0 0x10\n", "m:1: found \"0x10\", expected start and end in seconds"},
    {"nan", "time 0 nan\n", "m:1: found \"nan\", expected start and end in seconds"},
    {"infinite", "time 0 inf\n", "m:1: found \"inf\", expected start and end in seconds"},
    {"overflow", "time 0 1e999\n", "m:1: found \"1e999\", expected start and end in seconds"},
    {"huge", "time 0 1e16\n", "m:1: found \"1e16\", expected a number of at most 1e15"},
    {"empty", "time 0 \"\"\n", "m:1: found \"\", expected start and end in seconds"},
};

const Case kBodies[] = {
    {"nameless", "body\n", "m:1: found end of line, expected the name of the body"},
    {"empty_name", "body \"\"\n", "m:1: found \"\", expected the name of the body"},
    {"two_names", "body a b\n", "m:1: found \"b\", expected end of line"},
    {"world", "body world\n",
     "m:1: found a body named world, expected another name: the world is what never moves"},
    {"unknown_setting", "body a\n  pivott 0 0 0\n",
     "m:2: found \"pivott\", expected parts, on, pivot, axis, ease or key"},
    {"second_pivot", "body a\n  pivot 0 0 0\n  pivot 0 0 0\n",
     "m:3: found a second pivot, expected one pivot in a block"},
    {"pivot_short", "body a\n  pivot 0 0\n",
     "m:2: found end of line, expected the three numbers of the pivot"},
    {"axis_zero", "body a\n  axis 0 0 0\n", "m:2: found an axis of no length, expected a direction"},
    {"ease_odd", "body a\n  ease cubic\n", "m:2: found \"cubic\", expected linear or smooth"},
    {"parts_empty", "body a\n  parts\n", "m:2: found end of line, expected names or patterns of objects"},
    {"parts_unmatched", "body a\n  parts hook claw*\n",
     "m:2: found no object named \"claw*\", expected a name or pattern of objects (floor, crane_mast, "
     "crane_arm, "
     "hook)"},
    {"claimed_twice", "body a\n  parts hook\nbody b\n  parts h*\n",
     "m:4: found object \"hook\" of body \"a\", expected an object of no other body"},
    {"orphan", "body a\n  on b\n", "m:2: found \"b\", expected the name of a body (world, a)"},
    {"own_parent", "body a\n  on a\n",
     "m:2: found a cycle (a on a), expected a parent that does not ride on this body"},
    {"cycle", "body c\n  on a\nbody a\n  on b\nbody b\n  on a\n",
     "m:4: found a cycle (a on b on a), expected a parent that does not ride on this body"},
};

const Case kBodyKeys[] = {
    {"no_time", "body a\n  key\n", "m:2: found end of line, expected a time in seconds"},
    {"nothing", "body a\n  key 0\n", "m:2: found end of line, expected move, turn or quat"},
    {"unknown", "body a\n  key 0 spin 3\n", "m:2: found \"spin\", expected move, turn or quat"},
    {"twice", "body a\n  key 0 turn 1 turn 2\n", "m:2: found a second turn, expected one turn in a key"},
    {"turn_and_quat", "body a\n  key 0 turn 1 quat 1 0 0 0\n",
     "m:2: found both turn and quat, expected one of them in a key"},
    {"quat_zero", "body a\n  key 0 quat 0 0 0 0\n",
     "m:2: found a quaternion of no length, expected a rotation"},
    {"quat_short", "body a\n  key 0 quat 1 0 0\n",
     "m:2: found end of line, expected the four numbers W X Y Z of the quaternion"},
    {"backward", "body a\n  key 2 turn 0\n  key 1 turn 0\n",
     "m:3: found a key at 1, expected one at 2 or later"},
    {"third_at_once", "body a\n  key 1 turn 0\n  key 1 turn 1\n  key 1 turn 2\n",
     "m:4: found a third key at 1, expected at most two at one time"},
};

const Case kLights[] = {
    {"no_cone", "spot s\n  key 0 at 0 0 0 aim 1 0 0 intensity 1 1 1\n",
     "m:1: found a spot without a cone, expected cone INNER OUTER"},
    {"no_key", "spot s\n  cone 1 2\n", "m:1: found a spot without a key, expected at least one key"},
    {"cone_inverted", "spot s\n  cone 30 20\n",
     "m:2: found a cone from 30 to 20, expected two half-angles in degrees, 0 <= inner <= outer < 180, outer "
     "> 0"},
    {"cone_wide", "spot s\n  cone 30 180\n",
     "m:2: found a cone from 30 to 180, expected two half-angles in degrees, 0 <= inner <= outer < 180, "
     "outer > 0"},
    {"no_aim", "spot s\n  cone 1 2\n  key 0 at 0 0 0 intensity 1 1 1\n",
     "m:3: found a first key without aim, expected at, aim and intensity"},
    {"aims_at_itself", "spot s\n  cone 1 2\n  key 0 at 1 0 0 aim 1 0 0 intensity 1 1 1\n",
     "m:3: found a spot that aims at itself, expected aim apart from at"},
    {"dark", "spot s\n  cone 1 2\n  key 0 at 0 0 0 aim 1 0 0 intensity 1 -1 1\n",
     "m:3: found a negative intensity, expected red, green and blue of at least 0"},
    {"spot_orphan", "spot s\n  on a\n  cone 1 2\n  key 0 at 0 0 0 aim 1 0 0 intensity 1 1 1\n",
     "m:2: found \"a\", expected the name of a body (world)"},
    {"no_material", "glow brass\n  key 0 value 1\n",
     "m:1: found \"brass\", expected the name of a material (plaster, lamp glass)"},
    {"glow_no_key", "glow plaster\n", "m:1: found a glow without a key, expected at least one key"},
    {"glow_negative", "glow plaster\n  key 0 value -1\n",
     "m:2: found \"-1\", expected a scale of at least 0"},
    {"glow_setting", "glow plaster\n  value 1\n", "m:2: found \"value\", expected key"},
};

const Case kCameras[] = {
    {"no_key", "camera c\n", "m:1: found a camera without a key, expected at least one key"},
    {"no_to", "camera c\n  key 0 from 0 0 0\n",
     "m:2: found a first key without to, expected from, to, up and fov"},
    {"same_place", "camera c\n  key 0 from 1 1 1 to 1 1 1\n",
     "m:2: found a camera that looks at its own place, expected to apart from from"},
    {"up_along", "camera c\n  key 0 from 0 0 0 to 0 -3 0\n",
     "m:2: found an up direction along the view, expected one across it"},
    {"fov_wide", "camera c\n  key 0 from 0 0 0 to 1 0 0 fov 180\n",
     "m:2: found \"180\", expected a field of view in degrees, above 0 and below 180"},
};

std::string name_of_case(const testing::TestParamInfo<Case>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Numbers, MotionErrors, testing::ValuesIn(kNumbers), name_of_case);
INSTANTIATE_TEST_SUITE_P(Bodies, MotionErrors, testing::ValuesIn(kBodies), name_of_case);
INSTANTIATE_TEST_SUITE_P(BodyKeys, MotionErrors, testing::ValuesIn(kBodyKeys), name_of_case);
INSTANTIATE_TEST_SUITE_P(Lights, MotionErrors, testing::ValuesIn(kLights), name_of_case);
INSTANTIATE_TEST_SUITE_P(Cameras, MotionErrors, testing::ValuesIn(kCameras), name_of_case);
INSTANTIATE_TEST_SUITE_P(Statements, MotionErrors, testing::ValuesIn(kStatements), name_of_case);

TEST(MotionFile, what_only_the_whole_shows_names_the_file) {
  EXPECT_EQ(complaint_about("time 0 1e9\nrate 50\n"), "m: there are too many frames");
}

TEST(MotionFile, a_zero_byte_is_told) {
  EXPECT_EQ(complaint_about(std::string("time 0 1\nra\0te", 14)),
            "m:2: found a zero byte, expected a motion file, which is text");
}

// A file that is cut anywhere is either accepted or refused with a line number. It never crashes.
TEST(MotionFile, every_truncation_is_accepted_or_told) {
  const std::string text =
      "time 0 24\nrate 25\nbody a\n  parts crane_* \"hook\"\n  pivot 0 0 3\n  ease smooth\n"
      "  key 0 move 0 0 0 turn 0\n  key 10 quat 1 0 0 0\n"
      "spot s\n  on a\n  cone 1 2\n  key 0 at 0 0 0 aim 1 0 0 intensity 1 1 1\n"
      "glow \"lamp glass\"\n  key 0 value 1\ncamera c\n  key 0 from 0 0 0 to 1 0 0 up 0 1 0 fov 60\n";
  EXPECT_EQ(complaint_about(text), "accepted");
  for (size_t size = 0; size < text.size(); ++size) {
    const std::string complaint = complaint_about(text.substr(0, size));
    EXPECT_TRUE(complaint == "accepted" || complaint.starts_with("m:")) << complaint;
  }
}

}  // namespace
}  // namespace strad
