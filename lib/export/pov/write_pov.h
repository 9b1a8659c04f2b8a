// Frames to files for POV-Ray.
#pragma once

#include "base/progress.h"
#include "frame/frame_request.h"

namespace strad {

// `request.raster.direct` chooses between POV-Ray's own lights and light baked into the surfaces. Throws
// BadInput or IoError; a file is complete or absent.
void write_pov(const FrameRequest& request, const Progress& progress);

}  // namespace strad
