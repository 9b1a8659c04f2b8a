// Scenes of other programs: what the readers of all formats have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "import/report.h"
#include "scene/scene.h"

namespace strad {

struct MaterialLight {
  std::string pattern;  // of material names; a shell pattern
  Rgb radiance;         // W / (sr m^2)
};

struct ImportOptions : SkipOptions {
  double scale = 1;  // metres per unit of the file, > 0
  char up = 'y';     // the file's upward axis, 'y' or 'z'; the scene is turned so that y is up
  std::vector<MaterialLight> lights;  // replace the file's emission; later ones win
  double smooth =
      0;  // degrees: faces without normals and groups that meet at up to it are one smooth surface
  int tessellate = 16;  // sides of a POV-Ray sphere, cylinder, cone or disc, >= 3
};

// Must be below 1: light between surfaces that reflect all of it never fades.
constexpr float kMaxReflectance = 0.98f;

// `reflectance` lowered to kMaxReflectance, which is reported. Throws BadInput beyond 0..1.
Rgb limited_reflectance(Rgb reflectance, const std::string& file, uint32_t line, ImportReport* report);

// Lowers the diffuse reflectance of a material with a finish to what mirror and glass leave of the light,
// which is reported. What Fresnel's equations give is taken at right angles. Throws BadInput for an index of
// refraction that cannot be.
void limit_energy(Material* material, const std::string& file, uint32_t line, ImportReport* report);

// What the material `name` emits: the radiance of the last light in `options` whose pattern matches it, else
// `emission`.
Rgb overridden_emission(Rgb emission, const std::string& name, const ImportOptions& options);

// The last steps of an import. Sets the emission that `options.lights` asks for, drops vertices and texture
// coordinates that are not used, applies the scale and the upward axis (also to bodies, spots and cameras),
// takes names that are not UTF-8 as Latin-1, which is reported, and validates. `name` is the file's in
// errors. Throws BadInput.
Scene finish_import(Scene scene, const ImportOptions& options, const std::string& name, ImportReport* report);

}  // namespace strad
