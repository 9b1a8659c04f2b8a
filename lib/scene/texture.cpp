#include "scene/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rng.h"
#include "image/srgb.h"

namespace strad {
namespace {

const std::array<float, 256>& linear_of_byte() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int i = 0; i < 256; ++i) values[static_cast<size_t>(i)] = linear_from_byte(static_cast<uint8_t>(i));
    return values;
  }();
  return table;
}

Rgb texel(const Texture& texture, uint32_t column, uint32_t row) {
  const uint8_t* srgb = &texture.srgb[3 * (size_t{row} * texture.width + column)];
  const std::array<float, 256>& linear = linear_of_byte();
  return {linear[srgb[0]], linear[srgb[1]], linear[srgb[2]]};
}

// The two texels that a coordinate lies between, and the fraction of the way.
struct Between {
  uint32_t low, high;
  float part;
};
Between between(double coordinate, uint32_t count, bool clamp) {
  if (clamp) {
    const double inside = std::clamp(coordinate, 0.0, count - 1.0);
    const auto low = static_cast<uint32_t>(inside);
    return {low, std::min(low + 1, count - 1), static_cast<float>(inside - low)};
  }
  const double wrapped = coordinate - std::floor(coordinate / count) * count;
  const double below = std::floor(wrapped);
  const uint32_t low = static_cast<uint32_t>(below) % count;
  return {low, (low + 1) % count, static_cast<float>(wrapped - below)};
}

// Texture coordinates spread evenly over a polygon, about one per texel, within bounds.
std::vector<Vec2> spread_uvs(const Scene& scene, const Polygon& polygon, uint64_t texels_of_texture) {
  constexpr double kFewest = 16, kMost = 4096;
  double twice = 0;  // twice its area in texture coordinates
  const int corners = polygon.corner_count();
  for (int i = 0; i < corners; ++i) {
    const Vec2 a = scene.uvs[polygon.uvs[i]], b = scene.uvs[polygon.uvs[(i + 1) % corners]];
    twice += a.x * b.y - b.x * a.y;
  }
  const double texels = 0.5 * std::abs(twice) * static_cast<double>(texels_of_texture);
  const auto count =
      static_cast<uint32_t>(std::isfinite(texels) ? std::clamp(texels, kFewest, kMost) : kFewest);
  std::vector<Vec2> uvs;
  for (uint32_t i = 0; i < count; ++i) {
    Point2 p = r2_point(i, 0.5, 0.5);
    if (corners == 3 && p.u + p.v > 1) p = {1 - p.u, 1 - p.v};
    uvs.push_back(texture_uv(scene, polygon, {p.u, p.v}));
  }
  return uvs;
}

}  // namespace

Rgb texture_colour(const Texture& texture, Vec2 uv) {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y) || texture.width == 0 || texture.height == 0) return {};
  const Between x = between(uv.x * texture.width - 0.5, texture.width, texture.clamp);
  const Between y = between((1 - uv.y) * texture.height - 0.5, texture.height, texture.clamp);
  const Rgb upper = (1 - x.part) * texel(texture, x.low, y.low) + x.part * texel(texture, x.high, y.low);
  const Rgb lower = (1 - x.part) * texel(texture, x.low, y.high) + x.part * texel(texture, x.high, y.high);
  return (1 - y.part) * upper + y.part * lower;
}

bool is_hole(const Texture& texture, Vec2 uv) {
  const Opacity& opacity = texture.opacity;
  if (opacity.values.empty() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return false;
  const Between x = between(uv.x * opacity.width - 0.5, opacity.width, texture.clamp);
  const Between y = between((1 - uv.y) * opacity.height - 0.5, opacity.height, texture.clamp);
  const auto at = [&](uint32_t column, uint32_t row) {
    return static_cast<float>(opacity.values[size_t{row} * opacity.width + column]);
  };
  const float upper = (1 - x.part) * at(x.low, y.low) + x.part * at(x.high, y.low);
  const float lower = (1 - x.part) * at(x.low, y.high) + x.part * at(x.high, y.high);
  return (1 - y.part) * upper + y.part * lower < 127.5f;
}

bool may_have_holes(const Scene& scene, const Polygon& polygon) {
  return has_texture(scene, polygon) && !emits(scene, polygon) &&
         !scene.textures[scene.materials[polygon.material].texture].opacity.values.empty();
}

// Texels that lie in holes show nothing.
Rgb mean_colour(const Texture& texture) {
  double sum[3] = {0, 0, 0}, texels = 0;
  for (uint32_t row = 0; row < texture.height; ++row)
    for (uint32_t column = 0; column < texture.width; ++column) {
      const Vec2 uv{(column + 0.5) / texture.width, 1 - (row + 0.5) / texture.height};
      if (is_hole(texture, uv)) continue;
      const Rgb colour = texel(texture, column, row);
      for (int c = 0; c < 3; ++c) sum[c] += double{colour[c]};
      ++texels;
    }
  const auto mean = [&](int channel) { return static_cast<float>(sum[channel] / std::max(1.0, texels)); };
  return {mean(0), mean(1), mean(2)};
}

Rgb mean_colour(const Scene& scene, const Polygon& polygon, const Texture& texture) {
  Rgb sum;
  size_t shown = 0;
  for (const Vec2 uv : spread_uvs(scene, polygon, uint64_t{texture.width} * texture.height)) {
    if (is_hole(texture, uv)) continue;
    sum += texture_colour(texture, uv);
    ++shown;
  }
  return shown == 0 ? mean_colour(texture) : (1 / static_cast<float>(shown)) * sum;
}

double coverage_of(const Scene& scene, const Polygon& polygon) {
  if (!may_have_holes(scene, polygon)) return 1;
  const Texture& texture = scene.textures[scene.materials[polygon.material].texture];
  const std::vector<Vec2> uvs =
      spread_uvs(scene, polygon, uint64_t{texture.opacity.width} * texture.opacity.height);
  const auto shown = std::count_if(uvs.begin(), uvs.end(), [&](Vec2 uv) { return !is_hole(texture, uv); });
  return static_cast<double>(shown) / static_cast<double>(uvs.size());
}

Vec2 texture_uv(const Scene& scene, const Polygon& polygon, Vec2 at) {
  const auto uv = [&](int i) { return scene.uvs[polygon.uvs[i]]; };
  const double u = at.x, v = at.y;
  const bool quad = polygon.corner_count() == 4;
  const double w0 = quad ? (1 - u) * (1 - v) : 1 - u - v, w1 = quad ? u * (1 - v) : u;
  const double w2 = quad ? u * v : v, w3 = quad ? (1 - u) * v : 0;
  const Vec2 a = uv(0), b = uv(1), c = uv(2), d = quad ? uv(3) : Vec2{};
  return {w0 * a.x + w1 * b.x + w2 * c.x + w3 * d.x, w0 * a.y + w1 * b.y + w2 * c.y + w3 * d.y};
}

std::vector<Rgb> textured_reflectances(const Scene& scene) {
  std::vector<Rgb> reflectances;
  for (const Material& material : scene.materials) {
    Rgb reflectance = material.reflectance;
    if (material.texture != kNone) reflectance = reflectance * mean_colour(scene.textures[material.texture]);
    reflectances.push_back(reflectance);
  }
  return reflectances;
}

}  // namespace strad
