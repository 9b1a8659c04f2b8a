// A rectangle of a frame, rendered on its own.
#pragma once

#include <cstdint>

#include "frame/corners.h"
#include "frame/shading.h"
#include "image/image.h"

namespace strad {

// Renders the pixels of `rect`, each as it would come out in any other rectangle.
//
// A pixel is the mean of samples at its corners, which it shares with its neighbours, where these see one
// smooth surface under the same lights; elsewhere of `samples` samples inside it. Corners begin with few
// shadow rays to each emitter group and get more where they or their neighbours disagree. The points on the
// light differ from corner to corner and make one well-spread set together (corner_points), over which the
// visible fraction is averaged as far around the pixel as it is smooth (smooth_fraction).
void render_tile(const FrameView& view, int samples, TileRect rect, Image* image);

}  // namespace strad
