// Where points of the world show in a camera's picture, and the matrices that say so to other programs.
#pragma once

#include <cstdint>
#include <optional>

#include "image/picture_facts.h"
#include "scene/trajectory.h"

namespace strad {

class Projection {
 public:
  // REQUIRES: what CameraRays requires.
  Projection(const CameraState& camera, uint32_t width, uint32_t height);

  // Pixels from the upper left corner of the picture, also outside of it. Nothing for points that are not
  // before the camera.
  std::optional<Vec2> pixel_of(Vec3 world) const;
  // m along the axis of view.
  double depth_of(Vec3 world) const { return dot(world - from_, forward_); }

  // As picture_facts.h has them.
  double screen_width() const { return width_ / scale_; }
  Matrix44 camera_from_world() const;
  Matrix44 ndc_from_world() const;

 private:
  Vec3 from_, right_, up_, forward_;  // unit vectors
  double width_, height_;
  double scale_;  // pixels to which a length of 1 m at a depth of 1 m extends
};

}  // namespace strad
