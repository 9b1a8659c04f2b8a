// Finding the numbered files that a pattern such as room.%04d.exr stands for.
#pragma once

#include <string>
#include <vector>

#include "frame/file_pattern.h"

namespace strad {

// The numbers of the files that are there, ascending. REQUIRES: a numbered pattern; throws BadInput when its
// number stands in a folder's name, IoError when there is no such folder.
std::vector<int> frames_on_disk(const FilePattern& pattern);

}  // namespace strad
