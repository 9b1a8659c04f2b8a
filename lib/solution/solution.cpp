// Irradiance of a solution at an instant or over a stretch of time.
#include "solution/solution.h"

#include <algorithm>
#include <functional>
#include <map>

#include "base/parallel.h"

namespace strad {
namespace {

constexpr size_t kRowGrain = 1024;  // rows a task, enough to outweigh its start

using RowValue = std::function<Rgb(const Field&, uint32_t row)>;

// A polynomial that answers a step, a shadow's edge, may undershoot; light does not.
Rgb lit(Rgb v) { return {std::max(0.0f, v.r), std::max(0.0f, v.g), std::max(0.0f, v.b)}; }

// Values from surpluses, in place. Parents come before their children.
void add_parents(const Mesh& mesh, std::vector<Rgb>* values) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    const uint32_t* parents = mesh.vertices[v].parents;
    if (parents[0] == kNone) continue;
    Rgb sum = (*values)[parents[0]] + (*values)[parents[1]];
    if (parents[2] != kNone) sum = 0.5f * (sum + (*values)[parents[2]] + (*values)[parents[3]]);
    (*values)[v] += 0.5f * sum;
  }
}

std::vector<Rgb> vertex_values(const Mesh& mesh, const Field& field, const RowValue& value) {
  std::vector<Rgb> values(mesh.vertices.size());
  parallel_for(values.size(), kRowGrain, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) values[v] = value(field, static_cast<uint32_t>(v));
  });
  add_parents(mesh, &values);
  for (Rgb& v : values) v = lit(v);
  return values;
}

VertexLight vertex_light(const Slab& slab, LightParts parts, const RowValue& value) {
  VertexLight light;
  if (parts == LightParts::kAll) light.direct = vertex_values(slab.mesh, slab.direct, value);
  light.indirect = vertex_values(slab.mesh, slab.indirect, value);
  return light;
}

// A vertex's value in terms of surpluses: its own, those of its parents, and so on, each once. The vertex of
// highest index has no children left, so its weight is complete when it is taken.
Rgb vertex_value(const Slab& slab, const Field& field, uint32_t of, double time, bool continuous) {
  std::map<uint32_t, float, std::greater<>> weight_of{{of, 1.0f}};
  Rgb sum;
  while (!weight_of.empty()) {
    const auto [vertex, weight] = *weight_of.begin();
    weight_of.erase(weight_of.begin());
    sum += weight * value_at(slab.grid, field, vertex, time, continuous);
    const uint32_t* parents = slab.mesh.vertices[vertex].parents;
    const int count = parents[0] == kNone ? 0 : parents[2] == kNone ? 2 : 4;
    for (int i = 0; i < count; ++i) weight_of[parents[i]] += weight / static_cast<float>(count);
  }
  return lit(sum);
}

Rgb value_in(const Slab& slab, const Field& field, const MeshPoint& point, double time, bool continuous) {
  Rgb sum;
  for (int i = 0; i < 4; ++i)
    if (point.vertices[i] != kNone && point.weights[i] != 0)
      sum += point.weights[i] * vertex_value(slab, field, point.vertices[i], time, continuous);
  return sum;
}

}  // namespace

uint32_t slab_at(const Solution& solution, double time) {
  uint32_t i = 0;
  while (i + 1 < solution.slabs.size() && time >= slab_end(solution.slabs[i])) ++i;
  return i;
}

VertexLight light_at(const Slab& slab, double time, bool continuous, LightParts parts) {
  const RowValue value = [&](const Field& field, uint32_t row) {
    return value_at(slab.grid, field, row, time, continuous);
  };
  return vertex_light(slab, parts, value);
}

VertexLight light_over(const Slab& slab, double begin, double end, bool continuous, LightParts parts) {
  const RowValue value = [&](const Field& field, uint32_t row) {
    return mean_over(slab.grid, field, row, begin, end, continuous);
  };
  return vertex_light(slab, parts, value);
}

Rgb direct_at(const Slab& slab, const MeshPoint& point, double time, bool continuous) {
  return value_in(slab, slab.direct, point, time, continuous);
}

Rgb indirect_at(const Slab& slab, const MeshPoint& point, double time, bool continuous) {
  return value_in(slab, slab.indirect, point, time, continuous);
}

}  // namespace strad
