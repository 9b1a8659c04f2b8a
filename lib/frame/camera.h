// Rays of a pinhole camera.
#pragma once

#include <cstdint>

#include "scene/trajectory.h"

namespace strad {

class CameraRays {
 public:
  // REQUIRES: `camera` looks somewhere (from != to) and up is not along its view.
  CameraRays(const CameraState& camera, uint32_t width, uint32_t height);

  Vec3 from() const { return from_; }
  // World, unit length. The picture covers x in [0, width] from the left and y in [0, height] from the top.
  Vec3 direction(double x, double y) const { return normalized(corner_ + x * right_ + y * down_); }

 private:
  Vec3 from_;
  Vec3 corner_;        // towards the upper left corner of the picture
  Vec3 right_, down_;  // one pixel
};

}  // namespace strad
