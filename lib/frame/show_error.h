// How much the elements of a mesh err, as a picture.
#pragma once

#include <vector>

#include "frame/show_view.h"
#include "image/image.h"
#include "solution/solution.h"

namespace strad {

constexpr double kFullError = 0.1;  // white in the picture

// An estimate of the error of interpolation on each leaf at `time`, over the mean of the radiance that the
// scene reflects; NaN on elements that nothing was split for. By element.
//
// Splitting an element told how much the light at the new vertices differs from the mean of their parents:
// what interpolation over the whole element had wrong there. Where light is smooth, elements of half the
// length have a quarter of that left.
std::vector<float> element_errors(const Scene& scene, const Slab& slab, double time);

// The same at the middle of each pixel, in all channels: 0 where nothing is seen, NaN where nothing is known.
Image error_values(const ShowView& view, const Slab& slab, double time);

// False colours (heat_map), white from kFullError on; NaN is grey.
Image error_colours(const Image& values);

}  // namespace strad
