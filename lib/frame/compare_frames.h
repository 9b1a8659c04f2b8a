// Two pictures or two numbered sequences of them compared, file by file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/metrics.h"

namespace strad {

// Paths, or all patterns (base/file_pattern.h). Empty where there is none.
struct FrameFiles {
  std::string a, b;    // reference and what is compared to it
  std::string twin;    // a second rendering of `a` with independent noise, see compare()
  std::string labels;  // 8-bit pictures; pixels whose first channel has one of `label_bits` do not count
  int label_bits = 255;
  std::string heat_map;     // written: false colours, white from half the mean of `a` on
  std::vector<int> frames;  // of patterns; empty: all that are on disk
};

struct FramesComparison {
  int frames = 0;
  Comparison total;
  std::string worst_file;  // of `b`, where the largest difference is
  // Of every three consecutive frames, in the mean; none without three.
  std::optional<double> flicker_a, flicker_b;
  std::optional<double> flicker_excess;  // of b - a
};

// Called with the file of `b` and the values of each pair of pictures.
using SeePicture = std::function<void(const std::string&, const Comparison&)>;

// Throws IoError or BadInput when a file is missing on either side, of another size, or not finite.
FramesComparison compare_frames(const FrameFiles& files, const SeePicture& see = {});

}  // namespace strad
