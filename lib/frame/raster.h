// Raster frames: direct light by shadow rays over the solution's indirect light, or all from the solution.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "frame/frame_light.h"
#include "frame/lit_groups.h"
#include "frame/surfaces.h"
#include "frame/tile.h"
#include "image/image.h"
#include "light/tracer.h"
#include "scene/scene.h"
#include "solution/solution.h"

namespace strad {

enum class DirectFrom { kPixel, kMesh };

struct RasterOptions {
  uint32_t width = 640, height = 480;  // pixels
  int samples = 16;       // per pixel, where more than one surface shows in it; 1: its centre only
  int lamp_samples = 32;  // shadow rays to each emitter group where it is in part hidden, >= 1
  double shutter = 0;     // s that the shutter is open from the frame's time on, >= 0
  DirectFrom direct = DirectFrom::kPixel;
  bool flat = false;  // elements and intervals of the solution as they are
};

// What a frame needs of a solution.
inline LightParts parts_for(const RasterOptions& options) {
  return options.direct == DirectFrom::kMesh ? LightParts::kAll : LightParts::kIndirect;
}

class Raster {
 public:
  explicit Raster(const Scene& scene);  // keeps a reference
  ~Raster();
  Raster(const Raster&) = delete;
  Raster& operator=(const Raster&) = delete;

  // Radiance, linear. REQUIRES: `slab` holds `time`, with the pieces of parts_for(options) to the end of the
  // shutter or of the slab. The picture is the same for any number of threads and whatever was rendered
  // before.
  // `layers` takes its light by origin, unless it is null.
  Image render(const Slab& slab, const Camera& camera, double time, const RasterOptions& options,
               LightLayers* layers = nullptr);

  const Surfaces& surfaces() const { return surfaces_; }

  // Radiance that surfaces reflect in the middles of the pixels, from the solution alone, of those pixels
  // that show a surface which does not emit. REQUIRES: `slab` holds `time`, with all pieces.
  std::vector<Rgb> reflected_light(const Slab& slab, const Camera& camera, double time, uint32_t width,
                                   uint32_t height);

 private:
  void prepare_for(const Slab& slab);

  const Scene& scene_;
  Tracer tracer_;
  Surfaces surfaces_;
  std::vector<EmitterGroup> groups_;
  std::unique_ptr<Reconstruction> reconstruction_;  // of the last slab
  std::unique_ptr<SmoothJoints> joints_;            // likewise
  const Slab* reconstructed_ = nullptr;
  double reconstructed_begin_ = 0;
};

}  // namespace strad
