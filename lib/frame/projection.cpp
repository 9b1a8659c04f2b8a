#include "frame/projection.h"

namespace strad {

Projection::Projection(const CameraState& camera, uint32_t width, uint32_t height)
    : from_(camera.from), width_(width), height_(height), scale_(height / (2 * std::tan(camera.fov / 2))) {
  forward_ = normalized(camera.to - camera.from);
  right_ = normalized(cross(forward_, camera.up));
  up_ = cross(right_, forward_);
}

std::optional<Vec2> Projection::pixel_of(Vec3 world) const {
  const double depth = depth_of(world);
  if (!(depth > 0)) return std::nullopt;
  const Vec3 seen = world - from_;
  return Vec2{width_ / 2 + scale_ * dot(seen, right_) / depth, height_ / 2 - scale_ * dot(seen, up_) / depth};
}

Matrix44 Projection::camera_from_world() const {
  const Vec3 back = -forward_;
  return {right_.x,
          up_.x,
          back.x,
          0,  //
          right_.y,
          up_.y,
          back.y,
          0,  //
          right_.z,
          up_.z,
          back.z,
          0,  //
          -dot(from_, right_),
          -dot(from_, up_),
          -dot(from_, back),
          1};
}

// x and y are those of the camera times twice the scale over the side, and w is the depth. z becomes the
// depth too, so that it is 1 after division: the projection has no planes that cut.
Matrix44 Projection::ndc_from_world() const {
  const double across = 2 * scale_ / width_, up = 2 * scale_ / height_;
  const double back = dot(from_, forward_);
  return {across * right_.x,
          up * up_.x,
          forward_.x,
          forward_.x,  //
          across * right_.y,
          up * up_.y,
          forward_.y,
          forward_.y,  //
          across * right_.z,
          up * up_.z,
          forward_.z,
          forward_.z,  //
          -across * dot(from_, right_),
          -up * dot(from_, up_),
          -back,
          -back};
}

}  // namespace strad
