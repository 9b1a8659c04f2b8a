// Numbered files named by a printf pattern such as room.%04d.exr.
#pragma once

#include <string>
#include <vector>

namespace strad {

// Is there a % in it?
bool is_pattern(const std::string& path);

// The file of frame `number`. Throws BadInput unless the pattern holds exactly one %d, %5d or %05d (the width
// being any);
// %% stands for a percent sign.
std::string frame_path(const std::string& pattern, int number);

// The numbers of the files on disk that fit, ascending. The pattern's % may stand in the file name only.
std::vector<int> frames_on_disk(const std::string& pattern);

}  // namespace strad
