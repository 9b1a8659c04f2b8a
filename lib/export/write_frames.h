// Frames to files or down a pipe, in every form that strad-frame has.
#pragma once

#include <string>

#include "base/progress.h"
#include "frame/raster.h"
#include "frame/reference.h"
#include "solution/solution_file.h"

namespace strad {

// What is asked for, in the words of the command line; checked before any work begins.
struct FrameRequest {
  std::string stream;    // "" or "-": standard input
  std::string frames;    // "A:B:S"; with `times` empty too: all
  std::string times;     // "T,T,..."
  std::string camera;    // "": the first
  std::string output;    // pattern of file names; "" or "-": standard output
  double shutter = 0;    // fraction of a frame, 0 to 1
  double exposure = 0;   // all light is scaled by 2^exposure
  bool pfm = false;      // on standard output, PFM in place of PPM
  RasterOptions raster;  // its shutter is set from the one above
  int reference = 0;     // paths a pixel of a reference frame; 0: frames of the solution
  uint64_t seed = 0;     // of its noise
};

// Each throws BadInput or IoError; a file is whole or absent.
void write_pictures(const FrameRequest& request, const Progress& progress);
void write_references(const FrameRequest& request, const Progress& progress);  // needs no solution
void write_ply(const FrameRequest& request, const Progress& progress);
void write_pov(const FrameRequest& request, const Progress& progress);  // `direct` chooses the lights

// The camera of that name, the first for "". Throws BadInput beginning with `option`.
const Camera& find_camera(const Scene& scene, const std::string& option, const std::string& name);

}  // namespace strad
