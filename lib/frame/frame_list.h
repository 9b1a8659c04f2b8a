// Which instants to render, and under which names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "solution/solution.h"

namespace strad {

struct FrameTime {
  int number = 0;   // of the frame, or the place in a list of times, counted from 1
  double time = 0;  // s
};

// The stretch of time that frames may show, s.
struct TimeRange {
  double begin = 0, end = 0;
  const char* of = "the solution";  // whose time it is, for messages
};
TimeRange solved_range(const Solution& solution);

// Frames "A:B:S" (from A to B in steps of S), "A:B" or "A", or several of these with commas between, in the
// order given. Throws BadInput beginning with `option` unless
// all are frames of the scene and within `range`.
std::vector<FrameTime> parse_frames(const Scene& scene, TimeRange range, const std::string& option,
                                    const std::string& text);

// Times "T,T,..." in seconds. Throws BadInput likewise.
std::vector<FrameTime> parse_times(TimeRange range, const std::string& option, const std::string& text);

// Every frame of the scene within `range`; its beginning if it holds none (the solution of an instant).
std::vector<FrameTime> all_frames(const Scene& scene, TimeRange range);

struct PictureSize {
  uint32_t width = 640, height = 480;
};
// "WxH". Throws BadInput beginning with `option` unless both are 1 to 16384.
PictureSize parse_size(const std::string& option, const std::string& text);

}  // namespace strad
