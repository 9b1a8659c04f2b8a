// Irradiance of a solution at an instant or over a stretch of time.
#include "solution/solution.h"

#include <algorithm>
#include <functional>
#include <map>

#include "base/parallel.h"

namespace strad {
namespace {

constexpr size_t kRowGrain = 1024;  // rows per task, enough to outweigh the cost of starting it

using RowValue = std::function<Rgb(const Field&, uint32_t row)>;

// Near a step of light, such as the edge of a shadow, a polynomial may fall below 0.
Rgb not_negative(Rgb v) { return {std::max(0.0f, v.r), std::max(0.0f, v.g), std::max(0.0f, v.b)}; }

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
  for (Rgb& v : values) v = not_negative(v);
  return values;
}

VertexLight vertex_light(const Slab& slab, LightParts parts, const RowValue& value) {
  VertexLight light;
  if (parts == LightParts::kAll) light.direct = vertex_values(slab.mesh, slab.direct, value);
  light.indirect = vertex_values(slab.mesh, slab.indirect, value);
  return light;
}

// The value of a vertex: its own surplus, plus those of its parents, of their parents and so on, each
// weighted. The vertex with the highest index is taken next: all its children are done, so its weight is
// complete.
Rgb vertex_value(const Slab& slab, const Field& field, uint32_t of, double time, bool continuous) {
  std::map<uint32_t, float, std::greater<>> weight_of{{of, 1.0f}};
  Rgb sum;
  while (!weight_of.empty()) {
    const auto [vertex, weight] = *weight_of.begin();
    weight_of.erase(weight_of.begin());
    sum += weight * value_at(slab.grid, field, vertex, time, continuous);
    const MeshVertex& v = slab.mesh.vertices[vertex];
    const int count = v.parent_count();
    for (int i = 0; i < count; ++i) weight_of[v.parents[i]] += weight / static_cast<float>(count);
  }
  return not_negative(sum);
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
