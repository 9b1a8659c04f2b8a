// Scenes of other programs: what the readers of all formats have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "import/report.h"
#include "scene/scene.h"

namespace strad {

struct MaterialLight {
  std::string pattern;  // of material names, as a shell writes it
  Rgb radiance;         // W / (sr m^2)
};

struct ImportOptions : SkipOptions {
  double scale = 1;  // metres in a unit of the file, > 0
  char up = 'y';     // the file's upward axis, 'y' or 'z'; the scene is turned so that y is up
  std::vector<MaterialLight> lights;  // emission in place of the file's own; later ones win
  int tessellate = 16;                // sides of a round POV-Ray object, >= 3
};

// A surface that returns all light would keep it for ever.
constexpr float kMaxReflectance = 0.98f;

// `reflectance` lowered to kMaxReflectance, which is reported. Throws BadInput beyond 0..1.
Rgb limited_reflectance(Rgb reflectance, const std::string& file, uint32_t line, ImportReport* report);

// What the material `name` emits: as the last light of `options` that means it says, else `emission`.
Rgb overridden_emission(Rgb emission, const std::string& name, const ImportOptions& options);

// The last steps of an import: lights, scale and upward axis (of spots and cameras too), vertices and texture
// coordinates that nothing uses dropped, all checked. `name` is the file's in errors. Throws BadInput.
Scene finish_import(Scene scene, const ImportOptions& options, const std::string& name);

}  // namespace strad
