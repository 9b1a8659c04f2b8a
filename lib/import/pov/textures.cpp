// POV-Ray's textures: plain colours and pictures, diffuse reflection and emission.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/scene.h"

namespace strad {
namespace {

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Rgb rgb_of(const PovNumbers& numbers) {
  Rgb rgb;
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<float>(numbers[numbers.size == 1 ? 0 : i]);
  return rgb;
}

}  // namespace

void PovSceneReader::skip_item() {
  take();
  while (true) {
    const PovToken& token = peek();
    if (next_is("{")) return skip_block();
    if (next_is("}") || token.kind == PovKind::kEnd) return;
    if (token.kind == PovKind::kWord && !expression_is_next()) return;
    take();
  }
}

PovTexture PovSceneReader::texture_block(const PovTexture& base) {
  PovTexture texture = base;
  texture.name.clear();
  texture.place = place();
  expect("{");
  if (std::string name; auto known = named<PovTexture>(&name)) {
    texture = *known;
    texture.name = name;
  }
  while (!take_if("}")) {
    PovTransform ignored;
    if (take_if("pigment")) {
      texture.pigment = pigment_block(base.pigment);
    } else if (take_if("finish")) {
      texture.finish = finish_block(base.finish);
    } else if (take_if("uv_mapping") || transformation(&ignored)) {
      continue;
    } else if (next_is("normal")) {
      skip_item();
    } else if (peek().kind == PovKind::kWord) {
      texture.pigment.problem = PovProblem{"texture " + std::string(peek().text), place()};
      skip_item();
    } else {
      fail_expected("pigment, finish or }");
    }
  }
  return texture;
}

PovTexture PovSceneReader::material_block(const PovTexture& base) {
  PovTexture texture = base;
  expect("{");
  if (const auto known = named<PovTexture>()) texture = *known;
  while (!take_if("}")) {
    PovTransform ignored;
    if (take_if("texture")) {
      texture = texture_block(base);
    } else if (!transformation(&ignored)) {
      if (peek().kind != PovKind::kWord) fail_expected("texture or }");
      skip_item();
    }
  }
  return texture;
}

PovPigment PovSceneReader::pigment_block(const PovPigment& base) {
  PovPigment pigment = base;
  pigment.name.clear();
  expect("{");
  if (std::string name; auto known = named<PovPigment>(&name)) {
    pigment = *known;
    pigment.name = name;
  }
  while (!take_if("}")) {
    PovTransform ignored;
    if (take_if("uv_mapping") || transformation(&ignored)) continue;
    if (expression_is_next()) {
      const PovPlace at = place();
      const PovNumbers plain = numbers();
      pigment = {pigment.name, rgb_of(plain), nullptr, {}};
      if (plain.size >= 4 && (plain[3] != 0 || plain[4] != 0))
        pigment.problem = PovProblem{"transparency of a pigment", at};
    } else if (take_if("image_map")) {
      pigment.image = image_block();
      pigment.colour = {1, 1, 1};
    } else if (take_if("quick_color") || take_if("quick_colour")) {
      colour();
    } else if (peek().kind == PovKind::kWord) {
      if (!pigment.problem) pigment.problem = PovProblem{"pigment " + std::string(peek().text), place()};
      pigment.colour = {0.5f, 0.5f, 0.5f};  // if it is skipped
      skip_item();
    } else {
      fail_expected("a colour or }");
    }
  }
  return pigment;
}

// image_map { [type] "file" [gamma G] [interpolate I] }
std::shared_ptr<const PovImage> PovSceneReader::image_block() {
  auto image = std::make_shared<PovImage>();
  image->place = place();
  expect("{");
  while (!take_if("}")) {
    if (take_if("gamma")) {
      image->linear = !take_if("srgb") && number() == 1;
    } else if (peek().kind == PovKind::kString || next_is("concat")) {
      image->name = string();
    } else if (const auto known = named<std::string>()) {
      image->name = *known;
    } else if (!take_if(",") && peek().kind == PovKind::kWord) {
      take();  // the type, or interpolate
      if (expression_is_next()) numbers();
    } else if (peek().kind != PovKind::kNumber) {
      fail_expected("a file name in quotes");
    } else {
      take();
    }
  }
  if (image->name.empty()) fail_at(image->place.file, image->place.line, "image_map names no file");
  image->path = path_beside(image->place.file, image->name);
  return image;
}

PovFinish PovSceneReader::finish_block(const PovFinish& base) {
  PovFinish finish = base;
  expect("{");
  if (const auto known = named<PovFinish>()) finish = *known;
  while (!take_if("}")) {
    const PovPlace at = place();
    if (peek().kind != PovKind::kWord) fail_expected("ambient, diffuse, emission or }");
    const std::string word(peek().text);
    if (take_if("ambient")) {
      finish.ambient = colour();
    } else if (take_if("emission")) {
      finish.emission = colour();
    } else if (take_if("diffuse")) {
      take_if("albedo");
      finish.diffuse = number();
      if (take_if(",")) number();  // of light from behind
    } else if (take_if("reflection")) {
      if (next_is("{")) {
        skip_block();
        finish.problem = PovProblem{"mirror reflection", at};
      } else if (max_channel(colour()) > 0) {
        finish.problem = PovProblem{"mirror reflection", at};
      }
    } else if (is_one_of(word, {"phong", "specular", "irid", "subsurface", "metallic", "brilliance"})) {
      finish.note = PovProblem{word + " is ignored: surfaces are diffuse", at};
      skip_item();
    } else if (is_one_of(word,
                         {"phong_size", "roughness", "crand", "conserve_energy", "use_alpha", "fresnel"})) {
      skip_item();
    } else {
      finish.problem = PovProblem{"finish " + word, at};
      skip_item();
    }
  }
  return finish;
}

void PovSceneReader::default_block() {
  expect("{");
  while (!take_if("}")) {
    if (take_if("texture")) {
      default_texture_ = texture_block(default_texture_);
    } else if (take_if("pigment")) {
      default_texture_.pigment = pigment_block(default_texture_.pigment);
    } else if (take_if("finish")) {
      default_texture_.finish = finish_block(default_texture_.finish);
    } else {
      if (peek().kind != PovKind::kWord) fail_expected("texture, pigment, finish or }");
      skip_item();
    }
  }
}

// Ambient light is an estimate of what is computed here. Only where nothing is reflected does it mean a lamp.
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

// Of the three corners of a triangle.
PovSurfacePointer PovSceneReader::mean_of(const PovSurfacePointer& a, const PovSurfacePointer& b,
                                          const PovSurfacePointer& c) {
  if (a == b && b == c) return a;
  auto mean = std::make_shared<PovSurface>(*a);
  const float third = 1.0f / 3;
  mean->reflectance = third * (a->reflectance + b->reflectance + c->reflectance);
  mean->emission = third * (a->emission + b->emission + c->emission);
  // One third three times is not always one: what is the same in all corners stays as it is.
  if (a->reflectance == b->reflectance && b->reflectance == c->reflectance)
    mean->reflectance = a->reflectance;
  for (const PovSurfacePointer& other : {b, c})
    mean->problems.insert(mean->problems.end(), other->problems.begin(), other->problems.end());
  return mean;
}

}  // namespace strad
