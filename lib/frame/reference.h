// Reference frames: a scene path traced, without any solution.
//
// From the eye, paths are mirrored and bent. From the first diffuse surface on, light is that of the solve:
// it goes straight through glass, and mirrors send none.
#pragma once

#include <cstdint>

#include "frame/paths.h"
#include "frame/surfaces.h"
#include "image/image.h"
#include "light/tracer.h"
#include "scene/scene.h"

namespace strad {

struct ReferenceOptions {
  uint32_t width = 640, height = 480;  // pixels
  int paths = 64;                      // per pixel, >= 1
  double shutter = 0;                  // s that the shutter is open from the frame's time on, >= 0
  uint64_t seed = 0;                   // pictures of different seeds have independent noise
};

class Reference {
 public:
  explicit Reference(const Scene& scene);  // keeps a reference

  // Radiance, linear; each pixel is an unbiased estimate of the mean over its area and the open shutter. The
  // picture is the same for any number of threads.
  Image render(const Camera& camera, double time, const ReferenceOptions& options) const;

 private:
  struct Exposure;
  Rgb radiance(const Instant& instant, Sight sight, PathRandom* random) const;
  Rgb diffuse(const Instant& instant, const Sight& sight, PathRandom* random) const;
  Rgb pixel(const Exposure& exposure, uint32_t x, uint32_t y) const;

  const Scene& scene_;
  Tracer tracer_;
  Surfaces surfaces_;
  Paths paths_;
};

}  // namespace strad
