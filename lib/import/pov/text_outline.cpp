// The only user of FreeType.
#include "import/pov/text_outline.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <memory>

#include "base/error.h"
#include "base/text.h"

namespace strad {
namespace {

struct Pen {
  std::vector<std::vector<Vec2>> rings;
  double unit = 1, tolerance = 0;
  Vec2 origin;

  Vec2 at(const FT_Vector* v) const {
    return {origin.x + unit * static_cast<double>(v->x), origin.y + unit * static_cast<double>(v->y)};
  }
  // Points on the Bezier curve from the last point; b == c for a quadratic one, raised to a cubic by its
  // caller.
  void curve(Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 a = rings.back().back();
    // A chord over a parameter step h is off by at most h^2 / 8 times the largest second derivative.
    const double bend = 6 * std::max(std::hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y),
                                     std::hypot(b.x - 2 * c.x + d.x, b.y - 2 * c.y + d.y));
    const int steps = std::max(1, static_cast<int>(std::ceil(std::sqrt(bend / (8 * tolerance)))));
    for (int k = 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps, u = 1 - t;
      const double wa = u * u * u, wb = 3 * t * u * u, wc = 3 * t * t * u, wd = t * t * t;
      rings.back().push_back(
          {wa * a.x + wb * b.x + wc * c.x + wd * d.x, wa * a.y + wb * b.y + wc * c.y + wd * d.y});
    }
  }
};

Pen* pen_of(void* user) { return static_cast<Pen*>(user); }

int move_to(const FT_Vector* to, void* user) {
  pen_of(user)->rings.push_back({pen_of(user)->at(to)});
  return 0;
}
int line_to(const FT_Vector* to, void* user) {
  pen_of(user)->rings.back().push_back(pen_of(user)->at(to));
  return 0;
}
int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  Pen* pen = pen_of(user);
  const Vec2 a = pen->rings.back().back(), q = pen->at(control), d = pen->at(to);
  pen->curve({a.x + (q.x - a.x) * 2 / 3, a.y + (q.y - a.y) * 2 / 3},
             {d.x + (q.x - d.x) * 2 / 3, d.y + (q.y - d.y) * 2 / 3}, d);
  return 0;
}
int cubic_to(const FT_Vector* b, const FT_Vector* c, const FT_Vector* to, void* user) {
  Pen* pen = pen_of(user);
  pen->curve(pen->at(b), pen->at(c), pen->at(to));
  return 0;
}

// The next character of a UTF-8 text; a byte that is none of it stands for itself (Latin-1).
FT_ULong next_character(const std::string& text, size_t* at) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte((*at)++);
  const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  FT_ULong character = more == 3 ? first & 7 : more == 2 ? first & 15 : more == 1 ? first & 31 : first;
  for (int k = 0; k < more; ++k) {
    if ((byte(*at + static_cast<size_t>(k)) & 0xc0) != 0x80) return first;
    character = character << 6 | (byte(*at + static_cast<size_t>(k)) & 0x3f);
  }
  *at += static_cast<size_t>(more);
  return character;
}

void tidy(std::vector<std::vector<Vec2>>* rings) {
  for (auto& ring : *rings)
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  std::erase_if(*rings, [](const auto& ring) { return ring.size() < 3; });
}

}  // namespace

std::vector<std::vector<std::vector<Vec2>>> text_outlines(const std::string& font, const std::string& text,
                                                          Vec2 advance, double tolerance) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library)) throw BadInput("FreeType cannot be started");
  const std::unique_ptr<FT_LibraryRec_, FT_Error (*)(FT_Library)> closer(library, FT_Done_FreeType);
  FT_Face face = nullptr;
  if (FT_New_Face(library, font.c_str(), 0, &face) || !FT_IS_SCALABLE(face))
    throw BadInput(in_quotes(font, font.size()) + " is not a font of outlines");
  std::vector<std::vector<std::vector<Vec2>>> glyphs;
  const FT_Outline_Funcs functions{move_to, line_to, conic_to, cubic_to, 0, 0};
  Pen pen;
  pen.unit = 1.0 / face->units_per_EM;
  pen.tolerance = tolerance;
  FT_UInt before = 0;
  for (size_t at = 0; at < text.size();) {
    const FT_UInt index = FT_Get_Char_Index(face, next_character(text, &at));
    FT_Vector kerning{0, 0};
    if (before) FT_Get_Kerning(face, before, index, FT_KERNING_UNSCALED, &kerning);
    pen.origin.x += pen.unit * static_cast<double>(kerning.x);
    before = index;
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE)) continue;
    pen.rings.clear();
    if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE)
      FT_Outline_Decompose(&face->glyph->outline, &functions, &pen);
    tidy(&pen.rings);
    if (!pen.rings.empty()) glyphs.push_back(pen.rings);
    pen.origin.x += pen.unit * static_cast<double>(face->glyph->advance.x) + advance.x;
    pen.origin.y += advance.y;
  }
  FT_Done_Face(face);
  return glyphs;
}

}  // namespace strad
