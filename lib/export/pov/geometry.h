// The geometry of an export for POV-Ray: bodies as meshes with a texture at each corner, pigments, image
// maps.
#pragma once

#include <string>
#include <vector>

#include "export/mesh.h"
#include "export/pov/text.h"
#include "scene/scene.h"

namespace strad {

// How a corner's light becomes POV-Ray's pigment and emission. POV-Ray shows pigment * emission, and adds
// pigment * diffuse * light where the scene has lights of POV-Ray. A frame's file has one colour for each
// corner:
//   light baked, no image:  the radiance, used as the pigment; the emission is 1
//   otherwise:              radiance / pigment (E / pi where nothing is emitted), used as the emission
class PovShading {
 public:
  PovShading(const Scene& scene, bool baked);  // keeps a reference

  Rgb value(const ExportCorner& corner, Rgb irradiance, float glow) const;
  bool baked() const { return baked_; }
  // Whether the pigment is the material's image. Not for emitting materials, whose image may be black.
  bool has_image(const ExportCorner& corner) const { return corner.textured && image_of(corner.material); }
  bool image_of(size_t material) const;
  // Whether the pigment is the material's colour or image, and not the colour in the frame's file.
  bool has_pigment(const ExportCorner& corner) const { return !baked_ || has_image(corner); }
  Rgb pigment(size_t material) const { return pigment_[material]; }
  // The finish words of a material's mirror; "": none.
  std::string mirror(size_t material) const;
  // The share of light that a material lets through, 0 if it is opaque.
  Rgb passes(size_t material) const { return scene_.materials[material].finish.transmission; }
  bool is_clear(size_t material) const;  // it reflects nothing diffusely and emits nothing
  // The index of refraction of a body's first solid glass, or first dielectric mirror; 1: there is none.
  float ior_of(const ExportBody& body, bool glass) const;

 private:
  const Scene& scene_;
  bool baked_;
  std::vector<Rgb> textured_reflectance_, pigment_;  // per material
  std::vector<bool> bends_;                          // per material: solid glass or a dielectric mirror
};

// Names in the files, per body and per material; "" for materials without an image file.
struct PovIdentifiers {
  std::vector<std::string> bodies, materials, image_files;
};

// Appends the finish and the pigments of all materials.
void write_pigments(const Scene& scene, const PovShading& shading, const PovIdentifiers& names, PovText* out);

// Appends the declaration of strad_body_NAME, which expects strad_radiance_NAME.
void write_body(const PovShading& shading, const ExportBody& body, const PovIdentifiers& names, PovText* out);

// A material's reflectance times its texture as PPM, 16 bits per channel, linear.
std::string pov_image(const Scene& scene, const Material& material);

}  // namespace strad
