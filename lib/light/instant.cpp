#include "light/instant.h"

namespace strad {

Instant instant_at(const Scene& scene, double time) {
  Instant instant;
  instant.time = time;
  instant.world_from_body = poses_at(scene, time);
  for (const Spot& spot : scene.spots)
    instant.spots.push_back(spot_at(scene, spot, instant.world_from_body, time));
  instant.glow = glow_at(scene, time);
  return instant;
}

}  // namespace strad
