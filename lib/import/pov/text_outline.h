// Texts as outlines of a font's glyphs.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace strad {

// The rings of each glyph of `text` (UTF-8), which begins at the origin; an em is 1. `advance` is added after
// each glyph. No curve is farther than `tolerance` from its chords. A letter that the font lacks is shown as
// the font shows such. Throws BadInput if `font` is no font.
std::vector<std::vector<std::vector<Vec2>>> text_outlines(const std::string& font, const std::string& text,
                                                          Vec2 advance, double tolerance);

}  // namespace strad
