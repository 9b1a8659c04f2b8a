// What POV-Ray tells a scene file from outside: the clock, the frame, the picture's size, declarations.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "import/pov/language/tokens.h"

namespace strad {

// The constants of one run of a file. The defaults are those of a still, as POV-Ray 3.7 has them.
struct PovRun {
  double clock = 0, clock_delta = 0, initial_clock = 0, final_clock = 0;
  bool clock_on = false;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  // A file that takes more turns of loops and calls of macros, or more words, is refused as endless; so is
  // one that makes more bytes of strings, arrays and objects.
  size_t most_steps = 5'000'000, most_words = 100'000'000, most_bytes = 2'000'000'000;
  int image_width = 640, image_height = 480;
  std::vector<std::pair<std::string, std::variant<double, std::string>>> declared;
  std::vector<std::string> library_path;  // folders of included files
};

// Files by their paths, as tokens: read once for all frames.
using PovFiles = std::map<std::string, std::shared_ptr<const PovFile>>;

}  // namespace strad
