#include "frame/reconstruction.h"

#include <algorithm>

namespace strad {
Reconstruction::Reconstruction(const Mesh& mesh) : mesh_(mesh) {
  middles_.reserve(mesh.vertices.size());
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const uint32_t* parents = mesh.vertices[v].parents;
    if (parents[1] != kNone && parents[2] == kNone) middles_.emplace(edge_key(parents[0], parents[1]), v);
  }
  edge_middles_.assign(4 * mesh.elements.size(), kNone);
  hanging_.assign(mesh.elements.size(), false);
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (element.first_child != kNone || is_uniform(element)) continue;
    const int count = element.corner_count();
    for (int k = 0; k < count; ++k) {
      const uint32_t middle = middle_of(element.vertices[k], element.vertices[(k + 1) % count]);
      edge_middles_[4 * e + static_cast<size_t>(k)] = middle;
      if (middle != kNone) hanging_[e] = true;
    }
  }
}

uint32_t Reconstruction::middle_of(uint32_t a, uint32_t b) const {
  const auto found = middles_.find(edge_key(a, b));
  return found == middles_.end() ? kNone : found->second;
}

// The deviation at s along the edge from a to b: the value interpolated between all vertices on the edge,
// minus the value interpolated between a and b.
template <typename Add>
void Reconstruction::visit_deviation(uint32_t a, uint32_t b, uint32_t middle, double s, double scale,
                                     const Add& add) const {
  add(a, static_cast<float>(-scale * (1 - s)));
  add(b, static_cast<float>(-scale * s));
  for (; middle != kNone; middle = middle_of(a, b)) {
    const bool second_half = s >= 0.5;
    (second_half ? a : b) = middle;
    s = 2 * s - second_half;
  }
  add(a, static_cast<float>(scale * (1 - s)));
  add(b, static_cast<float>(scale * s));
}

template <typename Add>
void Reconstruction::visit(uint32_t face, Vec2 uv, const Add& add) const {
  const MeshPoint point = locate(mesh_, face, uv);
  const float* w = point.weights;
  const int count = mesh_.elements[point.element].corner_count();
  for (int i = 0; i < count; ++i) add(point.vertices[i], w[i]);
  if (!hanging_[point.element]) return;
  for (int k = 0; k < count; ++k) {
    const uint32_t middle = edge_middles_[4 * size_t{point.element} + static_cast<size_t>(k)];
    if (middle == kNone) continue;
    const int next = (k + 1) % count;
    // `near` is 1 on the edge and 0 at the opposite edge or corner. On a quad, the position along the edge is
    // the sum of the weights of its end and of the corner next to that.
    const double near = w[k] + w[next];
    const double s = count == 4 ? w[next] + w[(k + 2) % 4] : near > 0 ? w[next] / near : 0;
    visit_deviation(point.vertices[k], point.vertices[next], middle, std::clamp(s, 0.0, 1.0), near, add);
  }
}

Rgb Reconstruction::smooth(const std::vector<Rgb>& values, uint32_t face, Vec2 uv) const {
  Rgb sum;
  visit(face, uv, [&](uint32_t vertex, float weight) { sum += weight * values[vertex]; });
  return sum;
}

std::vector<VertexWeight> Reconstruction::smooth_sources(uint32_t face, Vec2 uv) const {
  std::vector<VertexWeight> sources;
  visit(face, uv, [&](uint32_t vertex, float weight) { sources.push_back({vertex, weight}); });
  return sources;
}

std::vector<VertexWeight> Reconstruction::flat_sources(uint32_t face, Vec2 uv) const {
  const Element& leaf = mesh_.elements[locate(mesh_, face, uv).element];
  const int count = leaf.corner_count();
  std::vector<VertexWeight> sources;
  for (int i = 0; i < count; ++i) sources.push_back({leaf.vertices[i], 1 / static_cast<float>(count)});
  return sources;
}

Rgb Reconstruction::flat(const std::vector<Rgb>& values, uint32_t face, Vec2 uv, uint32_t* leaf) const {
  *leaf = locate(mesh_, face, uv).element;
  Rgb sum;
  for (const VertexWeight& source : flat_sources(face, uv)) sum += source.weight * values[source.vertex];
  return sum;
}

}  // namespace strad
