// Which sides of polygons can light reach at all? The inside of a closed solid cannot, and must cost nothing.
#pragma once

#include <vector>

#include "light/tracer.h"
#include "scene/scene.h"
#include "time/time_grid.h"

namespace strad {

// [2 * polygon + side]. Walks of diffuse bounces leave the lights at time samples spread over the grid; a
// connected surface (polygons that share edges, and the same side of all) is reached when walks meet it about
// as often as its area lets expect. Surfaces too small to be judged so count as reached, but for the insides
// of closed ones that no walk has met. Winding does not matter beyond that of neighbours.
std::vector<bool> reached_sides(const Scene& scene, const Tracer& tracer, const TimeGrid& grid);

}  // namespace strad
