// Functions of time of uniform faces: found and compressed a few at a time, for there may be a million.
#pragma once

#include <functional>

#include "solve/mesh_builder.h"
#include "time/field.h"

namespace strad {

// How exactly the function of a vertex is kept, W / m^2: `tolerance` on large faces, less on small ones.
float tolerance_of(const MeshBuilder& builder, uint32_t vertex, float tolerance);

// One row a uniform face, in order; `find` gives the values at all nodes of the grid at its vertex and adds
// the rays it traced. Adds all rays to `rays`.
Field rows_of_uniform_faces(const TimeGrid& grid, const MeshBuilder& builder, float tolerance,
                            const std::function<std::vector<Rgb>(uint32_t vertex, uint64_t* rays)>& find,
                            uint64_t* rays);

}  // namespace strad
