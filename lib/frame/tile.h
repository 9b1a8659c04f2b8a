// A rectangle of a frame, rendered on its own.
#pragma once

#include <cstdint>

#include "frame/corners.h"
#include "frame/shading.h"
#include "image/image.h"

namespace strad {

// The light of a frame by its origin: together the frame, but for rounding.
struct LightLayers {
  Image direct, indirect, emission, specular;
};

// Renders the pixels of `rect`, into `layers` too unless it is null. A pixel does not depend on the rectangle
// in which it is rendered.
//
// If the corners of a pixel see one smooth surface under the same lights, the pixel is the mean of the
// samples at its corners, which it shares with its neighbours. Otherwise it is the mean of about `samples`
// samples inside it. A corner first sends few shadow rays to each emitter group. It sends more where some
// rays of it and its neighbours are free and some are blocked. The points on the emitters differ from corner
// to corner and together are spread evenly (corner_points). The visible fraction is averaged over the corners
// as far around the pixel as it is smooth (smooth_fraction).
void render_tile(const FrameView& view, int samples, TileRect rect, Image* image,
                 LightLayers* layers = nullptr);

}  // namespace strad
