#include "import/pov/language/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

double linear_from_srgb_number(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// The numbers after rgb, rgbf, rgbt and so on, in the order red, green, blue, filter, transmit.
PovNumbers colour_from(std::string_view word, PovNumbers from) {
  const bool srgb = word.starts_with('s');
  if (srgb) word.remove_prefix(1);
  from = promoted(from, static_cast<int>(word.size()));
  if (word == "rgbt" && from.size >= 4) from[4] = from[3], from[3] = 0;
  if (word == "rgb") from[3] = from[4] = 0;
  for (int i = 0; i < 3 && srgb; ++i) from[i] = linear_from_srgb_number(from[i]);
  from.size = 5;
  return from;
}

}  // namespace

bool starts_colour(std::string_view word) {
  return is_one_of(word, {"color", "colour", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "srgbf", "srgbt",
                          "srgbft", "red", "green", "blue", "filter", "transmit"});
}

int colour_part(std::string_view word) {
  const std::array<std::string_view, kColourParts> parts{"red", "green", "blue", "filter", "transmit"};
  return static_cast<int>(std::find(parts.begin(), parts.end(), word) - parts.begin());
}

PovNumbers PovInterpreter::colour_numbers() {
  if (!take_if("color")) take_if("colour");
  PovNumbers colour;
  colour.size = 5;
  for (bool first = true;; first = false) {
    const PovToken& token = peek();
    const bool word = token.kind == PovKind::kWord && starts_colour(token.text);
    if (!word && !first) return colour;
    if (!word) {
      colour = colour_from("rgb", sum());
      continue;
    }
    const int part = colour_part(token.text);
    if (part == kColourParts && !first) return colour;  // another colour begins
    const std::string kind(take().text);
    if (part < kColourParts) {
      colour[part] = sum()[0];
    } else {
      colour = colour_from(kind, sum());
    }
  }
}

Rgb PovInterpreter::colour() {
  const PovPlace at = place();
  const PovNumbers found = promoted(numbers(), 3);
  if (found.size >= 4 && (found[3] != 0 || found[4] != 0))
    refuse({"transparency of a colour", at}, options_, report_);
  Rgb rgb;
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<float>(found[i]);
  if (!is_finite(rgb)) fail_at(at.file, at.line, "a colour is not finite");
  return rgb;
}

}  // namespace strad
