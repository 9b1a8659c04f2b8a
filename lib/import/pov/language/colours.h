// The words of POV-Ray's colours.
#pragma once

#include <string_view>

#include "import/pov/language/values.h"

namespace strad {

bool starts_colour(std::string_view word);

constexpr int kColourParts = 5;
// The part of a colour that a word names: 0 red, 1 green, 2 blue, 3 filter, 4 transmit; kColourParts if it
// names none.
int colour_part(std::string_view word);

}  // namespace strad
