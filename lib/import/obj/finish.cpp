#include "import/obj/finish.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// Above this exponent highlights are so sharp that exporters mean a perfect mirror.
constexpr float kSharpest = 1000;

Rgb limited(Rgb share, const char* what, const MtlMaterial& from, ImportReport* report) {
  if (!(max_channel(share) > 1)) return share;
  report->add(std::string(what) + " above 1 is taken as 1", from.file, from.line);
  for (int c = 0; c < 3; ++c) share[c] = std::min(share[c], 1.0f);
  return share;
}

// The alpha of facets whose highlights are as wide as those of Blinn's exponent (Walter et al. 2007).
float roughness_of(float exponent) {
  if (!(exponent > 0) || exponent >= kSharpest) return 0;
  return std::min(1.0f, std::sqrt(2 / (exponent + 2)));
}

void set_glass(const MtlMaterial& from, Material* material, ImportReport* report) {
  Finish& finish = material->finish;
  const Rgb filter = limited(from.filter.value_or(Rgb{1, 1, 1}), "Tf", from, report);
  // Clear unless d says how much; where Tf is given too and d says opaque, Tf is what was meant.
  const float d = std::clamp(from.dissolve.value_or(0), 0.0f, 1.0f);
  const float passes = d == 1 && from.filter ? 1 : 1 - d;
  finish.transmission = passes * filter;
  finish.ior = from.ior;
  if (!is_black(finish.transmission)) {
    const bool tinted = from.specular && !is_black(*from.specular);
    finish.specular = tinted ? limited(*from.specular, "Ks", from, report) : Rgb{1, 1, 1};
    finish.fresnel = true;
  }
  material->reflectance = (1 - passes) * material->reflectance;
}

void set_mirror(const MtlMaterial& from, Material* material, ImportReport* report) {
  Finish& finish = material->finish;
  finish.specular = limited(from.specular.value_or(Rgb{1, 1, 1}), "Ks", from, report);
  finish.roughness = roughness_of(from.exponent);
  finish.fresnel = from.illum == 5;
  finish.ior = from.ior;
}

}  // namespace

void set_finish(const MtlMaterial& from, Material* material, ImportReport* report) {
  const bool lamp = !is_black(material->emission);
  if (from.is_glass() && lamp)
    report->add("a material that emits is opaque", from.file, from.line);
  else if (from.is_glass())
    set_glass(from, material, report);
  else if (from.is_mirror())
    set_mirror(from, material, report);
  limit_energy(material, from.file, from.line, report);
}

}  // namespace strad
