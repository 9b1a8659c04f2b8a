// POV-Ray animations: bodies are where the file itself puts its objects.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "import/pov/ini.h"
#include "import/pov/pov.h"
#include "import/pov/scene_reader.h"
#include "import/unique_names.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

Scene animated(const std::string& ini) {
  ImportReport report;
  const PovIni settings = read_pov_ini(ini, {}, &report);
  return import_pov(settings.scene, {}, &report, settings.animation);
}

// What the file describes at an instant.
std::vector<PovPlaced> placed_at(const PovIni& ini, double time) {
  PovRun run = run_of(ini.animation, 1);
  run.clock += run.clock_delta * time * ini.animation.rate;
  const ImportOptions options;
  PovFiles files;
  ImportReport report;
  PovSceneReader reader(options, run, &files, &report);
  reader.read(ini.scene);
  return reader.placed();
}

// The largest distance of a point of an object from where its body puts it, over the object's size. REQUIRES:
// objects whose shapes move as one; a camera that mirrors z.
double distance_at(const Scene& scene, const PovIni& ini, double time) {
  const std::vector<PovPlaced> rest = placed_at(ini, 0), now = placed_at(ini, time);
  const std::vector<Pose> poses = poses_at(scene, time);
  UniqueNames names;
  double worst = 0;
  for (size_t i = 0; i < rest.size(); ++i) {
    if (rest[i].object.facets.empty()) continue;
    const std::string name = names.unique(rest[i].name);
    const auto object = std::find_if(scene.objects.begin(), scene.objects.end(),
                                     [&](const Object& candidate) { return candidate.name == name; });
    EXPECT_NE(object, scene.objects.end()) << name;
    Box box;
    for (const Vec3 p : rest[i].object.points) box.add(p);
    for (size_t k = 0; k < rest[i].object.points.size(); ++k) {
      const Vec3 p = rest[i].object.points[k], q = now[i].object.points[k];
      worst = std::max(
          worst, length(poses[object->body] * Vec3{p.x, p.y, -p.z} - Vec3{q.x, q.y, -q.z}) / box.diagonal());
    }
  }
  return worst;
}

// scenes/crane at all frames, and at 200 random instants: vertices of streams are floats, of up to 4 m, so
// that they are off by 4 * 2^-24 = 2.4e-7 m; the smallest object is 0.4 m.
TEST(ImportPovAnimation, BodiesAreWhereTheFilePutsThem) {
  const std::string folder = STRAD_SOURCE_DIR "/scenes/crane/";
  ImportReport report;
  const PovIni ini = read_pov_ini(folder + "crane.ini", {}, &report);
  const Scene scene = animated(folder + "crane.ini");
  double at_frames = 0, between = 0;
  for (int frame = 0; frame <= 100; ++frame)
    at_frames = std::max(at_frames, distance_at(scene, ini, frame / 25.0));
  for (uint64_t i = 0; i < 200; ++i) {
    const double time = 4 * static_cast<double>(hash_of(7, i) >> 11) * 0x1p-53;
    between = std::max(between, distance_at(scene, ini, time));
  }
  RecordProperty("at_frames_1e9", std::to_string(1e9 * at_frames));
  RecordProperty("between_1e9", std::to_string(1e9 * between));
  EXPECT_LE(at_frames, 1e-5);
  EXPECT_LE(between, 1e-5);
}

}  // namespace
}  // namespace strad
