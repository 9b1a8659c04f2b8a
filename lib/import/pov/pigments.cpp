// POV-Ray's pigments and patterns: plain colours, pictures, and the mean colours of patterns.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/looks.h"
#include "import/pov/scene_reader.h"

namespace strad {
namespace {

// How many colours, pigments or textures follow the name of a pattern; 0 for other words.
size_t list_length(std::string_view word) {
  if (is_one_of(word, {"checker", "brick"})) return 2;
  if (word == "hexagon") return 3;
  if (word == "square") return 4;
  return is_one_of(word, {"cubic", "triangular"}) ? 6 : 0;
}

// Patterns whose values a map turns into colours.
bool is_pattern(std::string_view word) {
  return is_one_of(word, {"agate",           "aoi",           "average",   "boxed",    "bozo",
                          "bumps",           "cells",         "crackle",   "dents",    "cylindrical",
                          "density_file",    "facets",        "fractal",   "function", "gradient",
                          "granite",         "image_pattern", "julia",     "leopard",  "magnet",
                          "mandel",          "marble",        "object",    "onion",    "pavement",
                          "pigment_pattern", "planar",        "potential", "quilted",  "radial",
                          "ripples",         "slope",         "spherical", "spiral1",  "spiral2",
                          "spotted",         "tiling",        "waves",     "wood",     "wrinkles"});
}

// Words that change where a pattern has which value, but hardly the mean over it.
bool is_pattern_modifier(std::string_view word) {
  return is_one_of(word,
                   {"accuracy",     "agate_turb", "control0", "control1", "coords",        "cubic_wave",
                    "df3",          "exponent",   "exterior", "form",     "frequency",     "interior",
                    "interpolate",  "lambda",     "map_type", "metric",   "no_bump_scale", "noise_generator",
                    "octaves",      "offset",     "omega",    "phase",    "poly_wave",     "ramp_wave",
                    "scallop_wave", "sine_wave",  "size",     "solid",    "triangle_wave", "turbulence",
                    "warp"});
}

}  // namespace

// [value colour], [value, value colour colour], or [value pigment-or-texture].
void PovSceneReader::map_entry(PovMap* map, bool of_pigments, bool of_textures) {
  const double value = in_.expression_is_next() ? in_.number() : 1;  // weights of an average may be missing
  in_.skip_comma();
  PovTexture entry = default_texture_;
  if (of_textures) {
    texture_items(&entry, default_texture_, "]");
  } else if (of_pigments) {
    pigment_items(&entry.pigment, "]");
  } else {
    PovNumbers first = in_.numbers();
    in_.skip_comma();
    if (first.size == 1 && in_.expression_is_next()) {  // an old form: a range of values
      const double end = first[0];
      entry.pigment = plain_pigment(in_.numbers());
      map->entries.push_back({value, entry});
      in_.skip_comma();
      entry.pigment = plain_pigment(in_.numbers());
      map->entries.push_back({end, entry});
      return in_.expect("]");
    }
    entry.pigment = plain_pigment(first);
    in_.expect("]");
  }
  map->entries.push_back({value, std::move(entry)});
}

// Reads from the word color_map, pigment_map or texture_map.
PovMap PovSceneReader::map_block() {
  const std::string word(in_.take().text);
  PovMap map;
  in_.expect("{");
  if (const auto known = in_.named<PovMap>()) map = *known;
  while (!in_.take_if("}")) {
    in_.expect("[");
    map_entry(&map, word == "pigment_map", word == "texture_map");
  }
  if (map.entries.empty()) in_.fail("the " + word + " has no entries");
  return map;
}

// The colours, pigments or textures after the name of a pattern.
void PovSceneReader::pattern_list(PovPattern* pattern, size_t count) {
  while (pattern->list.size() < count) {
    PovTexture entry = default_texture_;
    if (in_.take_if("pigment")) {
      entry.pigment = pigment_block(default_texture_.pigment);
    } else if (in_.take_if("texture")) {
      entry = texture_block(default_texture_);
    } else if (in_.expression_is_next()) {
      entry.pigment = plain_pigment(in_.numbers());
    } else {
      return;
    }
    pattern->list.push_back({1, std::move(entry)});
    in_.skip_comma();
  }
}

// Takes a word of a pattern with what belongs to it, if one is next.
bool PovSceneReader::pattern_item(PovPattern* pattern) {
  if (in_.peek().kind != PovKind::kWord) return false;
  const std::string word(in_.peek().text);
  const PovPlace at = in_.place();
  if (is_one_of(word, {"color_map", "colour_map", "pigment_map", "texture_map"})) {
    pattern->map = map_block();
    if (pattern->word.empty()) pattern->word = word, pattern->place = at;
  } else if (const size_t count = list_length(word)) {
    in_.take();
    pattern->word = word;
    pattern->place = at;
    pattern->list.clear();
    pattern_list(pattern, count);
  } else if (in_.take_if("tiles")) {  // { texture A tile2 texture B }
    in_.expect("{");
    pattern->word = word;
    pattern->place = at;
    pattern_list(pattern, 1);
    if (!in_.take_if("tile2")) in_.fail_expected("tile2");
    pattern_list(pattern, 2);
    in_.expect("}");
  } else if (word == "brick_size") {
    in_.take();
    pattern->brick = in_.vector();
  } else if (word == "mortar") {
    in_.take();
    pattern->mortar = in_.number();
  } else if (is_pattern(word)) {
    pattern->word = word;
    pattern->place = at;
    in_.skip_item();
  } else if (is_pattern_modifier(word)) {
    in_.skip_item();
  } else {
    return false;
  }
  return true;
}

// What a pattern is in the mean. Nothing if there is none.
std::optional<PovTexture> PovSceneReader::mean_of_pattern(PovPattern pattern, const std::string& of) {
  if (pattern.word.empty()) return {};
  std::vector<std::pair<double, PovTexture>> weighted = std::move(pattern.list);
  if (pattern.word == "brick" && weighted.size() == 2) {  // mortar, then brick: shares of a wall's area
    const Vec3 size = pattern.brick;
    const double brick =
        std::max(0.0, 1 - pattern.mortar / size.x) * std::max(0.0, 1 - pattern.mortar / size.y);
    weighted[0].first = 1 - std::min(1.0, brick);
    weighted[1].first = std::min(1.0, brick);
  }
  if (weighted.empty()) {
    const bool average = pattern.word == "average";  // its numbers are weights
    const std::vector<double> weights = weights_of(pattern.map);
    for (size_t i = 0; i < weights.size(); ++i) {
      const auto& [value, texture] = pattern.map.entries[i];
      weighted.push_back({average ? std::max(0.0, value) : weights[i], texture});
    }
  }
  std::string what = of + " " + pattern.word + " is taken as its mean colour";
  double total = 0;
  for (const auto& [weight, texture] : weighted) total += weight;
  if (!(total > 0)) {
    PovTexture grey = default_texture_;
    grey.pigment = {};
    grey.pigment.colour = {0.5f, 0.5f, 0.5f};
    weighted = {{1, grey}};
    what = of + " " + pattern.word + " without colours is taken as grey";
  }
  PovTexture mean = mean_texture(weighted);
  mean.pigment.note = PovProblem{what, pattern.place};
  return mean;
}

PovPigment PovSceneReader::pigment_block(const PovPigment& base) {
  const PovInterpreter::Deeper deeper(&in_);
  PovPigment pigment = base;
  pigment.name.clear();
  in_.expect("{");
  pigment_items(&pigment, "}");
  return pigment;
}

// Up to and including the token `end`.
void PovSceneReader::pigment_items(PovPigment* pigment, std::string_view end) {
  if (std::string name; auto known = in_.named<PovPigment>(&name)) {
    *pigment = *known;
    pigment->name = name;
  }
  PovPattern pattern;
  while (!in_.take_if(end)) {
    PovTransform ignored;
    if (in_.take_if(",") || in_.take_if("uv_mapping") || transformation(&ignored)) continue;
    if (in_.expression_is_next()) {
      const std::string name = pigment->name;
      *pigment = plain_pigment(in_.numbers());
      pigment->name = name;
    } else if (in_.take_if("image_map")) {
      pigment->image = image_block();
      pigment->colour = {1, 1, 1};
    } else if (in_.take_if("quick_color") || in_.take_if("quick_colour")) {
      in_.numbers();
    } else if (pattern_item(&pattern)) {
      continue;
    } else if (in_.peek().kind == PovKind::kWord) {
      if (!pigment->problem)
        pigment->problem = PovProblem{"pigment " + std::string(in_.peek().text), in_.place()};
      pigment->colour = {0.5f, 0.5f, 0.5f};  // used only if the problem is skipped
      in_.skip_item();
    } else {
      in_.fail_expected("a colour or " + std::string(end));
    }
  }
  if (auto mean = mean_of_pattern(std::move(pattern), "pigment")) {
    mean->pigment.name = pigment->name;
    *pigment = mean->pigment;
  }
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
      if (in_.next_is("filter") || in_.next_is("transmit"))
        report_->add("filter and transmit of image_map are ignored: holes are where its alpha says so",
                     image->place.file, image->place.line);
      in_.take();  // the type, or interpolate
      if (in_.next_is("{")) in_.skip_block();
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

}  // namespace strad
