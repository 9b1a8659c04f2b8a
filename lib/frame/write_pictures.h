// Raster frames to picture files or down a pipe.
#pragma once

#include "base/progress.h"
#include "frame/frame_request.h"

namespace strad {

// Returns the exposure in stops. Throws BadInput or IoError; a file is complete or absent.
double write_pictures(const FrameRequest& request, const Progress& progress);
// The same for reference frames, which need no solution.
void write_references(const FrameRequest& request, const Progress& progress);
// The same for what request.show asks for.
void write_shows(const FrameRequest& request, const Progress& progress);

// The scene, without a solution: lit by its lamps without shadows, and a headlight; or from above
// (frame/plan.h), for which no camera is needed. Throws as write_pictures does.
void write_previews(const FrameRequest& request, const Progress& progress = {});
void write_plans(const FrameRequest& request, const Progress& progress = {});

}  // namespace strad
