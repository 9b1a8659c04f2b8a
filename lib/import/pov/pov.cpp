// POV-Ray scene files, as scenes.
#include "import/pov/pov.h"

#include <cstdio>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/build.h"
#include "import/pov/scene_reader.h"
#include "import/smooth_normals.h"

namespace strad {
namespace {

// POV-Ray's default camera is left-handed: z ahead, y up, x to the right.
bool is_left_handed(const PovCamera& camera) {
  return dot(cross(camera.direction, camera.up), camera.right) < 0;
}

std::string frame_words(const PovRun& run) {
  char clock[32];
  std::snprintf(clock, sizeof clock, "%.6g", run.clock);
  return "frame " + std::to_string(run.frame_number) + " (clock " + clock + ")";
}

// `extent`: of the first frame, which sets it.
using Extent = std::optional<PovSceneReader::Extent>;

// What frames have in common.
struct Shared {
  PovFiles files;
  PovCutCache cuts;
  Extent extent;
};

PovFrame read_frame(const std::string& path, const ImportOptions& options, const PovRun& run, Shared* shared,
                    ImportReport* report) {
  shared->cuts.next_frame();
  PovSceneReader reader(options, run, &shared->files, report, &shared->cuts);
  reader.read(path);
  reader.cut_endless(&shared->extent);
  return {std::move(reader.placed()), reader.camera()};
}

// Follows the scene through all frames after the first.
void follow(const std::string& path, const ImportOptions& options, const PovAnimation& animation,
            Shared* shared, PovFollowed* followed, const Progress& progress) {
  const int count = animation.last - animation.first + 1;
  for (int frame = animation.first + 1; frame <= animation.last; ++frame) {
    const PovRun run = run_of(animation, frame);
    if (progress) progress(static_cast<double>(frame - animation.first) / count, "frames");
    ImportReport again;  // of what the first frame's has told
    PovFrame now;
    try {
      now = read_frame(path, options, run, shared, &again);
    } catch (const BadInput& error) {
      throw BadInput(std::string(error.what()) + ", in " + frame_words(run));
    }
    followed->add_frame(now, frame_words(run));
  }
}

}  // namespace

Scene import_pov(const std::string& path, const ImportOptions& options, ImportReport* report,
                 const PovAnimation& animation, const Progress& progress) {
  Shared shared;
  const PovFrame first = read_frame(path, options, run_of(animation, animation.first), &shared, report);
  const bool mirror = !first.camera || is_left_handed(*first.camera);
  std::optional<PovFollowed> followed;
  std::vector<double> times;
  if (animation.moves) {
    followed.emplace(first, mirror, options, report);
    follow(path, options, animation, &shared, &*followed, progress);
    for (int frame = animation.first; frame <= animation.last; ++frame)
      times.push_back((frame - animation.first) / animation.rate);
  }
  PovBuilder builder(options, report, mirror, followed ? &*followed : nullptr, times);
  for (size_t i = 0; i < first.placed.size(); ++i) builder.add_object(first.placed[i], i);
  for (size_t i = 0; i < first.placed.size(); ++i)
    for (size_t l = 0; l < first.placed[i].object.lights.size(); ++l)
      builder.add_light(first.placed[i], i, l);
  if (first.camera) builder.add_camera(*first.camera);
  Scene scene = builder.take();
  if (animation.moves) {
    scene.rate = animation.rate;
    scene.end = static_cast<double>(times.size()) / animation.rate;
  }
  const std::string left_out = report->first_left_out();
  if (scene.polygons.empty() && !left_out.empty())
    throw BadInput(text_name(path) + ": has no polygons but what was left out; " + left_out);
  smooth_by_angle(options.smooth, &scene);
  return finish_import(std::move(scene), options, text_name(path), report);
}

}  // namespace strad
