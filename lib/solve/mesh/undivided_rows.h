// Functions of time of undivided faces: found and compressed a few at a time, for there may be a million.
#pragma once

#include <functional>

#include "solve/mesh/mesh_builder.h"
#include "time/field.h"

namespace strad {

// How exactly the function of a vertex is kept, W / m^2: `tolerance` on large faces, less on small ones.
float tolerance_of(const MeshBuilder& builder, uint32_t vertex, float tolerance);

// The vertices of an undivided face: one if it is uniform, else one per corner, in order and without gaps.
struct UndividedVertices {
  uint32_t first, count;
};
UndividedVertices vertices_of_undivided(const Mesh& mesh, uint32_t face);

// Values at all time samples at each of the vertices of an undivided face; adds the rays it traced.
using FindUndivided = std::function<std::vector<std::vector<Rgb>>(uint32_t face, uint64_t* rays)>;

// One row per vertex of the undivided faces, in order. Adds all rays to `rays`.
Field rows_of_undivided_faces(const TimeGrid& grid, const MeshBuilder& builder, float tolerance,
                              const FindUndivided& find, uint64_t* rays);

// The same field with the rows of uniform faces on curved surfaces moved half way towards the mean of those
// around them, kSweeps times, where that differs by no more than noise. Other rows stay as they are.
Field denoise_uniform_faces(const TimeGrid& grid, const MeshBuilder& builder, float tolerance, Field field);

}  // namespace strad
