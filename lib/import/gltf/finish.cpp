#include "import/gltf/finish.h"

#include "base/text.h"

namespace strad {
namespace {

void require_within(double value, double most, const GltfMaterial& from, const std::string& file,
                    const std::string& factor) {
  if (!(value >= 0 && value <= most))
    fail_at(file, 1,
            "material " + from.name + ": its " + factor + " is not within 0.." +
                std::to_string(static_cast<int>(most)));
}

}  // namespace

// The metallic share of a surface mirrors, the rest of it reflects diffusely or transmits (glTF 2.0, appendix
// B.2). The faint mirror of plastic and paint is left out, as in other formats: highlights of these are light
// that the solve has no place for.
void set_finish(const GltfMaterial& from, Material* material, const std::string& file, ImportReport* report) {
  require_within(from.metallic, 1, from, file, "metallicFactor");
  require_within(from.roughness, 1, from, file, "roughnessFactor");
  require_within(from.transmission, 1, from, file, "transmissionFactor");
  require_within(from.ior, 100, from, file, "ior");
  const auto metallic = static_cast<float>(from.metallic);
  const bool lamp = !is_black(material->emission);
  const float transmission = lamp ? 0 : (1 - metallic) * static_cast<float>(from.transmission);
  material->reflectance = (1 - metallic - transmission) * from.base_colour;
  if (lamp && from.transmission > 0) report->add("a material that emits is opaque", file, 1);
  Finish& finish = material->finish;
  finish.transmission = transmission * from.base_colour;
  if (!is_black(finish.transmission)) {
    finish.specular = {1, 1, 1};
    finish.fresnel = true;
    finish.ior = from.ior > 0 ? static_cast<float>(from.ior) : 1.5f;  // 0 asks for a look without physics
  } else if (metallic > 0) {
    finish.specular = metallic * from.base_colour;
    finish.roughness = static_cast<float>(from.roughness * from.roughness);
    finish.metallic = true;
  }
  limit_energy(material, file, 1, report);
}

}  // namespace strad
