#include "scene/remarks.h"

#include <algorithm>

namespace strad {

bool is_lit(const Scene& scene) {
  std::vector<bool> emits;
  for (const Material& material : scene.materials) emits.push_back(!is_black(material.emission));
  for (const Glow& glow : scene.glows)
    if (std::all_of(glow.keys.begin(), glow.keys.end(), [](const GlowKey& key) { return key.value == 0; }))
      emits[glow.material] = false;
  return std::any_of(scene.polygons.begin(), scene.polygons.end(),
                     [&](const Polygon& polygon) { return emits[polygon.material]; }) ||
         std::any_of(scene.spots.begin(), scene.spots.end(), [](const Spot& spot) {
           return std::any_of(spot.keys.begin(), spot.keys.end(),
                              [](const SpotKey& key) { return !is_black(key.intensity); });
         });
}

std::vector<std::string> dark_glows(const Scene& scene) {
  std::vector<std::string> names;
  for (const Glow& glow : scene.glows) {
    const Material& material = scene.materials[glow.material];
    if (is_black(material.emission)) names.push_back(material.name);
  }
  return names;
}

}  // namespace strad
