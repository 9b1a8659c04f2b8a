// An animation as files for POV-Ray: geometry once, the light of a frame in a small include, a scene, an
// .ini.
//
// strad-pov(5) describes the files and every name that they declare.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frame/frame_list.h"
#include "scene/scene.h"
#include "scene/trajectory.h"
#include "solution/solution.h"

namespace strad {

enum class PovLighting {
  kBaked,   // --direct mesh: surfaces emit their radiance; there are no lights
  kLights,  // --direct pixel: surfaces emit reflected indirect light; POV-Ray's lights add the direct light
};

struct PovOptions {
  std::string pattern = "frame.%04d.inc";  // of the frames' files; the names of the others follow from it
  PovLighting light = PovLighting::kLights;
  Camera camera;                  // the camera of the scene file; at least one key
  int width = 640, height = 480;  // pixels, for the .ini
  double exposure = 0;            // all light is scaled by 2^exposure
  int lamp_samples = 16;          // POV-Ray's lights along each side of an emitting surface
};

// A file to be written, its bytes complete.
struct ExportFile {
  std::string name;
  std::string bytes;
};

// REQUIRES: validated scene and solution, which outlive the export; frames of ascending number, evenly
// spaced. Throws BadInput for a pattern that does not hold one %d when there are several frames, and for
// names that POV-Ray cannot read.
class PovExport {
 public:
  PovExport(const Scene& scene, const Solution& solution, const std::vector<FrameTime>& frames,
            const PovOptions& options);
  ~PovExport();
  PovExport(const PovExport&) = delete;
  PovExport& operator=(const PovExport&) = delete;

  // Geometry, textures, the scene and the .ini: all that is written once.
  std::vector<ExportFile> common_files() const;
  // The include of frame i of `frames`. Thread-safe.
  ExportFile frame_file(size_t i) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace strad
