// Quick pictures of a scene without a solution: lamps without shadows, and a headlight.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/surfaces.h"
#include "image/image.h"
#include "light/spotlight.h"
#include "light/tracer.h"
#include "scene/scene.h"

namespace strad {

class Preview {
 public:
  explicit Preview(const Scene& scene);  // keeps a reference

  // One ray a pixel. Lamps have their strength, so that a preview tells which exposure a frame will need; all
  // that they do not reach has a little light from the camera, or all of it if there are no lamps.
  Image render(const Camera& camera, double time, uint32_t width, uint32_t height) const;

 private:
  // Emitting polygons of one material and object, as one small lamp.
  struct Lamp {
    uint32_t body = 0, material = 0;
    Vec3 centre, normal;   // rest; the normal is zero for a lamp that shines all around
    double area = 0;       // m^2
    double projected = 0;  // of it, along the normal, or the mean over all directions
  };
  Rgb lamps_irradiance(const Instant& instant, const SurfacePoint& point) const;

  const Scene& scene_;
  Tracer tracer_;
  Surfaces surfaces_;
  std::vector<SpotCone> cones_;
  std::vector<Lamp> lamps_;
};

}  // namespace strad
