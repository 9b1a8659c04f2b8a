#include "frame/camera.h"

namespace strad {

CameraRays::CameraRays(const CameraState& camera, uint32_t width, uint32_t height) : from_(camera.from) {
  const Vec3 forward = normalized(camera.to - camera.from);
  const Vec3 right = normalized(cross(forward, camera.up));
  const Vec3 down = cross(forward, right);
  const double pixel =
      2 * std::tan(camera.fov / 2) / height;  // pixels are square; the field of view is vertical
  right_ = pixel * right;
  down_ = pixel * down;
  corner_ = forward - 0.5 * width * right_ - 0.5 * height * down_;
}

}  // namespace strad
