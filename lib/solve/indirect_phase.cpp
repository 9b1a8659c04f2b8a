#include "solve/indirect_phase.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "solve/uniform_rows.h"

namespace strad {
namespace {

int parent_count(const MeshVertex& vertex) {
  return vertex.parents[0] == kNone ? 0 : vertex.parents[2] == kNone ? 2 : 4;
}

}  // namespace

IndirectPhase::IndirectPhase(const Scene& scene, const TimeGrid& grid, const FinalGather& gather,
                             const IndirectOptions& options, MeshBuilder* builder)
    : scene_(scene), grid_(grid), gather_(gather), options_(options), builder_(*builder) {
  for (const Polygon& polygon : scene.polygons) total_area_ += polygon_area(scene, polygon);
}

void IndirectPhase::evaluate(const std::vector<uint32_t>& vertices) {
  functions_.resize(builder_.mesh().vertices.size());
  std::vector<uint32_t> fresh;
  for (const uint32_t v : vertices)
    if (functions_[v].irradiance.empty()) fresh.push_back(v);
  std::sort(fresh.begin(), fresh.end());
  fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
  std::vector<uint64_t> rays(fresh.size(), 0);
  parallel_for(fresh.size(), 4, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      GatheredFunction f = gather_.at_vertex(fresh[i], &rays[i]);
      functions_[fresh[i]] = {TightFunction(f.irradiance), std::move(f.open)};
    }
  });
  rays_ += std::accumulate(rays.begin(), rays.end(), uint64_t{0});
}

std::vector<Rgb> IndirectPhase::parents_mean(uint32_t vertex) const {
  const MeshVertex& v = builder_.mesh().vertices[vertex];
  const int count = parent_count(v);
  std::vector<Rgb> mean(grid_.node_count());
  for (int p = 0; p < count; ++p) {
    // A parent without a function of its own (it hangs, or belongs to direct light alone) is the mean of its
    // own.
    const TightFunction& own = functions_[v.parents[p]].irradiance;
    const std::vector<Rgb> of_parent = own.empty() ? parents_mean(v.parents[p]) : own.unpacked();
    for (size_t i = 0; i < mean.size(); ++i) mean[i] += (1.0f / static_cast<float>(count)) * of_parent[i];
  }
  return mean;
}

// Does the foot of something cross the element at some date? Light there changes too fast to be told from a
// few vertices, half of which see nothing.
bool IndirectPhase::is_partly_buried(uint32_t element) const {
  const Element& e = builder_.mesh().elements[element];
  uint32_t vertices[9];
  int count = builder_.middles(element, vertices);
  for (int i = 0; i < e.corner_count(); ++i) vertices[count++] = e.vertices[i];
  const bool any =
      std::any_of(vertices, vertices + count, [&](uint32_t v) { return !functions_[v].open.empty(); });
  if (!any) return false;
  for (size_t i = 0; i < grid_.node_count(); ++i) {
    int buried = 0, known = 0;
    for (int v = 0; v < count; ++v) {
      if (functions_[vertices[v]].irradiance.empty()) continue;
      ++known;
      buried += open_at(vertices[v], i) < 0.5f;
    }
    if (buried > 0 && buried < known) return true;
  }
  return false;
}

// Do the vertices that splitting this element has added differ from what their parents foretold?
bool IndirectPhase::worth_splitting(uint32_t element) const {
  const Mesh& mesh = builder_.mesh();
  const Element& e = mesh.elements[element];
  const auto at = [&](int i) { return mesh.vertices[e.vertices[i]].position; };
  const double edge = std::max(length(at(1) - at(0)), length(at(2) - at(1)));
  if (edge < 2 * options_.smallest_element) return false;
  if (edge > 2 * options_.largest_element) return true;
  if (is_partly_buried(element)) return true;
  const Polygon& polygon = scene_.polygons[mesh.faces[builder_.face_of(element)].polygon];
  const double area = length(cross(at(1) - at(0), at(2) - at(0))) * (e.corner_count() == 4 ? 1 : 0.5);
  const auto scale = static_cast<float>(max_channel(scene_.materials[polygon.material].reflectance) / kPi *
                                        std::sqrt(0.25 * area / total_area_));
  uint32_t middles[5];
  const int count = builder_.middles(element, middles);
  for (int m = 0; m < count; ++m) {
    const std::vector<Rgb> foretold = parents_mean(middles[m]);
    const VertexFunction& own = functions_[middles[m]];
    for (size_t i = 0; i < foretold.size(); ++i) {
      float open = open_at(middles[m], i);
      for (int p = 0; p < parent_count(mesh.vertices[middles[m]]); ++p)
        open = std::min(open, open_at(mesh.vertices[middles[m]].parents[p], i));
      if (open < 0.5f) continue;  // buried: what is known there is not light
      const Rgb surplus = own.irradiance[i] - foretold[i];
      if (std::max({std::abs(surplus.r), std::abs(surplus.g), std::abs(surplus.b)}) * scale >
          options_.threshold)
        return true;
    }
  }
  return false;
}

void IndirectPhase::run() {
  const Mesh& mesh = builder_.mesh();
  uniform_ = rows_of_uniform_faces(
      grid_, builder_, options_.tolerance,
      [&](uint32_t vertex, uint64_t* rays) { return gather_.at_vertex(vertex, rays).irradiance; }, &rays_);
  malloc_trim(0);  // their rays and rows were many small things
  std::vector<uint32_t> level, vertices;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (is_uniform(mesh.elements[mesh.faces[f].element])) continue;
    level.push_back(mesh.faces[f].element);
    for (int c = 0; c < mesh.elements[level.back()].corner_count(); ++c)
      vertices.push_back(mesh.elements[level.back()].vertices[c]);
  }
  evaluate(vertices);
  visited_ = level;
  while (!level.empty()) {
    std::vector<uint32_t> split;
    vertices.clear();
    for (const uint32_t element : level) {
      const Element& e = mesh.elements[element];
      const double edge =
          std::max(length(mesh.vertices[e.vertices[1]].position - mesh.vertices[e.vertices[0]].position),
                   length(mesh.vertices[e.vertices[2]].position - mesh.vertices[e.vertices[1]].position));
      if (edge < options_.smallest_element) continue;
      if (e.first_child == kNone) builder_.split(element);
      split.push_back(element);
      uint32_t middles[5];
      const int count = builder_.middles(element, middles);
      vertices.insert(vertices.end(), middles, middles + count);
    }
    evaluate(vertices);
    std::vector<char> deeper(split.size());
    parallel_for(split.size(), 16, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) deeper[i] = worth_splitting(split[i]);
    });
    std::vector<uint32_t> next;
    for (size_t i = 0; i < split.size(); ++i)
      for (uint32_t c = 0; c < 4; ++c) {
        const uint32_t child = mesh.elements[split[i]].first_child + c;
        visited_.push_back(child);
        if (deeper[i]) next.push_back(child);
      }
    level = std::move(next);
  }
}

// A vertex inside another body sees nothing but its dark inside: give it what its free neighbours have, so
// that no dark cell shows at the foot of things. Those farther inside follow, for they may be parents of what
// is seen.
void IndirectPhase::fill_buried() {
  const Mesh& mesh = builder_.mesh();
  std::vector<uint32_t> blocked, rank(functions_.size(), kNone);
  for (uint32_t v = 0; v < functions_.size(); ++v) {
    if (functions_[v].open.empty()) continue;
    rank[v] = static_cast<uint32_t>(blocked.size());
    blocked.push_back(v);
  }
  std::vector<std::vector<uint32_t>> neighbours(blocked.size());
  for (const uint32_t element : visited_) {
    const Element& e = mesh.elements[element];
    const int n = e.corner_count();
    for (int i = 0; i < n; ++i) {
      const uint32_t a = e.vertices[i], b = e.vertices[(i + 1) % n];
      if (rank[a] != kNone) neighbours[rank[a]].push_back(b);
      if (rank[b] != kNone) neighbours[rank[b]].push_back(a);
    }
  }
  constexpr int kRounds = 16;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<VertexFunction> filled(blocked.size());
    parallel_for(blocked.size(), 8, [&](size_t begin, size_t end) {
      for (size_t b = begin; b < end; ++b) filled[b] = filled_from(blocked[b], neighbours[b]);
    });
    for (size_t b = 0; b < blocked.size(); ++b) functions_[blocked[b]] = std::move(filled[b]);
  }
}

IndirectPhase::VertexFunction IndirectPhase::filled_from(uint32_t vertex,
                                                         const std::vector<uint32_t>& neighbours) const {
  constexpr float kTrusted = 0.6f;  // from here on a view speaks for itself
  std::vector<Rgb> irradiance = functions_[vertex].irradiance.unpacked();
  std::vector<float> opens = functions_[vertex].open;
  for (size_t i = 0; i < irradiance.size(); ++i) {
    const float open = opens[i];
    if (open >= kTrusted) continue;
    Rgb sum;
    float weight = 0;
    for (const uint32_t n : neighbours) {
      if (functions_[n].irradiance.empty()) continue;
      const float w = std::max(0.0f, open_at(n, i) - 0.55f);
      sum += w * functions_[n].irradiance[i];
      weight += w;
    }
    if (!(weight > 0)) continue;
    const float own = std::clamp((open - 0.5f) / (kTrusted - 0.5f), 0.0f, 1.0f);
    irradiance[i] = own * irradiance[i] + ((1 - own) / weight) * sum;
    opens[i] = kTrusted;
  }
  return {TightFunction(irradiance), std::move(opens)};
}

Field IndirectPhase::surpluses() {
  const Mesh& mesh = builder_.mesh();
  functions_.resize(mesh.vertices.size());
  fill_buried();
  const std::vector<bool> hanging = builder_.hanging_vertices();
  Field field = std::move(uniform_);
  for (uint32_t v = builder_.uniform_count(); v < mesh.vertices.size(); ++v) {
    if (hanging[v]) functions_[v] = {};
    const TightFunction& own = functions_[v].irradiance;
    if (own.empty()) {
      if (parent_count(mesh.vertices[v]) == 0)
        functions_[v].irradiance = TightFunction(std::vector<Rgb>(grid_.node_count()));
      field.first_piece.push_back(static_cast<uint32_t>(field.pieces.size()));
      continue;
    }
    std::vector<Rgb> row = own.unpacked();
    if (parent_count(mesh.vertices[v]) > 0) {
      const std::vector<Rgb> mean = parents_mean(v);
      for (size_t i = 0; i < row.size(); ++i) row[i] = row[i] - mean[i];
    }
    append_row(grid_, row, {}, tolerance_of(builder_, v, options_.tolerance), &field);
  }
  return field;
}

}  // namespace strad
