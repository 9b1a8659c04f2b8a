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

}  // namespace

Rgb texture_colour(const Texture& texture, Vec2 uv) {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y) || texture.width == 0 || texture.height == 0) return {};
  const Between x = between(uv.x * texture.width - 0.5, texture.width, texture.clamp);
  const Between y = between((1 - uv.y) * texture.height - 0.5, texture.height, texture.clamp);
  const Rgb upper = (1 - x.part) * texel(texture, x.low, y.low) + x.part * texel(texture, x.high, y.low);
  const Rgb lower = (1 - x.part) * texel(texture, x.low, y.high) + x.part * texel(texture, x.high, y.high);
  return (1 - y.part) * upper + y.part * lower;
}

Rgb mean_colour(const Texture& texture) {
  double sum[3] = {0, 0, 0};
  for (size_t i = 0; i < texture.srgb.size(); ++i) sum[i % 3] += linear_of_byte()[texture.srgb[i]];
  const double texels = std::max(1.0, static_cast<double>(texture.srgb.size() / 3));
  const auto mean = [&](int channel) { return static_cast<float>(sum[channel] / texels); };
  return {mean(0), mean(1), mean(2)};
}

Rgb mean_colour(const Scene& scene, const Polygon& polygon, const Texture& texture) {
  // About one sample per texel, within bounds.
  constexpr double kFewest = 16, kMost = 4096;
  double twice = 0;  // twice its area in texture coordinates
  const int corners = polygon.corner_count();
  for (int i = 0; i < corners; ++i) {
    const Vec2 a = scene.uvs[polygon.uvs[i]], b = scene.uvs[polygon.uvs[(i + 1) % corners]];
    twice += a.x * b.y - b.x * a.y;
  }
  const double texels = 0.5 * std::abs(twice) * texture.width * texture.height;
  const auto count =
      static_cast<uint32_t>(std::isfinite(texels) ? std::clamp(texels, kFewest, kMost) : kFewest);
  Rgb sum;
  for (uint32_t i = 0; i < count; ++i) {
    Point2 p = r2_point(i, 0.5, 0.5);
    if (corners == 3 && p.u + p.v > 1) p = {1 - p.u, 1 - p.v};
    sum += texture_colour(texture, texture_uv(scene, polygon, {p.u, p.v}));
  }
  return (1 / static_cast<float>(count)) * sum;
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
