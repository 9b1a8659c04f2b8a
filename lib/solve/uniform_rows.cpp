#include "solve/uniform_rows.h"

#include <algorithm>

#include "base/parallel.h"

namespace strad {

float tolerance_of(const MeshBuilder& builder, uint32_t vertex, float tolerance) {
  return tolerance / static_cast<float>(builder.prominence(builder.face_of_vertex(vertex)));
}

Field rows_of_uniform_faces(const TimeGrid& grid, const MeshBuilder& builder, float tolerance,
                            const std::function<std::vector<Rgb>(uint32_t vertex, uint64_t* rays)>& find,
                            uint64_t* rays) {
  constexpr uint32_t kChunk = 512;  // held in full at once
  Field field;
  field.order = grid.order;
  field.expect_rows(2 * builder.mesh().vertices.size());  // the other vertices and those to come follow
  const uint32_t uniform = builder.uniform_count();
  for (uint32_t first = 0; first < uniform; first += kChunk) {
    const uint32_t count = std::min(kChunk, uniform - first);
    std::vector<std::vector<Rgb>> rows(count);
    std::vector<uint64_t> traced(count, 0);
    parallel_for(count, 4, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) rows[i] = find(first + static_cast<uint32_t>(i), &traced[i]);
    });
    for (uint32_t i = 0; i < count; ++i) {
      append_row(grid, rows[i], {}, tolerance_of(builder, first + i, tolerance), &field);
      *rays += traced[i];
    }
  }
  return field;
}

}  // namespace strad
