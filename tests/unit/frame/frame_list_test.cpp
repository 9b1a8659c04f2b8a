// Frames, times and sizes as words.
#include "frame/frame_list.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace strad {
namespace {

Scene ten_seconds() {
  Scene scene;
  scene.start = 2, scene.end = 12, scene.rate = 25;  // frames 1 to 250
  return scene;
}
std::vector<int> numbers(const std::string& text, TimeRange range = {2, 12}) {
  std::vector<int> found;
  for (const FrameTime& frame : parse_frames(ten_seconds(), range, "--frames", text))
    found.push_back(frame.number);
  return found;
}

TEST(FrameList, Ranges) {
  EXPECT_EQ(numbers("7"), (std::vector<int>{7}));
  EXPECT_EQ(numbers("3:6"), (std::vector<int>{3, 4, 5, 6}));
  EXPECT_EQ(numbers("1:10:4"), (std::vector<int>{1, 5, 9}));
  EXPECT_EQ(numbers("1:250").size(), 250u);
  EXPECT_EQ(numbers("1,5,10:20:4,2"), (std::vector<int>{1, 5, 10, 14, 18, 2}));
}

TEST(FrameList, TimesOfFrames) {
  const auto frames = parse_frames(ten_seconds(), {2, 12}, "--frames", "1:26:25");
  EXPECT_DOUBLE_EQ(frames[0].time, 2);
  EXPECT_DOUBLE_EQ(frames[1].time, 3);
}

TEST(FrameList, NonsenseIsRefused) {
  for (const char* text : {"", "a", "1:", ":3", "1:2:3:4", "0:3", "5:3", "1:251", "1:3:0", "1:3:-1", "1.5",
                           "1 :2", "+1", "0x1", "99999999999"}) {
    EXPECT_THROW(numbers(text), BadInput) << text;
  }
}

TEST(FrameList, FramesBeyondTheSolutionAreRefused) {
  EXPECT_EQ(numbers("26:51:25", {3, 4}), (std::vector<int>{26, 51}));
  EXPECT_THROW(numbers("25", {3, 4}), BadInput);
  EXPECT_THROW(numbers("52", {3, 4}), BadInput);
}

TEST(FrameList, Times) {
  const auto times = parse_times({2, 12}, "--time", "2,7.25,12");
  ASSERT_EQ(times.size(), 3u);
  EXPECT_EQ(times[1].number, 2);
  EXPECT_EQ(times[1].time, 7.25);
  for (const char* text : {"", "2,", ",2", "1.9", "12.1", "nan", "inf", "2;3", "2 3", "0x2"}) {
    EXPECT_THROW(parse_times({2, 12}, "--time", text), BadInput) << text;
  }
}

TEST(FrameList, AllFrames) {
  EXPECT_EQ(all_frames(ten_seconds(), {2, 12}).size(), 250u);
  EXPECT_EQ(all_frames(ten_seconds(), {3, 4}).front().number, 26);
  const auto instant = all_frames(ten_seconds(), {3.01, 3.01});  // between frames
  ASSERT_EQ(instant.size(), 1u);
  EXPECT_EQ(instant[0].time, 3.01);
}

TEST(FrameList, Sizes) {
  EXPECT_EQ(parse_size("--size", "640x480").width, 640u);
  EXPECT_EQ(parse_size("--size", "640x480").height, 480u);
  for (const char* text :
       {"", "640", "640x", "x480", "0x1", "1x0", "-1x5", "640X480", "640x480x3", "16385x1", "1.5x2"}) {
    EXPECT_THROW(parse_size("--size", text), BadInput) << text;
  }
}

TEST(FrameList, MessagesNameOptionFoundAndExpected) {
  try {
    numbers("5:3");
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_STREQ(fault.what(), "--frames: found '5:3', expected A, A:B or A:B:S with frames 1 to 250");
  }
}

}  // namespace
}  // namespace strad
