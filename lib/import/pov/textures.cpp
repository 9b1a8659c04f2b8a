// POV-Ray's textures: plain colours and pictures, diffuse reflection and emission.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/scene_reader.h"

namespace strad {
namespace {

Rgb rgb_of(const PovNumbers& numbers) {
  Rgb rgb;
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<float>(numbers[numbers.size == 1 ? 0 : i]);
  return rgb;
}

}  // namespace

PovTexture PovSceneReader::texture_block(const PovTexture& base) {
  PovTexture texture = base;
  texture.name.clear();
  texture.place = in_.place();
  in_.expect("{");
  if (std::string name; auto known = in_.named<PovTexture>(&name)) {
    texture = *known;
    texture.name = name;
  }
  while (!in_.take_if("}")) {
    PovTransform ignored;
    if (in_.take_if("pigment")) {
      texture.pigment = pigment_block(base.pigment);
    } else if (in_.take_if("finish")) {
      texture.finish = finish_block(base.finish);
    } else if (in_.take_if("uv_mapping") || transformation(&ignored)) {
      continue;
    } else if (in_.next_is("normal")) {
      in_.skip_item();
    } else if (in_.peek().kind == PovKind::kWord) {
      texture.pigment.problem = PovProblem{"texture " + std::string(in_.peek().text), in_.place()};
      in_.skip_item();
    } else {
      in_.fail_expected("pigment, finish or }");
    }
  }
  return texture;
}

PovTexture PovSceneReader::material_block(const PovTexture& base) {
  PovTexture texture = base;
  in_.expect("{");
  if (const auto known = in_.named<PovTexture>()) texture = *known;
  while (!in_.take_if("}")) {
    PovTransform ignored;
    if (in_.take_if("texture")) {
      texture = texture_block(base);
    } else if (!transformation(&ignored)) {
      if (in_.peek().kind != PovKind::kWord) in_.fail_expected("texture or }");
      in_.skip_item();
    }
  }
  return texture;
}

PovPigment PovSceneReader::pigment_block(const PovPigment& base) {
  PovPigment pigment = base;
  pigment.name.clear();
  in_.expect("{");
  if (std::string name; auto known = in_.named<PovPigment>(&name)) {
    pigment = *known;
    pigment.name = name;
  }
  while (!in_.take_if("}")) {
    PovTransform ignored;
    if (in_.take_if("uv_mapping") || transformation(&ignored)) continue;
    if (in_.expression_is_next()) {
      const PovPlace at = in_.place();
      const PovNumbers plain = in_.numbers();
      pigment = {pigment.name, rgb_of(plain), nullptr, {}};
      if (plain.size >= 4 && (plain[3] != 0 || plain[4] != 0))
        pigment.problem = PovProblem{"transparency of a pigment", at};
    } else if (in_.take_if("image_map")) {
      pigment.image = image_block();
      pigment.colour = {1, 1, 1};
    } else if (in_.take_if("quick_color") || in_.take_if("quick_colour")) {
      in_.colour();
    } else if (in_.peek().kind == PovKind::kWord) {
      if (!pigment.problem)
        pigment.problem = PovProblem{"pigment " + std::string(in_.peek().text), in_.place()};
      pigment.colour = {0.5f, 0.5f, 0.5f};  // used only if the problem is skipped
      in_.skip_item();
    } else {
      in_.fail_expected("a colour or }");
    }
  }
  return pigment;
}

// image_map { [type] "file" [gamma G] [interpolate I] }
std::shared_ptr<const PovImage> PovSceneReader::image_block() {
  auto image = std::make_shared<PovImage>();
  image->place = in_.place();
  in_.expect("{");
  while (!in_.take_if("}")) {
    if (in_.take_if("gamma")) {
      image->linear = !in_.take_if("srgb") && in_.number() == 1;
    } else if (in_.peek().kind == PovKind::kString || in_.next_is("concat")) {
      image->name = in_.string();
    } else if (const auto known = in_.named<std::string>()) {
      image->name = *known;
    } else if (!in_.take_if(",") && in_.peek().kind == PovKind::kWord) {
      in_.take();  // the type, or interpolate
      if (in_.expression_is_next()) in_.numbers();
    } else if (in_.peek().kind != PovKind::kNumber) {
      in_.fail_expected("a file name in quotes");
    } else {
      in_.take();
    }
  }
  if (image->name.empty()) fail_at(image->place.file, image->place.line, "image_map names no file");
  image->path = path_beside(image->place.file, image->name);
  return image;
}

PovFinish PovSceneReader::finish_block(const PovFinish& base) {
  PovFinish finish = base;
  in_.expect("{");
  if (const auto known = in_.named<PovFinish>()) finish = *known;
  while (!in_.take_if("}")) {
    const PovPlace at = in_.place();
    if (in_.peek().kind != PovKind::kWord) in_.fail_expected("ambient, diffuse, emission or }");
    const std::string word(in_.peek().text);
    if (in_.take_if("ambient")) {
      finish.ambient = in_.colour();
    } else if (in_.take_if("emission")) {
      finish.emission = in_.colour();
    } else if (in_.take_if("diffuse")) {
      in_.take_if("albedo");
      finish.diffuse = in_.number();
      if (in_.take_if(",")) in_.number();  // of light from behind
    } else if (in_.take_if("reflection")) {
      if (in_.next_is("{")) {
        in_.skip_block();
        finish.problem = PovProblem{"mirror reflection", at};
      } else if (max_channel(in_.colour()) > 0) {
        finish.problem = PovProblem{"mirror reflection", at};
      }
    } else if (is_one_of(word, {"phong", "specular", "irid", "subsurface", "metallic", "brilliance"})) {
      finish.note = PovProblem{word + " is ignored: surfaces are diffuse", at};
      in_.skip_item();
    } else if (is_one_of(word,
                         {"phong_size", "roughness", "crand", "conserve_energy", "use_alpha", "fresnel"})) {
      in_.skip_item();
    } else {
      finish.problem = PovProblem{"finish " + word, at};
      in_.skip_item();
    }
  }
  return finish;
}

void PovSceneReader::default_block() {
  in_.expect("{");
  while (!in_.take_if("}")) {
    if (in_.take_if("texture")) {
      default_texture_ = texture_block(default_texture_);
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

// `ambient` stands for indirect light, which strad computes, so it is ignored. Only a surface that reflects
// nothing is taken to emit it.
PovSurfacePointer PovSceneReader::surface_of(const PovTexture& texture) {
  auto surface = std::make_shared<PovSurface>();
  const PovPigment& pigment = texture.pigment;
  const PovFinish& finish = texture.finish;
  surface->name = texture.name.empty() ? pigment.name : texture.name;
  surface->place = texture.place;
  surface->reflectance = static_cast<float>(finish.diffuse) * pigment.colour;
  surface->emission = pigment.colour * finish.emission;
  if (finish.diffuse == 0 && is_black(finish.emission)) surface->emission = pigment.colour * finish.ambient;
  surface->image = pigment.image;
  if (pigment.problem) surface->problems.push_back(*pigment.problem);
  if (finish.problem) surface->problems.push_back(*finish.problem);
  if (finish.note) surface->notes.push_back(*finish.note);
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
