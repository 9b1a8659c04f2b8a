// Which numbers a sequence of files such as room.%04d.exr has on disk.
#pragma once

#include <string>
#include <vector>

#include "base/file_pattern.h"

namespace strad {

// The numbers of the files that are there, ascending. REQUIRES: a numbered pattern; throws BadInput when its
// number stands in a folder's name, IoError when there is no such folder.
std::vector<int> frames_on_disk(const FilePattern& pattern);

}  // namespace strad
