// What all pictures of a solution's make share: a scene at an instant, and a camera before it.
#pragma once

#include <cstdint>

#include "frame/camera.h"
#include "frame/surfaces.h"
#include "light/tracer.h"
#include "solution/mesh.h"

namespace strad {

struct ShowView {
  const Scene& scene;
  const Tracer& tracer;
  const Surfaces& surfaces;
  Instant instant;
  CameraRays camera;
  uint32_t width, height;  // pixels

  // (x, y): in pixels from the upper left corner.
  Sight look(double x, double y) const {
    return surfaces.look(instant, camera.from(), camera.direction(x, y));
  }
};

// For surfaces that are not in the mesh, or of which the mesh does not hold what is shown.
constexpr float kNoMeshGrey = 0.18f;

// The face of the mesh that is seen; kNone where there is none.
inline uint32_t face_seen(const Mesh& mesh, const Sight& sight) {
  if (sight.point.polygon == kNone) return kNone;
  return mesh.face_of_side[2 * size_t{sight.point.polygon} + (sight.front ? 0 : 1)];
}

}  // namespace strad
