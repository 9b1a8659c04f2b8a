// Looks of POV-Ray's surfaces that become one colour: means over patterns, layers on top of each other.
#pragma once

#include <span>
#include <utility>

#include "import/pov/scene_values.h"

namespace strad {

// Means of what is opaque are this opaque, but for rounding.
constexpr double kOpaque = 1 - 1e-5;

// A colour red, green, blue, filter, transmit as a pigment.
PovPigment plain_pigment(const PovNumbers& colour);

// The weight of each entry of a map in the mean over a pattern whose values are spread evenly over 0..1.
// Between two entries the map is linear; before the first and after the last it is constant.
std::vector<double> weights_of(const PovMap& map);

// The mean of some textures, weighted. The reflectance and the emission are those of the mean, not the
// products of means. REQUIRES: at least one has a positive weight.
PovTexture mean_texture(std::span<const std::pair<double, PovTexture>> weighted);

// `top` laid over `bottom`, which shows where `top` lets light through.
PovTexture layered(const PovTexture& top, const PovTexture& bottom);

// What a texture reflects and emits. `ambient` stands for indirect light, which strad computes, so it is
// ignored: only a surface that reflects nothing is taken to emit it.
Rgb reflectance_of(const PovTexture& texture);  // diffuse, a mirror included
Rgb diffuse_of(const PovTexture& texture);      // without a mirror
Finish finish_of(const PovTexture& texture);    // mirror and glass
Rgb emission_of(const PovTexture& texture);

}  // namespace strad
