#include "solve/whole_rows.h"

#include <algorithm>

#include "base/parallel.h"

namespace strad {

float tolerance_of(const MeshBuilder& builder, uint32_t vertex, float tolerance) {
  return tolerance / static_cast<float>(builder.prominence(builder.face_of_vertex(vertex)));
}

WholeVertices vertices_of_whole(const Mesh& mesh, uint32_t face) {
  const Element& root = mesh.elements[mesh.faces[face].element];
  return {root.vertices[0], is_uniform(root) ? 1 : static_cast<uint32_t>(root.corner_count())};
}

Field rows_of_whole_faces(const TimeGrid& grid, const MeshBuilder& builder, float tolerance,
                          const FindWhole& find, uint64_t* rays) {
  constexpr uint32_t kChunk = 256;  // faces held in full at once
  Field field;
  field.order = grid.order;
  field.expect_rows(2 * builder.mesh().vertices.size());  // the other vertices and those to come follow
  for (uint32_t first = 0; first < builder.whole_faces(); first += kChunk) {
    const uint32_t count = std::min(kChunk, builder.whole_faces() - first);
    std::vector<std::vector<std::vector<Rgb>>> rows(count);
    std::vector<uint64_t> traced(count, 0);
    parallel_for(count, 4, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) rows[i] = find(first + static_cast<uint32_t>(i), &traced[i]);
    });
    for (uint32_t i = 0; i < count; ++i) {
      uint32_t vertex = vertices_of_whole(builder.mesh(), first + i).first;
      for (const std::vector<Rgb>& row : rows[i])
        append_row(grid, row, {}, tolerance_of(builder, vertex++, tolerance), &field);
      *rays += traced[i];
    }
  }
  return field;
}

}  // namespace strad
