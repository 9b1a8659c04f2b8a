// The sides of polygons that light can reach. Others, such as the inside of a closed solid, must cost
// nothing.
#pragma once

#include <vector>

#include "light/tracer.h"
#include "scene/scene.h"
#include "time/time_grid.h"

namespace strad {

// [2 * polygon + side]. Connected surfaces (ConnectedSurfaces) are dark or reached as a whole, by instants
// spread over the grid:
// - a surface that encloses its space with no lamp near it inside is dark, by geometry;
// - one that walks from the lights have met many times is reached;
// - of any other, walks back from it are searched for light, more and more of them. It is dark only if
//   thousands find none: less than a thousandth of its view can then hold any light.
// Of a reached surface, a side of a polygon on which something stands, so that all of thousands of rays meet
// only dark surfaces, is dark too.
// `dark`: sides that are known to be dark, or empty.
std::vector<bool> reached_sides(const Scene& scene, const Tracer& tracer, const TimeGrid& grid,
                                const std::vector<bool>& dark = {});

}  // namespace strad
