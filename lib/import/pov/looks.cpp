#include "import/pov/looks.h"

#include <algorithm>

namespace strad {
namespace {

Rgb quotient(Rgb a, Rgb b) {
  Rgb result;
  for (int c = 0; c < 3; ++c) result[c] = b[c] != 0 ? a[c] / b[c] : 0;
  return result;
}

// What the opaque part emits, by the pigment's colour.
Rgb glow(const PovTexture& texture) {
  const PovFinish& finish = texture.finish;
  const bool by_ambient = finish.diffuse == 0 && is_black(finish.emission) && is_black(finish.reflection);
  return by_ambient ? finish.ambient : finish.emission;
}

// A texture that reflects and emits this, as a pigment of diffuse 1.
void set_sums(PovTexture* texture, Rgb reflectance, Rgb emission) {
  PovFinish& finish = texture->finish;
  PovPigment& pigment = texture->pigment;
  finish.diffuse = 1;
  finish.reflection = {};
  finish.fresnel = false;
  finish.ambient = {};
  const float opaque = static_cast<float>(pigment.opacity);
  pigment.colour = opaque > 0 ? (1 / opaque) * reflectance : Rgb{};
  // Emission is a multiple of the colour: where there is none, of what would be black.
  for (int c = 0; c < 3; ++c)
    if (emission[c] > 0 && !(pigment.colour[c] > 0)) pigment.colour[c] = 1e-6f;
  finish.emission = opaque > 0 ? quotient((1 / opaque) * emission, pigment.colour) : Rgb{};
}

void take_remarks(PovTexture* to, const PovTexture& from) {
  const auto take = [](std::optional<PovProblem>* mine, const std::optional<PovProblem>& theirs) {
    if (!*mine) *mine = theirs;
  };
  take(&to->pigment.problem, from.pigment.problem);
  take(&to->pigment.note, from.pigment.note);
  take(&to->finish.problem, from.finish.problem);
  take(&to->finish.note, from.finish.note);
  take(&to->finish.mirror_note, from.finish.mirror_note);
}

bool is_plain(const PovFinish& a, const PovFinish& b) {
  return a.diffuse == b.diffuse && a.ambient == b.ambient && a.emission == b.emission &&
         a.reflection == b.reflection && a.metallic == b.metallic && a.fresnel == b.fresnel;
}

}  // namespace

PovPigment plain_pigment(const PovNumbers& colour) {
  PovPigment pigment;
  const PovNumbers c = promoted(colour, 3);
  for (int i = 0; i < 3; ++i) pigment.colour[i] = static_cast<float>(c[i]);
  const double filter = c.size >= 4 ? c[3] : 0, transmit = c.size >= 5 ? c[4] : 0;
  pigment.opacity = std::clamp(1 - filter - transmit, 0.0, 1.0);
  for (int i = 0; i < 3; ++i)
    pigment.passes[i] = std::clamp(static_cast<float>(transmit + filter * c[i]), 0.0f, 1.0f);
  return pigment;
}

std::vector<double> weights_of(const PovMap& map) {
  const auto& entries = map.entries;
  std::vector<double> weights(entries.size(), 0);
  const auto at = [&](size_t i) { return std::clamp(entries[i].first, 0.0, 1.0); };
  for (size_t i = 0; i < entries.size(); ++i) {
    const double before = i == 0 ? 0 : (at(i - 1) + at(i)) / 2;
    const double after = i + 1 == entries.size() ? 1 : (at(i) + at(i + 1)) / 2;
    weights[i] = std::max(0.0, after - before);
  }
  return weights;
}

Rgb reflectance_of(const PovTexture& texture) {
  const PovFinish& finish = texture.finish;
  const Rgb colour = texture.pigment.colour;
  const Rgb mirror = finish.metallic ? finish.reflection * colour : finish.reflection;
  return static_cast<float>(texture.pigment.opacity) * (static_cast<float>(finish.diffuse) * colour + mirror);
}

Rgb diffuse_of(const PovTexture& texture) {
  const auto share = static_cast<float>(texture.pigment.opacity);
  return share * (static_cast<float>(texture.finish.diffuse) * texture.pigment.colour);
}

// POV-Ray's fresnel needs an interior; without one, that of common glass is meant.
Finish finish_of(const PovTexture& texture) {
  const PovFinish& of = texture.finish;
  Finish finish;
  finish.fresnel = of.fresnel;
  finish.metallic = of.metallic && !of.fresnel && !is_black(of.reflection);
  finish.specular = of.metallic ? of.reflection * texture.pigment.colour : of.reflection;
  for (int c = 0; c < 3; ++c) finish.specular[c] = std::clamp(finish.specular[c], 0.0f, 1.0f);
  if (texture.pigment.opacity < kOpaque) finish.transmission = texture.pigment.passes;
  const bool clear = !is_black(finish.transmission);
  if (texture.ior > 0 && (texture.ior != 1 || (clear && !of.fresnel)))
    finish.ior = static_cast<float>(texture.ior);
  return is_plain(finish) ? Finish{} : finish;
}

Rgb emission_of(const PovTexture& texture) {
  return static_cast<float>(texture.pigment.opacity) * (texture.pigment.colour * glow(texture));
}

PovTexture mean_texture(std::span<const std::pair<double, PovTexture>> weighted) {
  double total = 0;
  for (const auto& [weight, texture] : weighted) total += weight;
  PovTexture mean = weighted.front().second;
  bool same_finish = true;
  double opacity = 0;
  Rgb passes, reflectance, emission, colour;
  for (const auto& [weight, texture] : weighted) {
    const float part = static_cast<float>(weight / total);
    opacity += part * texture.pigment.opacity;
    passes += part * texture.pigment.passes;
    colour += part * static_cast<float>(texture.pigment.opacity) * texture.pigment.colour;
    reflectance += part * reflectance_of(texture);
    emission += part * emission_of(texture);
    same_finish = same_finish && is_plain(texture.finish, mean.finish);
    take_remarks(&mean, texture);
  }
  mean.pigment.opacity = opacity;
  mean.pigment.passes = passes;
  mean.pigment.image = nullptr;
  if (same_finish)
    mean.pigment.colour = opacity > 0 ? static_cast<float>(1 / opacity) * colour : Rgb{};
  else
    set_sums(&mean, reflectance, emission);
  return mean;
}

PovTexture layered(const PovTexture& top, const PovTexture& bottom) {
  if (top.pigment.opacity >= kOpaque) return top;
  PovTexture both = top;
  take_remarks(&both, bottom);
  if (!(top.pigment.opacity > 0)) both.pigment.image = bottom.pigment.image;
  const Rgb through = top.pigment.passes;
  both.pigment.opacity = 1 - (1 - top.pigment.opacity) * (1 - bottom.pigment.opacity);
  both.pigment.passes = through * bottom.pigment.passes;
  set_sums(&both, reflectance_of(top) + through * reflectance_of(bottom),
           emission_of(top) + through * emission_of(bottom));
  return both;
}

}  // namespace strad
