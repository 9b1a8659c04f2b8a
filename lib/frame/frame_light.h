// Irradiance on all faces from the solution, at the instant of a frame or in the mean over its exposure.
#pragma once

#include <memory>
#include <vector>

#include "frame/reconstruction.h"
#include "frame/smooth_joints.h"
#include "solution/solution.h"

namespace strad {

struct FrameLightOptions {
  bool with_direct = false;  // the direct light of the mesh, too
  bool flat = false;         // elements and intervals as they are, without any reconstruction
};

class FrameLight {
 public:
  // At begin, or the mean over [begin, end] where end > begin. Keeps references.
  FrameLight(const Slab& slab, const Reconstruction& reconstruction, const SmoothJoints& joints, double begin,
             double end, const FrameLightOptions& options);

  // W / m^2; zero on sides that no light reaches. With `flat`, `leaf` takes the element, otherwise it stays.
  Rgb irradiance(uint32_t polygon, bool front, Vec2 at, uint32_t* leaf) const;

 private:
  const Mesh& mesh_;
  const Reconstruction& reconstruction_;
  bool flat_;
  const SmoothJoints& joints_;
  std::vector<Rgb> vertex_irradiance_;
  std::vector<Rgb> corner_irradiance_;  // see SmoothJoints
};

}  // namespace strad
