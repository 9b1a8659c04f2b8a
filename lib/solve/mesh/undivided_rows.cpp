#include "solve/mesh/undivided_rows.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace strad {

float tolerance_of(const MeshBuilder& builder, uint32_t vertex, float tolerance) {
  return tolerance / static_cast<float>(builder.accuracy_share(builder.face_of_vertex(vertex)));
}

UndividedVertices vertices_of_undivided(const Mesh& mesh, uint32_t face) {
  const Element& root = mesh.elements[mesh.faces[face].element];
  return {root.vertices[0], is_uniform(root) ? 1 : static_cast<uint32_t>(root.corner_count())};
}

Field rows_of_undivided_faces(const TimeGrid& grid, const MeshBuilder& builder, const Tolerance& tolerance,
                              const FindUndivided& find, uint64_t* rays) {
  constexpr uint32_t kChunk = 256;  // faces held in full at once
  Field field;
  field.order = grid.order;
  field.expect_rows(2 * builder.mesh().vertices.size());  // room for all other vertices, too
  for (uint32_t first = 0; first < builder.undivided_faces(); first += kChunk) {
    const uint32_t count = std::min(kChunk, builder.undivided_faces() - first);
    std::vector<std::vector<std::vector<Rgb>>> rows(count);
    std::vector<uint64_t> traced(count, 0);
    parallel_for(count, 4, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) rows[i] = find(first + static_cast<uint32_t>(i), &traced[i]);
    });
    for (uint32_t i = 0; i < count; ++i) {
      uint32_t vertex = vertices_of_undivided(builder.mesh(), first + i).first;
      for (const std::vector<Rgb>& row : rows[i]) {
        append_row(grid, row, {}, tolerance(vertex, row), &field);
        ++vertex;
      }
      *rays += traced[i];
    }
  }
  return field;
}

namespace {

// The noise of rays is told from light: a function of time is compared to the mean of the functions around
// it, which it would equal if light varied linearly. The median of these differences is taken for noise.

constexpr int kSweeps = 2;  // each removes about half of the noise

// Root mean square of `difference` over all time samples, relative to that of `own`.
double relative_rms(const std::vector<Rgb>& difference, const std::vector<Rgb>& own) {
  const auto sum_of_squares = [](const std::vector<Rgb>& values) {
    double sum = 0;
    for (const Rgb& c : values) sum += double{c.r} * c.r + double{c.g} * c.g + double{c.b} * c.b;
    return sum;
  };
  const double all = sum_of_squares(own);
  return all > 0 ? std::sqrt(sum_of_squares(difference) / all) : 0;
}

// The median, or 0 of no values. Changes the order of the values.
double median_of(std::vector<double>* values) {
  if (values->empty()) return 0;
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

// The share of a difference that is taken for noise: 1 up to the usual difference, falling to 0 at three
// times that.
float share_of_noise(double difference, double usual) {
  constexpr double kLight = 3;
  return usual > 0 ? static_cast<float>(std::clamp((kLight - difference / usual) / (kLight - 1), 0.0, 1.0))
                   : 0;
}

std::vector<Rgb> values_of_row(const TimeGrid& grid, const Field& field, uint32_t row) {
  std::vector<Rgb> values(grid.sample_count());
  add_values(grid, field, row, 0, grid.cell_count(), values.data());
  return values;
}

// The mean of the functions around a face minus its own.
std::vector<Rgb> difference_of(const TimeGrid& grid, const Field& field, const std::vector<Rgb>& own,
                               const std::vector<uint32_t>& around) {
  std::vector<Rgb> difference(own.size());
  for (const uint32_t n : around) add_values(grid, field, n, 0, grid.cell_count(), difference.data());
  for (size_t d = 0; d < own.size(); ++d)
    difference[d] = (1 / static_cast<float>(around.size())) * difference[d] - own[d];
  return difference;
}

void copy_row(const Field& from, uint32_t row, Field* to) {
  const auto begin = static_cast<std::ptrdiff_t>(from.first_piece[row]),
             end = static_cast<std::ptrdiff_t>(from.first_piece[row + 1]);
  to->pieces.insert(to->pieces.end(), from.pieces.begin() + begin, from.pieces.begin() + end);
  to->coefficients.insert(to->coefficients.end(), from.coefficients.begin() + begin * from.order,
                          from.coefficients.begin() + end * from.order);
  to->first_piece.push_back(static_cast<uint32_t>(to->pieces.size()));
}

// The usual size of such a difference, from about a thousand faces.
double usual_difference(const TimeGrid& grid, const Field& field,
                        const std::vector<std::vector<uint32_t>>& neighbours,
                        const std::vector<uint32_t>& curved) {
  std::vector<double> differences;
  for (size_t i = 0; i < curved.size(); i += curved.size() / 1000 + 1) {
    const std::vector<Rgb> own = values_of_row(grid, field, curved[i]);
    differences.push_back(relative_rms(difference_of(grid, field, own, neighbours[curved[i]]), own));
  }
  return median_of(&differences);
}

}  // namespace

Field denoise_uniform_faces(const TimeGrid& grid, const MeshBuilder& builder, const Tolerance& tolerance,
                            Field field) {
  constexpr size_t kRows = 1024;  // held in full at once
  // The rows of uniform faces come first, one each, so a face's number is its row's.
  const std::vector<std::vector<uint32_t>> neighbours = builder.curved_neighbours();
  std::vector<uint32_t> curved;
  for (uint32_t f = 0; f < neighbours.size(); ++f)
    if (!neighbours[f].empty()) curved.push_back(f);
  for (int sweep = 0; sweep < kSweeps && !curved.empty(); ++sweep) {
    const double usual = usual_difference(grid, field, neighbours, curved);
    Field smoothed;
    smoothed.order = grid.order;
    smoothed.expect_rows(2 * builder.mesh().vertices.size());  // as in rows_of_undivided_faces
    for (size_t first = 0; first < curved.size(); first += kRows) {
      std::vector<std::vector<Rgb>> rows(std::min(kRows, curved.size() - first));
      parallel_for(rows.size(), 16, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const uint32_t face = curved[first + i];
          rows[i] = values_of_row(grid, field, face);
          const std::vector<Rgb> difference = difference_of(grid, field, rows[i], neighbours[face]);
          const float part = 0.5f * share_of_noise(relative_rms(difference, rows[i]), usual);
          for (size_t d = 0; d < difference.size(); ++d) rows[i][d] += part * difference[d];
        }
      });
      for (size_t i = 0; i < rows.size(); ++i) {
        while (smoothed.row_count() < curved[first + i]) copy_row(field, smoothed.row_count(), &smoothed);
        append_row(grid, rows[i], {}, tolerance(curved[first + i], rows[i]), &smoothed);
      }
    }
    while (smoothed.row_count() < field.row_count()) copy_row(field, smoothed.row_count(), &smoothed);
    field = std::move(smoothed);
  }
  return field;
}

}  // namespace strad
