#include "frame/write_pictures.h"

#include <optional>

#include "image/files.h"
#include "image/pnm.h"
#include "solution/solution_file.h"
#include "stream/output_file.h"

namespace strad {

void write_pictures(const FrameRequest& request, const Progress& progress) {
  SolutionFile file(request.stream);
  const Scene& scene = file.scene();
  const std::vector<FrameTime> frames = requested_frames(request, scene, {file.begin(), file.end()});
  const Camera& camera = find_camera(scene, "--camera", request.camera);
  std::optional<FilePattern> pattern;
  std::optional<Output> pipe;
  if (goes_to_files(request)) {
    pattern = output_pattern(request, frames.size());
    require_image_format(pattern->name(frames.front().number));
  } else {
    pipe.emplace("-");
  }
  RasterOptions options = request.raster;
  options.shutter = request.shutter / scene.rate;
  Raster raster(scene);
  for (size_t i = 0; i < frames.size(); ++i) {
    const auto [number, time] = frames[i];
    report_frame(progress, i, frames.size(), number);
    const Slab& slab = file.slab_for(time, time + options.shutter, parts_for(options));
    Image image = raster.render(slab, camera, time, options);
    expose(&image, request.exposure);
    if (pattern) {
      save_image(pattern->name(number), image);
    } else {
      pipe->write(request.pfm ? encode_pfm(image) : encode_ppm(image));
    }
  }
  if (pipe) pipe->commit();
}

}  // namespace strad
