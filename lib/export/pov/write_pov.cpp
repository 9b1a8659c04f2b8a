#include "export/pov/write_pov.h"

#include <cmath>

#include "base/error.h"
#include "export/pov/pov.h"
#include "stream/output_file.h"

namespace strad {
namespace {

// POV-Ray's clock runs evenly from the first frame to the last.
void require_even(const std::vector<FrameTime>& frames) {
  for (size_t i = 2; i < frames.size(); ++i) {
    const double first = frames[1].time - frames[0].time, step = frames[i].time - frames[i - 1].time;
    if (!(first > 0) || !(std::abs(step - first) <= 1e-6 * first)) {
      throw BadInput("--pov: expected times that are evenly spaced and ascend");
    }
  }
}

PovOptions pov_options(const FrameRequest& request, const Scene& scene) {
  PovOptions options;
  options.pattern = request.output;
  options.light = request.raster.direct == DirectFrom::kMesh ? PovLighting::kBaked : PovLighting::kLights;
  options.camera = requested_camera(request, scene);
  options.width = static_cast<int>(request.raster.width);
  options.height = static_cast<int>(request.raster.height);
  options.exposure = request.exposure;
  return options;
}

}  // namespace

void write_pov(const FrameRequest& request, const Progress& progress) {
  const Stream stream = read_solved(request.stream);
  const std::vector<FrameTime> frames =
      requested_frames(request, stream.scene, solved_range(*stream.solution));
  require_even(frames);
  const PovExport pov(stream.scene, *stream.solution, frames, pov_options(request, stream.scene));
  for (const ExportFile& file : pov.common_files()) write_text_file(file.name, file.bytes);
  for (size_t i = 0; i < frames.size(); ++i) {
    report_frame(progress, i, frames.size(), frames[i].number);
    const ExportFile file = pov.frame_file(i);
    write_text_file(file.name, file.bytes);
  }
}

}  // namespace strad
