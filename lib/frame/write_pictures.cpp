#include "frame/write_pictures.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "base/clock.h"
#include "frame/auto_exposure.h"
#include "frame/frame_facts.h"
#include "frame/layered_frame.h"
#include "frame/plan.h"
#include "frame/preview.h"
#include "frame/reference.h"
#include "image/files.h"
#include "image/pnm.h"
#include "solution/solution_file.h"
#include "stream/output_file.h"

namespace strad {
namespace {

// Where pictures go: to files of their own or down a pipe.
class PictureOutput {
 public:
  // Throws BadInput unless the names of the files of `frames` differ and say a format.
  PictureOutput(const FrameRequest& request, const std::vector<FrameTime>& frames) : request_(request) {
    if (goes_to_files(request)) {
      pattern_ = output_pattern(request, frames.size());
      require_image_format(pattern_->name(frames.front().number));
    } else {
      pipe_.emplace("-");
    }
  }
  void write(int number, const Image& image, const PictureFacts& facts) {
    if (pattern_) return save_image(pattern_->name(number), image, request_.encoding, facts);
    pipe_->write(request_.pfm ? encode_pfm(image) : encode_ppm(image, request_.encoding));
  }
  void commit() {
    if (pipe_) pipe_->commit();
  }
  const std::optional<FilePattern>& pattern() const { return pattern_; }

 private:
  const FrameRequest& request_;
  std::optional<FilePattern> pattern_;
  std::optional<Output> pipe_;
};

using MakeFrame = std::function<void(FrameTime, const PictureFacts&)>;

// Do all files of a frame show it already? `path`: that of the frame.
bool is_there(const FrameRequest& request, const std::string& path, const PictureFacts& facts) {
  if (request.layers.empty()) return shows(path, facts);
  const std::vector<std::string> files = layer_files(path, request.layers);
  return std::all_of(files.begin(), files.end(), [&](const auto& file) { return shows(file, facts); });
}

// Makes each frame, or only those of which a file is missing, and tells what it cost. `pattern`: of the
// files, if frames go to files.
void make_each(const FrameRequest& request, const Scene& scene, const std::vector<FrameTime>& frames,
               const std::optional<FilePattern>& pattern, const Camera& camera, double exposure,
               const Progress& progress, const MakeFrame& make) {
  const std::string stream = pattern ? fingerprint_of(scene) : "";
  for (size_t i = 0; i < frames.size(); ++i) {
    report_frame(progress, i, frames.size(), frames[i].number);
    const double wall = wall_now(), cpu = cpu_now();
    const PictureFacts facts = facts_of(request, scene, stream, camera, frames[i], exposure);
    const bool kept = request.missing && is_there(request, pattern->name(frames[i].number), facts);
    if (!kept) make(frames[i], facts);
    if (request.told) request.told({frames[i].number, kept, wall_now() - wall, cpu_now() - cpu});
  }
}

// Renders each frame, scales it by 2^exposure and writes it.
void write_each(const FrameRequest& request, const Scene& scene, TimeRange range, double exposure,
                const Progress& progress, const Camera& camera,
                const std::function<Image(const Camera&, double time)>& render) {
  const std::vector<FrameTime> frames = requested_frames(request, scene, range);
  PictureOutput output(request, frames);
  make_each(request, scene, frames, output.pattern(), camera, exposure, progress,
            [&](FrameTime frame, const PictureFacts& facts) {
              Image image = render(camera, frame.time);
              expose(&image, exposure);
              output.write(frame.number, image, facts);
            });
  output.commit();
}

// The same in layers, which go to files.
void write_each_layered(const FrameRequest& request, const Scene& scene, TimeRange range, double exposure,
                        const Progress& progress,
                        const std::function<LayeredImage(const Camera&, double time)>& render) {
  const std::vector<FrameTime> frames = requested_frames(request, scene, range);
  const Camera camera = requested_camera(request, scene);
  const FilePattern pattern = output_pattern(request, frames.size());
  require_image_format(pattern.name(frames.front().number));
  make_each(request, scene, frames, pattern, camera, exposure, progress,
            [&](FrameTime frame, const PictureFacts& facts) {
              save_layered_frame(pattern.name(frame.number), render(camera, frame.time), request.layers,
                                 request.encoding, facts);
            });
}

}  // namespace

double write_pictures(const FrameRequest& asked, const Progress& progress) {
  SolutionFile file(asked.stream);
  FrameRequest request = asked;
  if (request.all_layers && has_finishes(file.scene())) {
    const auto emission = std::find(request.layers.begin(), request.layers.end(), LayerKind::kEmission);
    request.layers.insert(emission + 1, LayerKind::kSpecular);
  }
  RasterOptions options = request.raster;
  options.shutter = request.shutter / file.scene().rate;
  Raster raster(file.scene());
  double exposure = request.exposure;
  if (request.auto_exposure) {
    const Camera camera = requested_camera(request, file.scene());
    exposure = exposure_for(&file, &raster, camera, options, request.encoding);
  }
  const TimeRange range{file.begin(), file.end()};
  const auto slab_for = [&](double time) -> const Slab& {
    return file.slab_for(time, time + options.shutter, parts_for(options));
  };
  if (!request.layers.empty()) {
    write_each_layered(request, file.scene(), range, exposure, progress,
                       [&](const Camera& camera, double time) {
                         return render_layers(&raster, file.scene(), slab_for(time), camera, time, options,
                                              exposure, request.layers);
                       });
    return exposure;
  }
  write_each(request, file.scene(), range, exposure, progress, requested_camera(request, file.scene()),
             [&](const Camera& camera, double time) {
               return raster.render(slab_for(time), camera, time, options);
             });
  return exposure;
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
