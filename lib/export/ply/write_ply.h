// Frames to PLY files, or a single one to standard output.
#pragma once

#include "base/progress.h"
#include "frame/frame_request.h"

namespace strad {

// Throws BadInput or IoError; a file is complete or absent.
void write_ply(const FrameRequest& request, const Progress& progress);

}  // namespace strad
