// Glass: which polygons it is made of, and what goes straight through.
//
// Light that a surface receives goes straight on through glass, as through thin sheets, dimmed by what each
// surface that it crosses reflects and tints. So lamps light what is behind a pane; caustics are left out.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace strad {

// Of a polygon's glass: none; a sheet, which stands for a pane with both its sides; or the surface of a
// solid, with its front outwards or inwards.
enum class GlassKind : uint8_t { kNone, kSheet, kSolid, kInverted };

// [polygon]; empty if there is none. Polygons with holes and lamps are never glass. Glass is solid where the
// polygons of a material and an object that hang together enclose a space; corners at one place are one.
std::vector<GlassKind> glass_kinds(const Scene& scene);

// The reflectance of a boundary of dielectrics, unpolarised, in [0, 1] (Fresnel 1823); 1 where reflection is
// total. `cosine`, > 0: of the angle to the normal; `ior`: index of refraction behind over that before.
double fresnel_reflectance(double cosine, double ior);

// The share of light that a surface mirrors, at an angle of that cosine.
Rgb mirrored_share(const Finish& finish, double cosine, double ior);
// The same of a pane, whose two sides mirror light to and fro.
Rgb mirrored_by_pane(const Finish& finish, double cosine);

// The share of light that goes straight through a polygon, at an angle of that cosine.
Rgb straight_share(const Finish& finish, GlassKind kind, double cosine);

}  // namespace strad
