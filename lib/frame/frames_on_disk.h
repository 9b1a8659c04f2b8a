// Which numbers a sequence of files such as room.%04d.exr has, on disk or as asked for.
#pragma once

#include <string>
#include <vector>

#include "frame/file_pattern.h"

namespace strad {

// The numbers of the files that are there, ascending. REQUIRES: a numbered pattern; throws BadInput when its
// number stands in a folder's name, IoError when there is no such folder.
std::vector<int> frames_on_disk(const FilePattern& pattern);

// "1:9:2,61": single numbers, ranges and ranges with a step, in the order given. Throws BadInput beginning
// with `option`.
std::vector<int> parse_frame_numbers(const std::string& option, const std::string& text);

}  // namespace strad
