#include "frame/reconstruction.h"

#include <algorithm>

namespace strad {
namespace {

uint64_t edge_key(uint32_t a, uint32_t b) { return uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

Rgb mix(Rgb a, Rgb b, double s) { return static_cast<float>(1 - s) * a + static_cast<float>(s) * b; }

}  // namespace

Reconstruction::Reconstruction(const Mesh& mesh) : mesh_(mesh) {
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const uint32_t* parents = mesh.vertices[v].parents;
    if (parents[1] != kNone && parents[2] == kNone) middles_.emplace(edge_key(parents[0], parents[1]), v);
  }
  edge_middles_.assign(4 * mesh.elements.size(), kNone);
  hanging_.assign(mesh.elements.size(), false);
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (element.first_child != kNone) continue;
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

// At s along the edge from a to b: the broken line through all vertices on it, less the straight one.
Rgb Reconstruction::deviation(const std::vector<Rgb>& values, uint32_t a, uint32_t b, uint32_t middle,
                              double s) const {
  const Rgb straight = mix(values[a], values[b], s);
  for (; middle != kNone; middle = middle_of(a, b)) {
    const bool second_half = s >= 0.5;
    (second_half ? a : b) = middle;
    s = 2 * s - second_half;
  }
  return mix(values[a], values[b], s) - straight;
}

Rgb Reconstruction::smooth(const std::vector<Rgb>& values, uint32_t face, Vec2 uv) const {
  const MeshPoint point = locate(mesh_, face, uv);
  Rgb sum;
  for (int i = 0; i < 4 && point.vertices[i] != kNone; ++i)
    sum += point.weights[i] * values[point.vertices[i]];
  if (!hanging_[point.element]) return sum;
  const float* w = point.weights;
  const int count = mesh_.elements[point.element].corner_count();
  for (int k = 0; k < count; ++k) {
    const uint32_t middle = edge_middles_[4 * size_t{point.element} + static_cast<size_t>(k)];
    if (middle == kNone) continue;
    const int next = (k + 1) % count;
    // How near the edge: 1 on it, 0 at the opposite edge or corner. On quads the edge's own position is found
    // by joining each end's weight with that of the corner across.
    const double near = w[k] + w[next];
    const double s = count == 4 ? w[next] + w[(k + 2) % 4] : near > 0 ? w[next] / near : 0;
    const Rgb extra =
        deviation(values, point.vertices[k], point.vertices[next], middle, std::clamp(s, 0.0, 1.0));
    sum += static_cast<float>(near) * extra;
  }
  return sum;
}

Rgb Reconstruction::flat(const std::vector<Rgb>& values, uint32_t face, Vec2 uv, uint32_t* leaf) const {
  *leaf = locate(mesh_, face, uv).element;
  const Element& element = mesh_.elements[*leaf];
  const int count = element.corner_count();
  Rgb sum;
  for (int i = 0; i < count; ++i) sum += values[element.vertices[i]];
  return (1 / static_cast<float>(count)) * sum;
}

}  // namespace strad
