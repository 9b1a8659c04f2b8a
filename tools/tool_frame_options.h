// What the options of strad-frame say, and which of them go together.
#pragma once

#include <optional>
#include <string>

#include "frame/encoding_words.h"
#include "frame/frame_request.h"
#include "tool.h"

namespace strad {

struct FrameTool {
  Common common;
  FrameRequest request;
  bool pov = false, ply = false, preview = false, plan = false;
  std::optional<int> reference, seed;
  std::string show, exposure, layers, stats;
  std::optional<double> within;
  EncodingWords encoding;
};

// Throws BadInput for numbers out of range and options that exclude each other.
void check(const FrameTool& tool);

// How light becomes numbers in the files or the pipe that pictures go to.
Encoding encoding_of(const FrameTool& tool);

}  // namespace strad
