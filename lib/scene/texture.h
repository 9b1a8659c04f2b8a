// Colours of textures at points, and mean colours.
#pragma once

#include "base/rgb.h"
#include "scene/scene.h"

namespace strad {

// Linear colour at texture coordinates `uv`, bilinear between texel centres, repeated beyond [0, 1).
// (0, 0) is the lower left corner, as in OBJ files.
Rgb texture_colour(const Texture& texture, Vec2 uv);

// Texture coordinates at the parametric position `at` of a polygon (see parametric_of).
// REQUIRES: the polygon has them.
Vec2 texture_uv(const Scene& scene, const Polygon& polygon, Vec2 at);

// Is there a hole at texture coordinates `uv`? By the opacity there, bilinear, so that its edge is a smooth
// line.
bool is_hole(const Texture& texture, Vec2 uv);

// May the polygon have holes? Lamps have none.
bool may_have_holes(const Scene& scene, const Polygon& polygon);

// The share of a polygon that is not holes; 1 where it has no texture coordinates.
double coverage_of(const Scene& scene, const Polygon& polygon);

// Mean over the texture, and over the part of it that a polygon shows, without holes. REQUIRES: the polygon
// has coordinates.
Rgb mean_colour(const Texture& texture);
Rgb mean_colour(const Scene& scene, const Polygon& polygon, const Texture& texture);

// Of all materials: their reflectance with the mean of their texture multiplied in.
std::vector<Rgb> textured_reflectances(const Scene& scene);

inline bool has_texture(const Scene& scene, const Polygon& polygon) {
  return scene.materials[polygon.material].texture != kNone && polygon.uvs[0] != kNone;
}

}  // namespace strad
