// The exposure of an animation whose brightness nobody has measured: the same for all of its frames.
#pragma once

#include <vector>

#include "frame/raster.h"
#include "image/encoding.h"
#include "solution/solution_file.h"

namespace strad {

// Stops for pixels of these radiances. Their mean (of logarithms) is shown as middle grey, 0.18 of white
// (Reinhard et al. 2002, section 3), unless that would burn more than one pixel in fifty; then it burns just
// that share. Rounded to 1/100, so that the same picture can be asked for in words; 0 if all is black.
double exposure_for(const std::vector<Rgb>& radiances, const Encoding& encoding);

// Stops for what `camera` sees at instants spread over all that the solution covers: light that is reflected,
// from the solution alone. Lamps do not count. It depends neither on the frames that are rendered nor on
// their size, but on its proportions.
double exposure_for(SolutionFile* file, Raster* raster, const Camera& camera, const RasterOptions& options,
                    const Encoding& encoding);

}  // namespace strad
