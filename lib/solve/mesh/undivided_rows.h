// Functions of time of undivided faces.
//
// There may be a million of them, so they are found and compressed a few at a time.
#pragma once

#include <functional>

#include "solve/mesh/mesh_builder.h"
#include "time/field.h"

namespace strad {

// The tolerance for the function of a vertex, W / m^2: `tolerance` on large faces, larger on small ones.
float tolerance_of(const MeshBuilder& builder, uint32_t vertex, float tolerance);

// The vertices of an undivided face: one if it is uniform, else one per corner, in order and without gaps.
struct UndividedVertices {
  uint32_t first, count;
};
UndividedVertices vertices_of_undivided(const Mesh& mesh, uint32_t face);

// Values at all time samples at each of the vertices of an undivided face; adds the rays it traced.
using FindUndivided = std::function<std::vector<std::vector<Rgb>>(uint32_t face, uint64_t* rays)>;

// How exactly the function of a vertex with these values is kept, W / m^2.
using Tolerance = std::function<float(uint32_t vertex, const std::vector<Rgb>& values)>;

// One row per vertex of the undivided faces, in order. Adds all rays to `rays`.
Field rows_of_undivided_faces(const TimeGrid& grid, const MeshBuilder& builder, const Tolerance& tolerance,
                              const FindUndivided& find, uint64_t* rays);

// The same field with noise removed: the rows of uniform faces on curved surfaces are moved half way towards
// the mean of those around them, kSweeps times, as far as the difference is noise. Other rows stay as they
// are.
Field denoise_uniform_faces(const TimeGrid& grid, const MeshBuilder& builder, const Tolerance& tolerance,
                            Field field);

}  // namespace strad
