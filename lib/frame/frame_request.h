// A request for frames: which frames of which stream, how they are rendered, and where they are written.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/file_pattern.h"
#include "base/progress.h"
#include "frame/frame_costs.h"
#include "frame/frame_list.h"
#include "frame/layer_list.h"
#include "frame/raster.h"
#include "frame/show.h"
#include "image/encoding.h"
#include "solution/stream_io.h"

namespace strad {

// In the words of the command line.
struct FrameRequest {
  std::string stream;             // "" or "-": standard input
  std::string frames;             // "A:B:S,..."; with `times` empty too: all
  std::string times;              // "T,T,..."
  std::string camera;             // "": the first
  std::string camera_at;          // "from X Y Z to X Y Z ...", in place of one of the stream's
  std::string output;             // pattern of file names; "" or "-": standard output
  double shutter = 0;             // fraction of a frame, 0 to 1
  double exposure = 0;            // all light is scaled by 2^exposure
  bool auto_exposure = false;     // in place of it, that of the animation's brightness
  Encoding encoding;              // of pictures
  std::vector<LayerKind> layers;  // in place of the one picture
  bool all_layers = false;        // specular too, if the scene has mirrors or glass
  bool pfm = false;               // on standard output, PFM in place of PPM
  RasterOptions raster;           // its shutter is set from the one above
  int reference = 0;              // paths per pixel of a reference frame; 0: frames of the solution
  uint64_t seed = 0;              // of its noise
  std::optional<ShowWhat> show;   // in place of light
  double within = 0;              // m: how far openness looks; 0: see ShowOptions
  bool missing = false;           // only frames whose files are not there, see shows()
  std::function<void(const FrameCost&)> told;  // after each frame; may be empty
  std::string software, provenance;            // for picture files: name and version, and what was asked for
};

bool goes_to_files(const FrameRequest& request);

// Throws BadInput unless the frames lie within `range`.
std::vector<FrameTime> requested_frames(const FrameRequest& request, const Scene& scene, TimeRange range);

// Throws BadInput unless the names of `frame_count` files differ.
FilePattern output_pattern(const FrameRequest& request, size_t frame_count);

// The camera of that name. Throws BadInput beginning with `option`.
const Camera& find_camera(const Scene& scene, const std::string& option, const std::string& name);
// The camera that is asked for, of the scene or in words. Throws BadInput.
Camera requested_camera(const FrameRequest& request, const Scene& scene);

// The stream at `path`. Throws BadInput when it has no solution.
Stream read_solved(const std::string& path);

// Reports that work on frame `number` begins, when `done` of `count` frames are finished.
void report_frame(const Progress& progress, size_t done, size_t count, int number);

}  // namespace strad
