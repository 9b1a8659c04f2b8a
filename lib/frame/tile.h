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
// light differ among the 4 x 4 corners around a pixel and make one well-spread set together, over which the
// visible fraction is averaged where it is smooth (interleaved sampling, Keller & Heidrich 2001).
void render_tile(const FrameView& view, int samples, TileRect rect, Image* image);

}  // namespace strad
