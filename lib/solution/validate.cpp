// Checks that a solution is complete and fits its scene. Readers of a checked solution need no further tests.
#include <cmath>
#include <string>

#include "base/error.h"
#include "solution/solution.h"

namespace strad {
namespace {

constexpr uint32_t kMaxLog2Cells = 30;  // so that cell numbers fit in 32 bits with room to add

// Throws BadInput "solution: WHAT NUMBER: FAULT" unless `holds`.
void check(bool holds, const std::string& what, size_t number, const std::string& fault) {
  if (!holds) throw BadInput("solution: " + what + " " + std::to_string(number) + ": " + fault);
}

void check_grid(const TimeGrid& grid) {
  if (grid.order < 1 || grid.order > kMaxOrder) {
    throw BadInput("solution: temporal order " + std::to_string(grid.order) + ", expected 1 to 3");
  }
  if (grid.spans.empty()) throw BadInput("solution: no time spans, expected at least one");
  uint64_t cells = 0;
  for (size_t i = 0; i < grid.spans.size(); ++i) {
    const Span& span = grid.spans[i];
    const bool ordered = std::isfinite(span.begin) && std::isfinite(span.end) && span.begin <= span.end;
    check(ordered, "time span", i, "begin and end are not finite and in order");
    check(i == 0 || span.begin == grid.spans[i - 1].end, "time span", i,
          "does not begin where the last one ends");
    check(span.first_cell == cells, "time span", i, "first cell does not follow the last span's cells");
    check(span.log2_cells <= kMaxLog2Cells, "time span", i, "too many cells, expected at most 2^30");
    cells += uint64_t{1} << span.log2_cells;
    check(cells <= uint64_t{1} << kMaxLog2Cells, "time span", i,
          "too many cells in all, expected at most 2^30");
  }
}

void check_vertex(const Mesh& mesh, size_t v) {
  const uint32_t* parents = mesh.vertices[v].parents;
  int count = 0;
  while (count < 4 && parents[count] != kNone) ++count;
  check(count == 0 || count == 2 || count == 4, "vertex", v, "expected 0, 2 or 4 parents");
  for (int i = 0; i < 4; ++i) {
    check(i < count ? parents[i] < v : parents[i] == kNone, "vertex", v, "a parent does not come before it");
  }
  check(is_finite(mesh.vertices[v].position), "vertex", v, "position is not finite");
}

void check_element(const Mesh& mesh, size_t e) {
  const Element& element = mesh.elements[e];
  for (int i = 0; i < element.corner_count(); ++i) {
    check(element.vertices[i] < mesh.vertices.size(), "element", e, "a corner is no vertex of the mesh");
  }
  if (element.first_child == kNone) return;
  const size_t first = element.first_child;
  check(first > e && first + 4 <= mesh.elements.size(), "element", e,
        "children do not follow it in the mesh");
  for (size_t c = first; c < first + 4; ++c) {
    check(mesh.elements[c].corner_count() == element.corner_count(), "element", e,
          "a child has another number of corners");
  }
}

void check_face(const Scene& scene, const Mesh& mesh, size_t f) {
  const Face& face = mesh.faces[f];
  check(face.polygon < scene.polygons.size(), "face", f, "polygon is not in the scene");
  check(face.side < 2, "face", f, "expected side 0 or 1");
  check(face.element < mesh.elements.size(), "face", f, "root is no element of the mesh");
  check(mesh.elements[face.element].corner_count() == scene.polygons[face.polygon].corner_count(), "face", f,
        "root and polygon differ in the number of corners");
  check(mesh.face_of_side[2 * face.polygon + face.side] == f, "face", f, "its polygon names another face");
}

void check_mesh(const Scene& scene, const Mesh& mesh) {
  if (mesh.face_of_side.size() != 2 * scene.polygons.size()) {
    throw BadInput("solution: made for " + std::to_string(mesh.face_of_side.size() / 2) +
                   " polygons, but the scene has " + std::to_string(scene.polygons.size()));
  }
  for (size_t v = 0; v < mesh.vertices.size(); ++v) check_vertex(mesh, v);
  for (size_t e = 0; e < mesh.elements.size(); ++e) check_element(mesh, e);
  for (size_t f = 0; f < mesh.faces.size(); ++f) check_face(scene, mesh, f);
  for (size_t s = 0; s < mesh.face_of_side.size(); ++s) {
    const uint32_t face = mesh.face_of_side[s];
    if (face == kNone) continue;
    const bool own =
        face < mesh.faces.size() && 2 * size_t{mesh.faces[face].polygon} + mesh.faces[face].side == s;
    check(own, "side", s, "names a face that is not its own");
  }
}

void check_row(const TimeGrid& grid, const Field& field, size_t row) {
  uint64_t next_cell = 0;
  for (uint32_t p = field.first_piece[row]; p < field.first_piece[row + 1]; ++p) {
    const Interval piece = field.pieces[p];
    check(piece.cell < grid.cell_count(), "vertex", row, "a piece lies outside the time grid");
    const Span& span = grid.spans[span_of_cell(grid, piece.cell)];
    check(piece.log2_cells <= span.log2_cells, "vertex", row, "a piece is longer than its span");
    check((piece.cell - span.first_cell) % piece.cell_count() == 0, "vertex", row, "a piece is not dyadic");
    check(piece.cell >= next_cell, "vertex", row, "pieces overlap or are out of order");
    next_cell = uint64_t{piece.cell} + piece.cell_count();
  }
}

void check_field(const Slab& slab, const Field& field) {
  if (field.order != slab.grid.order)
    throw BadInput("solution: light and time grid differ in temporal order");
  if (field.first_piece.size() != slab.mesh.vertices.size() + 1 || field.first_piece[0] != 0) {
    throw BadInput("solution: expected one function of time a vertex, " +
                   std::to_string(slab.mesh.vertices.size()) + " in all");
  }
  for (size_t row = 0; row + 1 < field.first_piece.size(); ++row) {
    const bool ascend = field.first_piece[row] <= field.first_piece[row + 1] &&
                        field.first_piece[row + 1] <= field.pieces.size();
    check(ascend, "vertex", row, "its pieces are out of range");
    check_row(slab.grid, field, row);
  }
  if (field.first_piece.back() != field.pieces.size() ||
      field.coefficients.size() != field.pieces.size() * static_cast<size_t>(field.order)) {
    throw BadInput("solution: numbers of functions, pieces and coefficients do not agree");
  }
  for (size_t i = 0; i < field.coefficients.size(); ++i) {
    check(is_finite(field.coefficients[i]), "coefficient", i, "not finite");
  }
}

}  // namespace

void validate(const Scene& scene, const Solution& solution) {
  for (size_t i = 0; i < solution.slabs.size(); ++i) {
    const Slab& slab = solution.slabs[i];
    check_grid(slab.grid);
    check(i == 0 || slab_begin(slab) == slab_end(solution.slabs[i - 1]), "time slab", i,
          "does not begin where the last one ends");
    check_mesh(scene, slab.mesh);
    check_field(slab, slab.direct);
    check_field(slab, slab.indirect);
  }
}

}  // namespace strad
