#include "import/gltf/finish.h"

#include "base/text.h"

namespace strad {
namespace {

void require_share(double value, const GltfMaterial& from, const std::string& file,
                   const std::string& factor) {
  if (!(value >= 0 && value <= 1))
    fail_at(file, 1, "material " + from.name + ": its " + factor + " is not within 0..1");
}

}  // namespace

// The metallic share of a surface mirrors, the rest of it reflects diffusely or transmits (glTF 2.0, appendix
// B.2). The faint mirror of plastic and paint is left out, as in other formats: highlights of these are light
// that the solve has no place for.
void set_finish(const GltfMaterial& from, Rgb mean, Material* material, const std::string& file,
                ImportReport* report) {
  require_share(from.metallic, from, file, "metallicFactor");
  require_share(from.roughness, from, file, "roughnessFactor");
  require_share(from.transmission, from, file, "transmissionFactor");
  const auto metallic = static_cast<float>(from.metallic);
  const bool lamp = !is_black(material->emission);
  const float transmission = lamp ? 0 : (1 - metallic) * static_cast<float>(from.transmission);
  material->reflectance = (1 - metallic - transmission) * from.base_colour;
  if (lamp && from.transmission > 0) report->add("a material that emits is opaque", file, 1);
  Finish& finish = material->finish;
  finish.transmission = transmission * (mean * from.base_colour);
  if (!is_black(finish.transmission)) {
    finish.specular = {1, 1, 1};
    finish.fresnel = true;
    finish.ior = from.ior != 0 ? static_cast<float>(from.ior) : 1.5f;  // 0 asks for a look without physics
  } else if (metallic > 0) {
    finish.specular = metallic * (mean * from.base_colour);
    finish.roughness = static_cast<float>(from.roughness * from.roughness);
    finish.metallic = true;
  }
  if (material->texture != kNone && !is_plain(finish))
    report->add("the texture of a metal or of glass is taken as its mean colour there", file, 1);
  limit_energy(material, file, 1, report);
}

}  // namespace strad
