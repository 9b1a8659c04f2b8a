// Spotlights, glows and cameras with few keys, made of one key a frame.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace strad {

// How far a key that is left out may be from what the others say, as a part of the size of what it is about.
constexpr double kKeyTolerance = 1e-5;

// The bounds of all vertices.
Box box_of(const Scene& scene);

// Positions keep to the tolerance times `size`, in metres; directions and angles to it in radians;
// intensities and values to it times the largest.
std::vector<SpotKey> few_spot_keys(const std::vector<SpotKey>& all, double size);
std::vector<GlowKey> few_glow_keys(const std::vector<GlowKey>& all);
std::vector<CameraKey> few_camera_keys(const std::vector<CameraKey>& all, double size);

// Names the bodies after the objects that they have, and lists these as their parts. Bodies that have a name
// keep it. REQUIRES: names of objects are unique.
void name_bodies(Scene* scene);

}  // namespace strad
