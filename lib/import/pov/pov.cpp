// POV-Ray scene files, as scenes.
#include "import/pov/pov.h"

#include "base/text.h"
#include "import/pov/build.h"
#include "import/pov/scene_reader.h"

namespace strad {
namespace {

// POV-Ray's default camera is left-handed: z ahead, y up, x to the right.
bool is_left_handed(const PovCamera& camera) {
  return dot(cross(camera.direction, camera.up), camera.right) < 0;
}

}  // namespace

Scene import_pov(const std::string& path, const ImportOptions& options, ImportReport* report) {
  PovSceneReader reader(options, report);
  reader.read(path);
  const bool mirror = !reader.camera() || is_left_handed(*reader.camera());
  PovBuilder builder(options, report, mirror);
  for (const auto& [name, object] : reader.placed()) builder.add_object(name, object);
  for (const auto& [name, object] : reader.placed())
    for (const PovLight& light : object.lights) builder.add_light(light);
  if (reader.camera()) builder.add_camera(*reader.camera());
  return finish_import(builder.take(), options, text_name(path));
}

}  // namespace strad
