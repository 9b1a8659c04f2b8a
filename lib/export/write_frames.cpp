#include "export/write_frames.h"

#include <cmath>
#include <functional>
#include <optional>

#include "base/error.h"
#include "export/ply/ply.h"
#include "export/pov/pov.h"
#include "frame/file_pattern.h"
#include "frame/frame_list.h"
#include "image/files.h"
#include "image/pnm.h"
#include "stream/output_file.h"

namespace strad {
namespace {

bool to_files(const FrameRequest& request) { return !request.output.empty() && request.output != "-"; }

std::vector<FrameTime> frames_of(const FrameRequest& request, const Scene& scene, TimeRange range) {
  if (!request.times.empty()) return parse_times(range, "--time", request.times);
  if (!request.frames.empty()) return parse_frames(scene, range, "--frames", request.frames);
  return all_frames(scene, range);
}

FilePattern pattern_for(const FrameRequest& request, size_t frame_count) {
  FilePattern pattern("--output", request.output);
  if (frame_count > 1 && !pattern.numbered()) {
    throw BadInput("--output: found '" + request.output + "' for " + std::to_string(frame_count) +
                   " frames, expected a number in it, such as frame.%04d.exr");
  }
  return pattern;
}

void write_file(const std::string& name, const std::string& bytes) {
  Output file(name);
  file.write(bytes);
  file.commit();
}

void report(const Progress& progress, size_t done, size_t count, int number) {
  if (!progress) return;
  progress(static_cast<double>(done) / static_cast<double>(count), "frame " + std::to_string(number));
}

Stream read_solved(const std::string& path) {
  Stream stream = read_stream(path);
  if (stream.solution && !stream.solution->slabs.empty()) return stream;
  throw BadInput((path.empty() || path == "-" ? "standard input" : path) +
                 ": found no solution, expected one from strad-solve");
}

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
  options.camera = find_camera(scene, "--camera", request.camera);
  options.width = static_cast<int>(request.raster.width);
  options.height = static_cast<int>(request.raster.height);
  options.exposure = request.exposure;
  return options;
}

// Renders each frame and writes it to its file or down a pipe.
void write_each(const FrameRequest& request, const Scene& scene, TimeRange range, const Progress& progress,
                const std::function<Image(const Camera&, double time)>& render) {
  const std::vector<FrameTime> frames = frames_of(request, scene, range);
  const Camera& camera = find_camera(scene, "--camera", request.camera);
  std::optional<FilePattern> pattern;
  std::optional<Output> pipe;
  if (to_files(request)) {
    pattern = pattern_for(request, frames.size());
    require_image_format(pattern->name(frames.front().number));
  } else {
    pipe.emplace("-");
  }
  for (size_t i = 0; i < frames.size(); ++i) {
    const auto [number, time] = frames[i];
    report(progress, i, frames.size(), number);
    Image image = render(camera, time);
    expose(&image, request.exposure);
    if (pattern) {
      save_image(pattern->name(number), image);
    } else {
      pipe->write(request.pfm ? encode_pfm(image) : encode_ppm(image));
    }
  }
  if (pipe) pipe->commit();
}

}  // namespace

const Camera& find_camera(const Scene& scene, const std::string& option, const std::string& name) {
  if (scene.cameras.empty()) throw BadInput("the stream has no camera: strad-motion adds one");
  if (name.empty()) return scene.cameras.front();
  std::string known;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
    known += (known.empty() ? "" : ", ") + camera.name;
  }
  throw BadInput(option + ": found '" + name + "', expected one of " + known);
}

void write_pictures(const FrameRequest& request, const Progress& progress) {
  SolutionFile file(request.stream);
  RasterOptions options = request.raster;
  options.shutter = request.shutter / file.scene().rate;
  Raster raster(file.scene());
  write_each(request, file.scene(), {file.begin(), file.end()}, progress,
             [&](const Camera& camera, double time) {
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
  write_each(request, scene, {scene.start, scene.end, "the animation"}, progress,
             [&](const Camera& camera, double time) { return reference.render(camera, time, options); });
}

void write_ply(const FrameRequest& request, const Progress& progress) {
  const Stream stream = read_solved(request.stream);
  const std::vector<FrameTime> frames = frames_of(request, stream.scene, solved_range(*stream.solution));
  if (!to_files(request) && frames.size() > 1) {
    throw BadInput("--ply: found " + std::to_string(frames.size()) +
                   " frames for standard output, expected one, or -o with a pattern such as frame.%04d.ply");
  }
  const PlyExport meshes(stream.scene, *stream.solution);
  if (!to_files(request)) return write_file("-", meshes.frame(frames.front().time, request.exposure));
  const FilePattern pattern = pattern_for(request, frames.size());
  for (size_t i = 0; i < frames.size(); ++i) {
    report(progress, i, frames.size(), frames[i].number);
    write_file(pattern.name(frames[i].number), meshes.frame(frames[i].time, request.exposure));
  }
}

void write_pov(const FrameRequest& request, const Progress& progress) {
  const Stream stream = read_solved(request.stream);
  const std::vector<FrameTime> frames = frames_of(request, stream.scene, solved_range(*stream.solution));
  require_even(frames);
  const PovExport pov(stream.scene, *stream.solution, frames, pov_options(request, stream.scene));
  for (const ExportFile& file : pov.common_files()) write_file(file.name, file.bytes);
  for (size_t i = 0; i < frames.size(); ++i) {
    report(progress, i, frames.size(), frames[i].number);
    const ExportFile file = pov.frame_file(i);
    write_file(file.name, file.bytes);
  }
}

}  // namespace strad
