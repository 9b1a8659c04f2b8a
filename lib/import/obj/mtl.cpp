// Materials of MTL files.
#include "import/obj/mtl.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/text.h"
#include "import/obj/parse.h"

namespace strad {
namespace {

// An option of a texture statement. `words`: how many words follow it; -1: one to three numbers.
struct TextureOption {
  std::string_view name;
  int words;
};
constexpr std::array<TextureOption, 14> kTextureOptions{{{"-blendu", 1},
                                                         {"-blendv", 1},
                                                         {"-boost", 1},
                                                         {"-bm", 1},
                                                         {"-cc", 1},
                                                         {"-clamp", 1},
                                                         {"-colorspace", 1},
                                                         {"-imfchan", 1},
                                                         {"-mm", 2},
                                                         {"-texres", 1},
                                                         {"-type", 1},
                                                         {"-o", -1},
                                                         {"-s", -1},
                                                         {"-t", -1}}};

class MtlScanner {
 public:
  MtlScanner(std::string_view text, const std::string& name) : lines_(text), name_(name) {}
  std::vector<MtlMaterial> run();

 private:
  void statement(std::string_view word, std::string_view rest);
  void property(std::string_view word, std::string_view rest);
  std::array<float, 3> colour(std::string_view word, std::string_view rest) const;
  float number(std::string_view word, std::string_view rest) const;
  void put_colour(std::string_view word, std::string_view rest);
  MtlPicture picture(std::string_view word, std::string_view rest);
  void picture_option(std::string_view word, std::string_view option,
                      const std::vector<std::string_view>& words, MtlPicture* picture);
  bool of_finish(std::string_view word, std::string_view rest);
  void without_effect(std::string_view word, std::string_view rest);
  void ignore_if_plain(const std::string& what) {
    materials_.back().of_finish.push_back({what, lines_.number()});
  }
  void ignore(const std::string& what) { materials_.back().ignored.push_back({what, lines_.number()}); }

  LineReader lines_;
  const std::string& name_;
  std::string clean_;
  std::vector<MtlMaterial> materials_;
};

float MtlScanner::number(std::string_view word, std::string_view rest) const {
  const std::string_view text = next_word(&rest);
  const auto value = number_in(text);
  if (!value)
    fail_at(name_, lines_.number(),
            std::string(word) + ": found " + in_quotes(text) + ", expected a finite number");
  return static_cast<float>(*value);
}

// One number alone gives all three channels.
std::array<float, 3> MtlScanner::colour(std::string_view word, std::string_view rest) const {
  std::array<float, 3> rgb{};
  size_t count = 0;
  for (std::string_view text = next_word(&rest); !text.empty() && !text.starts_with('#');
       text = next_word(&rest)) {
    if (count == 0 && (text == "spectral" || text == "xyz"))
      fail_at(name_, lines_.number(),
              std::string(word) + " " + std::string(text) + " is not supported, expected R G B");
    const float value = number(word, text);
    if (!(value >= 0))
      fail_at(name_, lines_.number(), std::string(word) + " " + std::string(text) + " is negative");
    if (count < 3) rgb[count] = value;
    ++count;
  }
  if (count == 1) return {rgb[0], rgb[0], rgb[0]};
  if (count != 3)
    fail_at(name_, lines_.number(),
            std::string(word) + " has " + std::to_string(count) + " numbers, expected R G B");
  return rgb;
}

void MtlScanner::put_colour(std::string_view word, std::string_view rest) {
  clean_.append(word);
  for (const float channel : colour(word, rest)) {
    std::array<char, 32> digits;
    const auto end = std::snprintf(digits.data(), digits.size(), " %.9g", static_cast<double>(channel));
    clean_.append(digits.data(), static_cast<size_t>(end));
  }
  clean_.append("\n");
}

void MtlScanner::picture_option(std::string_view word, std::string_view option,
                                const std::vector<std::string_view>& words, MtlPicture* picture) {
  if (option == "-clamp" && !words.empty() && is_one_of(words[0], {"on", "off"})) {
    picture->clamp = words[0] == "on";
  } else if ((option == "-s" || option == "-o") && !words.empty()) {
    Vec2& pair = option == "-s" ? picture->scale : picture->offset;
    pair.x = *number_in(words[0]);
    if (words.size() > 1) pair.y = *number_in(words[1]);
  } else {
    ignore(std::string(word) + " option " + std::string(option) + " is ignored");
  }
}

// map_Kd [options] name. The name is all that follows the options; it may hold blanks.
MtlPicture MtlScanner::picture(std::string_view statement, std::string_view rest) {
  rest = trimmed(rest);
  MtlPicture picture;
  while (rest.starts_with('-')) {
    std::string_view after = rest;
    const std::string_view word = next_word(&after);
    const auto option = std::find_if(kTextureOptions.begin(), kTextureOptions.end(),
                                     [&](const TextureOption& known) { return known.name == word; });
    if (option == kTextureOptions.end()) break;
    const int most = option->words < 0 ? 3 : option->words;
    std::vector<std::string_view> words;
    for (int i = 0; i < most; ++i) {
      std::string_view behind = after;
      if (option->words < 0 && !number_in(next_word(&behind))) break;
      words.push_back(next_word(&after));
    }
    picture_option(statement, word, words, &picture);
    rest = trimmed(after);
  }
  if (rest.empty()) fail_at(name_, lines_.number(), std::string(statement) + " names no file");
  picture.file = rest;
  picture.line = lines_.number();
  return picture;
}

// Statements that change nothing here are named, unless their value says that there is nothing to change.
void MtlScanner::without_effect(std::string_view word, std::string_view rest) {
  std::string_view words = rest;
  const std::optional<double> value = number_in(next_word(&words));
  const bool nothing = value && *value == 0 &&
                       is_one_of(word, {"Pr", "Pm", "Ps", "Pc", "Pcr", "aniso", "anisor", "sharpness"});
  if (!nothing) ignore(std::string(word) + " is ignored");
}

// Statements that say what a mirror or glass is like. Exporters write them of diffuse surfaces too, so illum
// decides whether they count.
bool MtlScanner::of_finish(std::string_view word, std::string_view rest) {
  MtlMaterial& material = materials_.back();
  const auto rgb = [&] {
    const auto c = colour(word, rest);
    return Rgb{c[0], c[1], c[2]};
  };
  if (word == "Ks") {
    material.specular = rgb();
    if (!is_black(*material.specular)) ignore_if_plain("Ks is ignored: surfaces are diffuse");
  } else if (word == "Tf") {
    material.filter = rgb();
    ignore_if_plain("Tf is ignored");
  } else if (word == "d" || word == "Tr") {
    if (word == "d" && rest.find("-halo") != rest.npos) {
      ignore("d is ignored: surfaces are opaque");
      return true;
    }
    const float value = number(word, rest);
    material.dissolve = word == "d" ? value : 1 - value;
    if (word == "d" ? value < 1 : value > 0)
      ignore_if_plain(std::string(word) + " is ignored: surfaces are opaque");
  } else if (word == "Ns" || word == "Ni") {
    const std::optional<double> value = number_in(next_word(&rest));
    if (value) (word == "Ns" ? material.exponent : material.ior) = static_cast<float>(*value);
    if (!value || *value != (word == "Ns" ? 0 : 1)) ignore_if_plain(std::string(word) + " is ignored");
  } else if (word == "illum") {
    const std::optional<double> value = number_in(next_word(&rest));
    material.illum = value && *value >= 0 && *value <= 10 ? static_cast<int>(*value) : 0;
    if (!value || !(*value >= 1 && *value <= 2)) ignore_if_plain("illum is ignored");
  } else {
    return false;
  }
  return true;
}

void MtlScanner::property(std::string_view word, std::string_view rest) {
  if (of_finish(word, rest)) return;
  const auto is_above_0 = [&] {
    const auto rgb = colour(word, rest);
    return *std::max_element(rgb.begin(), rgb.end()) > 0;
  };
  if (word == "Kd" || word == "Ke") {
    put_colour(word, rest);
    if (word == "Kd") materials_.back().reflectance_line = lines_.number();
  } else if (word == "map_Kd") {
    materials_.back().texture = picture(word, rest);
  } else if (word == "map_d") {
    materials_.back().opacity = picture(word, rest);
  } else if (word == "map_Ke") {
    ignore("map_Ke is ignored: a material emits evenly");
  } else if (word == "Ka") {
    if (is_above_0()) ignore("Ka is ignored: all light is computed");
  } else {
    without_effect(word, rest);
  }
}

void MtlScanner::statement(std::string_view word, std::string_view rest) {
  if (word != "newmtl") {
    if (materials_.empty())
      fail_at(name_, lines_.number(), "found " + in_quotes(word) + ", expected newmtl before all else");
    return property(word, rest);
  }
  const std::string name = single_spaced(rest);
  if (name.empty()) fail_at(name_, lines_.number(), "newmtl has no name");
  clean_ += "newmtl " + std::to_string(materials_.size()) + "\n";
  MtlMaterial& material = materials_.emplace_back();
  material.name = name;
  material.file = name_;
  material.line = lines_.number();
}

std::vector<MtlMaterial> MtlScanner::run() {
  while (lines_.next()) {
    std::string_view rest = lines_.line();
    const std::string_view word = next_word(&rest);
    if (!word.empty() && !word.starts_with('#')) statement(word, rest);
  }
  const std::vector<ParsedMaterial> parsed = parse_clean_mtl(clean_, materials_.size());
  for (size_t i = 0; i < materials_.size(); ++i) {
    materials_[i].reflectance = parsed[i].reflectance;
    materials_[i].emission = parsed[i].emission;
  }
  return std::move(materials_);
}

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::string& path) {
  const std::string text = read_text(path), name = text_name(path);
  return MtlScanner(text, name).run();
}

}  // namespace strad
