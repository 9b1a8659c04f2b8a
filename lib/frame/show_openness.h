// How open surfaces are, as a picture.
#pragma once

#include "frame/show_view.h"
#include "image/image.h"

namespace strad {

// The share of the view of a point, directions weighted by their cosine, in which nothing is nearer than
// `within` (m): 0 in a narrow gap, 1 on an open plane. The mean over `samples` points of each pixel; 0 where
// nothing is seen.
Image openness_picture(const ShowView& view, double within, int samples);

}  // namespace strad
