#include "frame/write_pictures.h"

#include <functional>
#include <optional>

#include "frame/plan.h"
#include "frame/preview.h"
#include "frame/reference.h"
#include "image/files.h"
#include "image/pnm.h"
#include "solution/solution_file.h"
#include "stream/output_file.h"

namespace strad {
namespace {

// Renders each frame, scales it by 2^exposure and writes it to its file or down a pipe.
void write_each(const FrameRequest& request, const Scene& scene, TimeRange range, double exposure,
                const Progress& progress, const Camera& camera,
                const std::function<Image(const Camera&, double time)>& render) {
  const std::vector<FrameTime> frames = requested_frames(request, scene, range);
  std::optional<FilePattern> pattern;
  std::optional<Output> pipe;
  if (goes_to_files(request)) {
    pattern = output_pattern(request, frames.size());
    require_image_format(pattern->name(frames.front().number));
  } else {
    pipe.emplace("-");
  }
  for (size_t i = 0; i < frames.size(); ++i) {
    const auto [number, time] = frames[i];
    report_frame(progress, i, frames.size(), number);
    Image image = render(camera, time);
    expose(&image, exposure);
    if (pattern) {
      save_image(pattern->name(number), image);
    } else {
      pipe->write(request.pfm ? encode_pfm(image) : encode_ppm(image));
    }
  }
  if (pipe) pipe->commit();
}

}  // namespace

void write_pictures(const FrameRequest& request, const Progress& progress) {
  SolutionFile file(request.stream);
  RasterOptions options = request.raster;
  options.shutter = request.shutter / file.scene().rate;
  Raster raster(file.scene());
  write_each(request, file.scene(), {file.begin(), file.end()}, request.exposure, progress,
             requested_camera(request, file.scene()), [&](const Camera& camera, double time) {
               const Slab& slab = file.slab_for(time, time + options.shutter, parts_for(options));
               return raster.render(slab, camera, time, options);
             });
}

void write_references(const FrameRequest& request, const Progress& progress) {
  const Scene scene = read_stream(request.stream).scene;
  ReferenceOptions options;
  options.width = request.raster.width;
  options.height = request.raster.height;
  options.paths = request.reference;
  options.shutter = request.shutter / scene.rate;
  options.seed = request.seed;
  const Reference reference(scene);
  write_each(request, scene, {scene.start, scene.end, "the animation"}, request.exposure, progress,
             requested_camera(request, scene),
             [&](const Camera& camera, double time) { return reference.render(camera, time, options); });
}

void write_shows(const FrameRequest& request, const Progress& progress) {
  ShowOptions options;
  options.what = *request.show;
  options.width = request.raster.width;
  options.height = request.raster.height;
  options.exposure = request.exposure;
  options.within = request.within;
  options.samples = request.raster.samples;
  if (!needs_solution(options.what)) {
    const Scene scene = read_stream(request.stream).scene;
    const Show show(scene);
    write_each(request, scene, {scene.start, scene.end, "the animation"}, 0, progress,
               requested_camera(request, scene), [&](const Camera& camera, double time) {
                 return show.render(nullptr, camera, time, options);
               });
    return;
  }
  SolutionFile file(request.stream);
  const Show show(file.scene());
  write_each(request, file.scene(), {file.begin(), file.end()}, 0, progress,
             requested_camera(request, file.scene()), [&](const Camera& camera, double time) {
               return show.render(&file.slab_at(time), camera, time, options);
             });
}

void write_previews(const FrameRequest& request, const Progress& progress) {
  const Scene scene = read_stream(request.stream).scene;
  const Preview preview(scene);
  write_each(request, scene, {scene.start, scene.end, "the animation"}, request.exposure, progress,
             requested_camera(request, scene), [&](const Camera& camera, double time) {
               return preview.render(camera, time, request.raster.width, request.raster.height);
             });
}

void write_plans(const FrameRequest& request, const Progress& progress) {
  const Scene scene = read_stream(request.stream).scene;
  const bool has_camera = !request.camera_at.empty() || !scene.cameras.empty();
  const Camera camera = has_camera ? requested_camera(request, scene) : Camera{};
  PlanOptions options;
  options.width = request.raster.width;
  options.height = request.raster.height;
  if (has_camera) options.up = camera.keys.front().up;
  write_each(request, scene, {scene.start, scene.end, "the animation"}, 0, progress,
             has_camera ? camera : Camera{"", {{}}}, [&](const Camera&, double time) {
               return plan_of(scene, has_camera ? &camera : nullptr, time, options);
             });
}

}  // namespace strad
