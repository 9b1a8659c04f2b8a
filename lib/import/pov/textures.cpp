// POV-Ray's textures: layers, finishes, and what they reflect and emit.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/looks.h"
#include "import/pov/scene_reader.h"

namespace strad {
PovTexture PovSceneReader::texture_block(const PovTexture& base) {
  const PovInterpreter::Deeper deeper(&in_);
  PovTexture texture = base;
  texture.name.clear();
  texture.place = in_.place();
  in_.expect("{");
  texture_items(&texture, base, "}");
  return texture;
}

// Up to and including the token `end`.
void PovSceneReader::texture_items(PovTexture* texture, const PovTexture& base, std::string_view end) {
  PovPattern pattern;
  while (!in_.take_if(end)) {
    PovTransform ignored;
    std::string name;
    if (const auto known = in_.named<PovTexture>(&name)) {
      *texture = *known;
      texture->name = name;
    } else if (in_.take_if("pigment")) {
      texture->pigment = pigment_block(base.pigment);
    } else if (in_.take_if("finish")) {
      texture->finish = finish_block(base.finish);
    } else if (in_.take_if("texture")) {
      *texture = texture_block(base);
    } else if (in_.take_if(",") || in_.take_if("uv_mapping") || transformation(&ignored)) {
      continue;
    } else if (in_.next_is("normal")) {
      in_.skip_item();
    } else if (pattern_item(&pattern)) {
      continue;
    } else if (in_.peek().kind == PovKind::kWord) {
      texture->pigment.problem = PovProblem{"texture " + std::string(in_.peek().text), in_.place()};
      in_.skip_item();
    } else {
      in_.fail_expected("pigment, finish or " + std::string(end));
    }
  }
  if (auto mean = mean_of_pattern(std::move(pattern), "texture")) {
    mean->name = texture->name;
    mean->place = texture->place;
    *texture = *mean;
  }
}

// The texture that is next, under those that follow it: layers.
PovTexture PovSceneReader::layers(PovTexture texture) {
  while (in_.next_is_plainly("texture")) {
    in_.take();
    texture = layered(texture_block(default_texture_), texture);
  }
  return texture;
}

PovTexture PovSceneReader::material_block(const PovTexture& base) {
  PovTexture texture = base;
  in_.expect("{");
  if (const auto known = in_.named<PovTexture>()) texture = *known;
  double ior = texture.ior;
  while (!in_.take_if("}")) {
    PovTransform ignored;
    if (in_.take_if("texture")) {
      texture = layers(texture_block(base));
    } else if (in_.take_if("interior")) {
      ior = interior_ior();
    } else if (!transformation(&ignored)) {
      if (in_.peek().kind != PovKind::kWord) in_.fail_expected("texture or }");
      in_.skip_item();
    }
  }
  texture.ior = ior;
  return texture;
}

// The rest of `reflection`: a colour, or { [darkest,] brightest, words }. A mirror that grows from darkest to
// brightest is taken as that of a dielectric where the darkest is black, else as their mean.
void PovSceneReader::mirror(PovFinish* finish) {
  const auto colour = [this] { return plain_pigment(in_.numbers()).colour; };
  finish->metallic = finish->fresnel = false;
  if (!in_.take_if("{")) {
    finish->reflection = colour();
    return;
  }
  std::vector<Rgb> colours;
  while (!in_.take_if("}")) {
    if (in_.take_if(",")) continue;
    if (in_.expression_is_next()) {
      colours.push_back(colour());
    } else if (in_.take_if("fresnel")) {
      finish->fresnel = !in_.expression_is_next() || in_.number() != 0;
    } else if (in_.peek().kind == PovKind::kWord) {
      finish->metallic = finish->metallic || in_.next_is("metallic");
      in_.skip_item();
    } else {
      in_.fail_expected("a colour or }");
    }
  }
  finish->reflection = colours.empty() ? Rgb{} : colours.back();
  const bool grows = colours.size() > 1 && !finish->fresnel;
  if (grows && is_black(colours.front()))
    finish->fresnel = true;
  else if (grows)
    finish->reflection = 0.5f * (colours.front() + colours.back());
}

// The rest of `interior`: its index of refraction. Of a declared one, that is not known.
double PovSceneReader::interior_ior() {
  constexpr double kOfGlass = 1.5;
  double ior = 1;
  in_.expect("{");
  while (!in_.take_if("}")) {
    if (in_.take_if("ior")) {
      ior = in_.number();
    } else if (in_.peek().kind == PovKind::kWord) {
      if (!is_one_of(in_.peek().text, {"media", "caustics", "dispersion", "dispersion_samples",
                                       "fade_distance", "fade_power", "fade_color", "fade_colour"}))
        ior = kOfGlass;
      in_.skip_item();
    } else {
      in_.take();
    }
  }
  return ior;
}

bool PovSceneReader::finish_light(PovFinish* finish) {
  const PovPlace at = in_.place();
  if (in_.take_if("ambient")) {
    finish->ambient = plain_pigment(in_.numbers()).colour;
  } else if (in_.take_if("emission")) {
    finish->emission = plain_pigment(in_.numbers()).colour;
  } else if (in_.take_if("diffuse")) {
    in_.take_if("albedo");
    finish->diffuse = in_.number();
    if (in_.take_if(",")) in_.number();  // of light from behind
  } else if (in_.take_if("reflection")) {
    mirror(finish);
    if (!is_black(finish->reflection))
      finish->mirror_note = PovProblem{"mirror reflection in layers or a pattern is taken as diffuse", at};
  } else {
    return false;
  }
  return true;
}

PovFinish PovSceneReader::finish_block(const PovFinish& base) {
  PovFinish finish = base;
  in_.expect("{");
  while (!in_.take_if("}")) {
    if (const auto known = in_.named<PovFinish>()) {
      finish = *known;
      continue;
    }
    if (in_.take_if(",") || finish_light(&finish)) continue;
    const PovPlace at = in_.place();
    if (in_.peek().kind != PovKind::kWord) in_.fail_expected("ambient, diffuse, emission or }");
    const std::string word(in_.peek().text);
    if (is_one_of(word, {"phong", "specular", "irid", "subsurface", "metallic", "brilliance"})) {
      finish.note = PovProblem{word + " is ignored: surfaces are diffuse", at};
    } else if (!is_one_of(word, {"phong_size", "roughness", "crand", "conserve_energy", "use_alpha",
                                 "fresnel", "reflection_exponent", "exponent", "ior", "refraction",
                                 "caustics", "fade_distance", "fade_power"})) {
      finish.problem = PovProblem{"finish " + word, at};
    }
    in_.skip_item();
  }
  return finish;
}

void PovSceneReader::default_block() {
  in_.expect("{");
  while (!in_.take_if("}")) {
    if (in_.take_if("texture")) {
      default_texture_ = layers(texture_block(default_texture_));
    } else if (in_.take_if("pigment")) {
      default_texture_.pigment = pigment_block(default_texture_.pigment);
    } else if (in_.take_if("finish")) {
      default_texture_.finish = finish_block(default_texture_.finish);
    } else {
      if (in_.peek().kind != PovKind::kWord) in_.fail_expected("texture, pigment, finish or }");
      in_.skip_item();
    }
  }
}

PovSurfacePointer PovSceneReader::surface_of(const PovTexture& texture) {
  // Light that is lost or split at a surface that is nearly clear is not worth an object.
  constexpr double kClear = 0.02;
  auto surface = std::make_shared<PovSurface>();
  const PovPigment& pigment = texture.pigment;
  const PovFinish& finish = texture.finish;
  surface->name = texture.name.empty() ? pigment.name : texture.name;
  surface->place = texture.place;
  surface->reflectance = diffuse_of(texture);
  surface->finish = finish_of(texture);
  surface->emission = emission_of(texture);
  surface->image = pigment.image;
  const float least = std::min({pigment.passes.r, pigment.passes.g, pigment.passes.b});
  surface->clear =
      pigment.opacity <= kClear && least >= 1 - kClear && texture.ior == 1 && is_black(finish.reflection);
  if (pigment.problem) surface->problems.push_back(*pigment.problem);
  if (finish.problem) surface->problems.push_back(*finish.problem);
  for (const auto& note : {pigment.note, finish.note})
    if (note) surface->notes.push_back(*note);
  if (finish.mirror_note && is_black(finish.reflection)) surface->notes.push_back(*finish.mirror_note);
  return surface;
}

// The mean of the surfaces at the three corners of a triangle.
PovSurfacePointer PovSceneReader::mean_of(const PovSurfacePointer& a, const PovSurfacePointer& b,
                                          const PovSurfacePointer& c) {
  if (a == b && b == c) return a;
  auto mean = std::make_shared<PovSurface>(*a);
  const float third = 1.0f / 3;
  mean->reflectance = third * (a->reflectance + b->reflectance + c->reflectance);
  mean->emission = third * (a->emission + b->emission + c->emission);
  // Three times a rounded third is not always 1: a reflectance that is the same in all corners is kept as it
  // is.
  if (a->reflectance == b->reflectance && b->reflectance == c->reflectance)
    mean->reflectance = a->reflectance;
  for (const PovSurfacePointer& other : {b, c})
    mean->problems.insert(mean->problems.end(), other->problems.begin(), other->problems.end());
  return mean;
}

}  // namespace strad
