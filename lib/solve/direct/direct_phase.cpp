#include "solve/direct/direct_phase.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/parallel.h"
#include "base/rng.h"
#include "solve/mesh/undivided_rows.h"

namespace strad {
namespace {

double longest_edge(const Mesh& mesh, const Element& element) {
  double longest = 0;
  const int n = element.corner_count();
  for (int i = 0; i < n; ++i)
    longest = std::max(longest, length(mesh.vertices[element.vertices[(i + 1) % n]].position -
                                       mesh.vertices[element.vertices[i]].position));
  return longest;
}

double area_of(const Mesh& mesh, const Element& element) {
  Vec3 corners[4];
  for (int i = 0; i < element.corner_count(); ++i) corners[i] = mesh.vertices[element.vertices[i]].position;
  return area_of(corners, element.corner_count());
}

std::vector<uint32_t> union_of(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
  std::vector<uint32_t> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

DirectPhase::DirectPhase(const Scene& scene, const Tracer& tracer, const TimeGrid& grid,
                         const SweptBounds& swept, const std::vector<Instant>& instants,
                         const DirectOptions& options, MeshBuilder* builder)
    : scene_(scene),
      grid_(grid),
      options_(options),
      builder_(*builder),
      light_(scene, tracer, grid, swept, instants, options.emitter_samples) {
  for (const Polygon& polygon : scene.polygons) total_area_ += polygon_area(scene, polygon);
}

void DirectPhase::value(uint32_t vertex, uint32_t cell, Rgb* values) const {
  const auto order = static_cast<size_t>(grid_.order);
  if (vertex < functions_.size()) {
    const SparseFunction& f = functions_[vertex];
    const auto it = std::lower_bound(f.cells.begin(), f.cells.end(), cell);
    if (it != f.cells.end() && *it == cell) {
      const size_t first = static_cast<size_t>(it - f.cells.begin()) * order;
      for (size_t k = 0; k < order; ++k) values[k] = f.values[first + k];
      return;
    }
  }
  for (size_t k = 0; k < order; ++k) values[k] = {};
  const MeshVertex& v = builder_.mesh().vertices[vertex];
  const int count = v.parent_count();
  for (int p = 0; p < count; ++p) {
    Rgb of_parent[kMaxOrder];
    value(v.parents[p], cell, of_parent);
    for (size_t k = 0; k < order; ++k) values[k] += (1.0f / static_cast<float>(count)) * of_parent[k];
  }
}

std::vector<Rgb> DirectPhase::irradiance(uint32_t vertex, const std::vector<uint32_t>& time_samples,
                                         uint64_t* rays) const {
  const Face& face = builder_.mesh().faces[builder_.face_of_vertex(vertex)];
  const Vec3 normal = (face.side == 0 ? 1.0 : -1.0) * polygon_normal(scene_, scene_.polygons[face.polygon]);
  return light_.irradiance({builder_.sample_point(vertex), normal, face.polygon}, time_samples, vertex, rays);
}

void DirectPhase::evaluate(const std::vector<uint32_t>& vertices,
                           const std::vector<std::vector<uint32_t>>& cells) {
  functions_.resize(builder_.mesh().vertices.size());
  std::vector<uint64_t> counts(vertices.size(), 0), rays(vertices.size(), 0);
  parallel_for(vertices.size(), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t vertex = vertices[i];
      const SparseFunction& known = functions_[vertex];
      SparseFunction f;
      f.cells = union_of(known.cells, cells[i]);
      f.cells.shrink_to_fit();
      const auto order = static_cast<uint32_t>(grid_.order);
      std::vector<uint32_t> fresh;  // time samples
      for (const uint32_t cell : f.cells)
        if (!std::binary_search(known.cells.begin(), known.cells.end(), cell))
          for (uint32_t k = 0; k < order; ++k) fresh.push_back(cell * order + k);
      counts[i] += fresh.size();
      const std::vector<Rgb> found = irradiance(vertex, fresh, &rays[i]);
      std::vector<Rgb> values;
      size_t old = 0, next = 0;
      for (const uint32_t cell : f.cells) {
        const bool have = old < known.cells.size() && known.cells[old] == cell;
        for (size_t k = 0; k < order; ++k)
          values.push_back(have ? known.values[old * order + k] : found[next++]);
        old += have;
      }
      f.values = FineFunction(values);
      functions_[vertex] = std::move(f);
    }
  });
  rays_ += std::accumulate(rays.begin(), rays.end(), uint64_t{0});
  evaluations_ += std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

// Splits the elements of a level in their cells, evaluates the new vertices, and returns the next level.
std::vector<DirectPhase::Work> DirectPhase::split(const std::vector<Work>& level) {
  std::vector<std::vector<uint32_t>> wanted(builder_.mesh().vertices.size());
  std::vector<uint32_t> touched;
  for (const Work& work : level) {
    if (builder_.mesh().elements[work.element].first_child == kNone) builder_.split(work.element);
    wanted.resize(builder_.mesh().vertices.size());
    uint32_t middles[5];
    const int count = builder_.middles(work.element, middles);
    for (int m = 0; m < count; ++m) {
      if (wanted[middles[m]].empty()) touched.push_back(middles[m]);
      wanted[middles[m]] = union_of(wanted[middles[m]], work.cells);
    }
  }
  std::vector<std::vector<uint32_t>> cells;
  for (const uint32_t vertex : touched) cells.push_back(std::move(wanted[vertex]));
  evaluate(touched, cells);

  split_cells_.resize(builder_.mesh().elements.size());
  std::vector<std::vector<uint32_t>> next_cells(level.size());
  parallel_for(level.size(), 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) next_cells[i] = worthwhile_cells(level[i]);
  });
  std::vector<Work> next;
  for (size_t i = 0; i < level.size(); ++i) {
    split_cells_[level[i].element] = level[i].cells;
    if (next_cells[i].empty()) continue;
    for (uint32_t c = 0; c < 4; ++c)
      next.push_back({builder_.mesh().elements[level[i].element].first_child + c, next_cells[i]});
  }
  return next;
}

// The cells in which the children of an element, just split, should be split in turn.
std::vector<uint32_t> DirectPhase::worthwhile_cells(const Work& work) const {
  const Mesh& mesh = builder_.mesh();
  const Element& element = mesh.elements[work.element];
  const Face& face = mesh.faces[builder_.face_of(work.element)];
  const Rgb reflectance = scene_.materials[scene_.polygons[face.polygon].material].reflectance;
  const double size = 0.5 * longest_edge(mesh, element);
  if (size < options_.smallest_element) return {};
  const bool coarse = size > options_.largest_element;
  const auto scale = static_cast<float>(max_channel(reflectance) / kPi *
                                        std::sqrt(0.25 * area_of(mesh, element) / total_area_));
  uint32_t middles[5];
  const int count = builder_.middles(work.element, middles);
  std::vector<uint32_t> cells;
  for (const uint32_t cell : work.cells) {
    float largest = 0;
    for (int m = 0; m < count; ++m) {
      const MeshVertex& vertex = mesh.vertices[middles[m]];
      const int parents = vertex.parent_count();
      Rgb own[kMaxOrder];
      value(middles[m], cell, own);
      for (int p = 0; p < parents; ++p) {
        Rgb of_parent[kMaxOrder];
        value(vertex.parents[p], cell, of_parent);
        for (int k = 0; k < grid_.order; ++k) own[k] += (-1.0f / static_cast<float>(parents)) * of_parent[k];
      }
      for (int k = 0; k < grid_.order; ++k)
        largest = std::max({largest, std::abs(own[k].r), std::abs(own[k].g), std::abs(own[k].b)});
    }
    if (coarse || largest * scale > options_.threshold) cells.push_back(cell);
  }
  return cells;
}

void DirectPhase::run() {
  std::vector<uint32_t> all_samples(grid_.sample_count());
  std::iota(all_samples.begin(), all_samples.end(), 0u);
  const Mesh& mesh = builder_.mesh();
  const auto of_undivided = [&](uint32_t face, uint64_t* rays) {
    std::vector<std::vector<Rgb>> values;
    const auto [first, count] = vertices_of_undivided(mesh, face);
    for (uint32_t v = first; v < first + count; ++v) values.push_back(irradiance(v, all_samples, rays));
    return values;
  };
  const auto tolerance = [&](uint32_t vertex, const std::vector<Rgb>&) {
    return tolerance_of(builder_, vertex, options_.tolerance);
  };
  undivided_rows_ = rows_of_undivided_faces(grid_, builder_, tolerance, of_undivided, &rays_);
  evaluations_ += uint64_t{builder_.undivided_vertices()} * grid_.sample_count();
  std::vector<uint32_t> all_cells(grid_.cell_count());
  std::iota(all_cells.begin(), all_cells.end(), 0u);
  std::vector<uint32_t> corners(mesh.vertices.size() - builder_.undivided_vertices());
  std::iota(corners.begin(), corners.end(), builder_.undivided_vertices());
  evaluate(corners, std::vector<std::vector<uint32_t>>(corners.size(), all_cells));
  std::vector<Work> level;
  for (uint32_t f = builder_.undivided_faces(); f < mesh.faces.size(); ++f) {
    const uint32_t root = mesh.faces[f].element;
    if (longest_edge(mesh, mesh.elements[root]) > options_.smallest_element)
      level.push_back({root, all_cells});
  }
  while (!level.empty()) level = split(level);
}

std::vector<Rgb> DirectPhase::mean_irradiance(uint32_t element, const std::vector<uint32_t>& cells) const {
  const auto order = static_cast<size_t>(grid_.order);
  const Mesh& mesh = builder_.mesh();
  const Element& e = mesh.elements[element];
  std::vector<Rgb> mean(cells.size() * order);
  if (builder_.face_of(element) < builder_.undivided_faces()) {
    const auto [first, count] = vertices_of_undivided(mesh, builder_.face_of(element));
    for (size_t i = 0; i < cells.size();) {  // runs of adjacent cells
      size_t j = i + 1;
      while (j < cells.size() && cells[j] == cells[j - 1] + 1) ++j;
      for (uint32_t v = first; v < first + count; ++v)
        add_values(grid_, undivided_rows_, v, cells[i], static_cast<uint32_t>(j - i), &mean[i * order]);
      i = j;
    }
    for (Rgb& value : mean) value = (1.0f / static_cast<float>(count)) * value;
    return mean;
  }
  const std::vector<uint32_t> none;
  const std::vector<uint32_t>& split = element < split_cells_.size() ? split_cells_[element] : none;
  std::vector<uint32_t> inner;
  std::set_intersection(cells.begin(), cells.end(), split.begin(), split.end(), std::back_inserter(inner));
  const int n = e.corner_count();
  for (size_t i = 0; i < cells.size(); ++i) {
    if (std::binary_search(inner.begin(), inner.end(), cells[i])) continue;
    for (int c = 0; c < n; ++c) {
      Rgb of_corner[kMaxOrder];
      value(e.vertices[c], cells[i], of_corner);
      for (size_t k = 0; k < order; ++k) mean[i * order + k] += (1.0f / static_cast<float>(n)) * of_corner[k];
    }
  }
  if (inner.empty()) return mean;
  double area = 0;
  for (uint32_t c = 0; c < 4; ++c) area += area_of(mesh, mesh.elements[e.first_child + c]);
  for (uint32_t c = 0; c < 4; ++c) {
    const std::vector<Rgb> of_child = mean_irradiance(e.first_child + c, inner);
    const auto share = static_cast<float>(area_of(mesh, mesh.elements[e.first_child + c]) / area);
    size_t i = 0;
    for (size_t j = 0; j < inner.size(); ++j) {
      while (cells[i] != inner[j]) ++i;
      for (size_t k = 0; k < order; ++k) mean[i * order + k] += share * of_child[j * order + k];
    }
  }
  return mean;
}

Field DirectPhase::take_surpluses() {
  const auto order = static_cast<size_t>(grid_.order);
  const Mesh& mesh = builder_.mesh();
  const std::vector<bool> hanging = builder_.hanging_vertices();
  functions_.resize(mesh.vertices.size());
  Field field = std::move(undivided_rows_);
  for (uint32_t v = builder_.undivided_vertices(); v < mesh.vertices.size(); ++v) {
    SparseFunction& f = functions_[v];
    if (hanging[v]) f = {};  // from now on it is the mean of its parents, for its children too
    const MeshVertex& vertex = mesh.vertices[v];
    const int parents = vertex.parent_count();
    std::vector<Rgb> row(grid_.sample_count());
    std::vector<bool> active(grid_.cell_count(), false);
    for (size_t i = 0; i < f.cells.size(); ++i) {
      active[f.cells[i]] = true;
      Rgb mean[kMaxOrder];
      for (int p = 0; p < parents; ++p) {
        Rgb of_parent[kMaxOrder];
        value(vertex.parents[p], f.cells[i], of_parent);
        for (size_t k = 0; k < order; ++k) mean[k] += (1.0f / static_cast<float>(parents)) * of_parent[k];
      }
      for (size_t k = 0; k < order; ++k) row[f.cells[i] * order + k] = f.values[i * order + k] - mean[k];
    }
    append_row(grid_, row, active, tolerance_of(builder_, v, options_.tolerance), &field);
  }
  functions_ = {};
  split_cells_ = {};
  return field;
}

}  // namespace strad
