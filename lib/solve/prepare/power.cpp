#include "solve/prepare/power.h"

#include <algorithm>
#include <cmath>

#include "scene/polygon_geometry.h"

namespace strad {
namespace {

// Integral of the falloff (a smoothstep of the cosine) over all directions, sr.
double beam_solid_angle(const Spot& spot) {
  const double low = std::cos(spot.outer), high = std::cos(spot.inner);
  return 2 * kPi * ((1 - high) + 0.5 * (high - low));
}

}  // namespace

double expected_mean_radiance(const Scene& scene, const std::vector<Instant>& instants) {
  double area = 0, reflected = 0;
  std::vector<double> emitting_area(scene.materials.size(), 0.0);
  for (const Polygon& polygon : scene.polygons) {
    const double a = polygon_area(scene, polygon);
    area += a;
    reflected += a * mean_channel(scene.materials[polygon.material].reflectance);
    emitting_area[polygon.material] += a;
  }
  if (!(area > 0) || instants.empty()) return 0;
  double power = 0;
  const size_t stride = std::max<size_t>(1, instants.size() / 16);
  int instant_count = 0;
  for (size_t i = 0; i < instants.size(); i += stride, ++instant_count) {
    for (size_t s = 0; s < scene.spots.size(); ++s)
      power += beam_solid_angle(scene.spots[s]) * mean_channel(instants[i].spots[s].intensity);
    for (size_t m = 0; m < scene.materials.size(); ++m)
      power += kPi * emitting_area[m] * instants[i].glow[m] * mean_channel(scene.materials[m].emission);
  }
  const double rho = std::min(reflected / area, 0.9);
  return rho / kPi * power / instant_count / area / (1 - rho);
}

}  // namespace strad
