// Scenes of other programs: what the readers of all formats have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace strad {

struct MaterialLight {
  std::string pattern;  // of material names, as a shell writes it
  Rgb radiance;         // W / (sr m^2)
};

struct ImportOptions {
  double scale = 1;  // metres in a unit of the file, > 0
  char up = 'y';     // the file's upward axis, 'y' or 'z'; the scene is turned so that y is up
  std::vector<MaterialLight> lights;  // emission in place of the file's own; later ones win
  bool skip_missing = false;  // leave out files and materials that are not there, in place of refusing
  bool skip_unknown = false;  // leave out statements that have no meaning here, in place of refusing
  int tessellate = 16;        // sides of a round POV-Ray object, >= 3
};

// What was left out or changed, a line a kind: the first place in its file and how often.
class ImportReport {
 public:
  void add(const std::string& what, const std::string& file, uint32_t line);
  std::vector<std::string> lines() const;

 private:
  struct Entry {
    std::string what, file;
    uint32_t line = 0, count = 0;
  };
  std::vector<Entry> entries_;
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
