#include "solve/prepare/mean_reflectance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "scene/texture.h"

namespace strad {
namespace {

// The square root of a mean is rounded to steps, at most 1 % of a middle grey. So a large picture on many
// polygons gives no more than some thousands of materials.
constexpr float kSteps = 128;

int step_of(float mean) { return static_cast<int>(std::lround(kSteps * std::sqrt(mean))); }
float mean_of(int step) { return static_cast<float>(step * step) / (kSteps * kSteps); }

}  // namespace

Scene with_mean_reflectances(Scene scene) {
  std::map<std::tuple<uint32_t, int, int, int>, uint32_t> material_of;
  const size_t count = scene.materials.size();
  for (Polygon& polygon : scene.polygons) {
    const Material& material = scene.materials[polygon.material];
    if (!has_texture(scene, polygon) || !is_black(material.emission)) continue;
    const Rgb mean = mean_colour(scene, polygon, scene.textures[material.texture]);
    const int r = step_of(mean.r), g = step_of(mean.g), b = step_of(mean.b);
    const auto [it, is_new] =
        material_of.try_emplace({polygon.material, r, g, b}, static_cast<uint32_t>(scene.materials.size()));
    if (is_new) {
      Material part = material;
      part.reflectance = part.reflectance * Rgb{mean_of(r), mean_of(g), mean_of(b)};
      if (scene.textures[part.texture].opacity.values.empty()) part.texture = kNone;
      scene.materials.push_back(std::move(part));
    }
    polygon.material = it->second;
  }
  for (size_t m = 0; m < count; ++m) {
    Material& material = scene.materials[m];
    if (material.texture == kNone) continue;
    if (!is_black(material.emission))
      material.reflectance = material.reflectance * mean_colour(scene.textures[material.texture]);
    if (scene.textures[material.texture].opacity.values.empty()) material.texture = kNone;
  }
  const auto has_holes = [](const Texture& texture) { return !texture.opacity.values.empty(); };
  if (std::none_of(scene.textures.begin(), scene.textures.end(), has_holes)) scene.textures.clear();
  for (Texture& texture : scene.textures) texture.srgb = {};
  return scene;
}

}  // namespace strad
