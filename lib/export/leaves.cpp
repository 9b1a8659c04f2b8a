#include "export/leaves.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

constexpr int kInstants = 8;  // at which the mean irradiance and the twist of quads are measured
// Tolerances as fractions of the mean irradiance over all surfaces and instants. Pictures differ by 0.1 to
// 0.2 % from those with all leaves.
constexpr float kSurplus = 0.01f;  // a vertex that differs less from the mean of its parents is left out
constexpr float kTwist = 0.01f;    // tolerated error in the middle of a quad

float largest(Rgb a) { return max_channel({std::abs(a.r), std::abs(a.g), std::abs(a.b)}); }

// Adds the largest surplus over time of each vertex: how far it differs from the mean of its parents.
void add_surplus(const Field& field, std::vector<float>* surplus) {
  const auto order = static_cast<uint32_t>(field.order);
  for (uint32_t v = 0; v < field.row_count(); ++v) {
    float most = 0;
    for (uint32_t c = field.first_piece[v] * order; c < field.first_piece[v + 1] * order; ++c) {
      most = std::max(most, largest(field.coefficients[c]));
    }
    (*surplus)[v] += most;
  }
}

double area_of(const Mesh& mesh, const Element& e) {
  const auto at = [&](int i) { return mesh.vertices[e.vertices[i]].position; };
  const Vec3 doubled =
      e.corner_count() == 3 ? cross(at(1) - at(0), at(2) - at(0)) : cross(at(2) - at(0), at(3) - at(1));
  return length(doubled) / 2;
}

// The mean over the area of all leaves, of the largest channel.
float mean_irradiance(const Mesh& mesh, const VertexLight& light) {
  double sum = 0, area = 0;
  for (const Element& e : mesh.elements) {
    if (e.first_child != kNone) continue;
    Rgb corners;
    for (int i = 0; i < e.corner_count(); ++i)
      corners += light.direct[e.vertices[i]] + light.indirect[e.vertices[i]];
    sum += area_of(mesh, e) * max_channel(corners) / e.corner_count();
    area += area_of(mesh, e);
  }
  return area > 0 ? static_cast<float>(sum / area) : 0;
}

}  // namespace

ExportLeaves::ExportLeaves(const Slab& slab, ExportLight light)
    : mesh_(slab.mesh),
      split_(mesh_.elements.size(), false),
      twisted_(mesh_.elements.size(), false),
      users_(mesh_.vertices.size(), 0) {
  std::vector<VertexLight> lights;
  float mean = 0;
  for (int i = 0; i < kInstants; ++i) {
    const double s = (i + 0.5) / kInstants;
    lights.push_back(light_at(slab, slab_begin(slab) + s * (slab_end(slab) - slab_begin(slab))));
    mean += mean_irradiance(mesh_, lights.back()) / kInstants;
  }
  std::vector<float> surplus(mesh_.vertices.size(), 0.0f);
  add_surplus(slab.indirect, &surplus);
  if (light == ExportLight::kAll) add_surplus(slab.direct, &surplus);
  mark_split(surplus, kSurplus * mean);
  for (const Face& face : mesh_.faces) mark_used(face.element);
  for (const VertexLight& at : lights) {
    mark_twisted(at.indirect, kTwist * mean);
    if (light == ExportLight::kAll) mark_twisted(at.direct, kTwist * mean);
  }
}

// An element stays split if one of the vertices added by its split has a surplus above the tolerance, or if
// one of its children stays split. Children have higher indices than their parents.
void ExportLeaves::mark_split(const std::vector<float>& surplus, float tolerance) {
  for (size_t e = mesh_.elements.size(); e-- > 0;) {
    const uint32_t children = mesh_.elements[e].first_child;
    if (children == kNone) continue;
    bool matters = false;
    for (uint32_t c = children; c < children + 4; ++c) {
      matters = matters || split_[c];
      for (int i = 0; i < mesh_.elements[c].corner_count(); ++i) {
        const uint32_t v = mesh_.elements[c].vertices[i];
        const uint32_t* own = mesh_.elements[e].vertices;
        matters = matters || (surplus[v] > tolerance && std::find(own, own + 4, v) == own + 4);
      }
    }
    split_[e] = matters;
  }
}

// Counts the exported leaves at each vertex, and notes which of their vertices are middles of edges.
void ExportLeaves::mark_used(uint32_t element) {
  const Element& e = mesh_.elements[element];
  if (split_[element]) {
    for (uint32_t c = 0; c < 4; ++c) mark_used(e.first_child + c);
    return;
  }
  for (int i = 0; i < e.corner_count(); ++i) {
    ++users_[e.vertices[i]];
    const uint32_t* parents = mesh_.vertices[e.vertices[i]].parents;
    if (parents[0] != kNone && parents[2] == kNone) {
      middle_of_edge_.try_emplace(edge_key(parents[0], parents[1]), e.vertices[i]);
    }
  }
}

void ExportLeaves::mark_twisted(const std::vector<Rgb>& irradiance, float tolerance) {
  for (size_t e = 0; e < mesh_.elements.size(); ++e) {
    if (split_[e] || twisted_[e] || mesh_.elements[e].corner_count() == 3) continue;
    const uint32_t* v = mesh_.elements[e].vertices;
    const Rgb twist = irradiance[v[0]] - irradiance[v[1]] + irradiance[v[2]] - irradiance[v[3]];
    twisted_[e] = largest(twist) / 4 > tolerance;
  }
}

bool ExportLeaves::alone(uint32_t element) const {
  const Element& e = mesh_.elements[element];
  return std::all_of(e.vertices, e.vertices + e.corner_count(), [&](uint32_t v) { return users_[v] == 1; });
}

std::vector<uint32_t> ExportLeaves::outline(uint32_t element) const {
  std::vector<uint32_t> vertices;
  const Element& leaf = mesh_.elements[element];
  const int n = leaf.corner_count();
  for (int i = 0; i < n; ++i) add_edge(leaf.vertices[i], leaf.vertices[(i + 1) % n], &vertices);
  return vertices;
}

// Appends the vertices on the edge from a to b: a and those between, not b.
void ExportLeaves::add_edge(uint32_t a, uint32_t b, std::vector<uint32_t>* vertices) const {
  const auto middle = middle_of_edge_.find(edge_key(a, b));
  if (middle == middle_of_edge_.end()) return vertices->push_back(a);
  add_edge(a, middle->second, vertices);
  add_edge(middle->second, b, vertices);
}

}  // namespace strad
