// Frames as PLY meshes, binary little-endian: positions in the world at the frame's time, light at the
// vertices.
#pragma once

#include <memory>
#include <string>

#include "scene/scene.h"
#include "solution/solution.h"

namespace strad {

// REQUIRES: validated scene and solution, which outlive the export.
class PlyExport {
 public:
  PlyExport(const Scene& scene, const Solution& solution);
  ~PlyExport();
  PlyExport(const PlyExport&) = delete;
  PlyExport& operator=(const PlyExport&) = delete;

  // The bytes of one PLY file. A vertex has float x y z (m), uchar red green blue (sRGB of the radiance
  // scaled by 2^exposure, clipped) and float radiance_r radiance_g radiance_b (W / (sr m^2), linear, not
  // scaled). Thread-safe.
  std::string frame(double time, double exposure = 0) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace strad
