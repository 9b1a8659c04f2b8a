#include "frame/frame_request.h"

#include "base/error.h"
#include "scene/motion_text.h"

namespace strad {

bool goes_to_files(const FrameRequest& request) { return !request.output.empty() && request.output != "-"; }

std::vector<FrameTime> requested_frames(const FrameRequest& request, const Scene& scene, TimeRange range) {
  if (!request.times.empty()) return parse_times(range, "--time", request.times);
  if (!request.frames.empty()) return parse_frames(scene, range, "--frames", request.frames);
  return all_frames(scene, range);
}

FilePattern output_pattern(const FrameRequest& request, size_t frame_count) {
  FilePattern pattern("--output", request.output);
  if (frame_count > 1 && !pattern.numbered()) {
    throw BadInput("--output: found '" + request.output + "' for " + std::to_string(frame_count) +
                   " frames, expected a number in it, such as frame.%04d.exr");
  }
  return pattern;
}

const Camera& find_camera(const Scene& scene, const std::string& option, const std::string& name) {
  if (scene.cameras.empty()) throw BadInput("the stream has no camera: strad-motion adds one");
  std::string known;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
    known += (known.empty() ? "" : ", ") + camera.name;
  }
  throw BadInput(option + ": found '" + name + "', expected one of " + known);
}

Camera requested_camera(const FrameRequest& request, const Scene& scene) {
  if (!request.camera_at.empty()) return parse_camera("--camera-at", request.camera_at);
  if (scene.cameras.empty())
    throw BadInput("the stream has no camera: use --camera-at, or add one with strad-motion");
  if (request.camera.empty()) return scene.cameras.front();
  return find_camera(scene, "--camera", request.camera);
}

Stream read_solved(const std::string& path) {
  Stream stream = read_stream(path);
  if (stream.solution && !stream.solution->slabs.empty()) return stream;
  throw BadInput((path.empty() || path == "-" ? "standard input" : path) +
                 ": found no solution, expected one from strad-solve");
}

void report_frame(const Progress& progress, size_t done, size_t count, int number) {
  if (!progress) return;
  progress(static_cast<double>(done) / static_cast<double>(count), "frame " + std::to_string(number));
}

}  // namespace strad
