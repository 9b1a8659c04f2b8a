// What strad-solve adds to the stream, and how it is read at an instant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/rgb.h"
#include "scene/scene.h"
#include "solution/mesh.h"
#include "time/field.h"
#include "time/time_grid.h"

namespace strad {

// The light of a slab of time. Irradiances are those received on the side of the face, W / m^2.
struct Slab {
  TimeGrid grid;
  Mesh mesh;
  Field direct;    // surpluses of irradiance straight from spots and emitters
  Field indirect;  // surpluses of irradiance reflected at least once
  // Exponent of the quantum that a stream had it in (light_code.h), so that it is written as it was read.
  std::optional<int> quantum;
};

// Slabs in order of time, adjacent: slab i ends where slab i + 1 begins.
struct Solution {
  std::vector<Slab> slabs;
};

inline double slab_begin(const Slab& slab) { return slab.grid.spans.front().begin; }
inline double slab_end(const Slab& slab) { return slab.grid.spans.back().end; }
// The slab that holds `time`, clamped. REQUIRES: at least one slab.
uint32_t slab_at(const Solution& solution, double time);

// Which light to read: frames that compute direct light by shadow rays need only the indirect light.
enum class LightParts : uint8_t { kAll, kIndirect };

// Irradiance at every vertex of a slab's mesh: full values, not surpluses. Never negative.
struct VertexLight {
  std::vector<Rgb> direct, indirect;  // W / m^2; direct is empty with LightParts::kIndirect
};
VertexLight light_at(const Slab& slab, double time, bool continuous = true,
                     LightParts parts = LightParts::kAll);
// The mean over [begin, end]: motion blur of light, in closed form.
VertexLight light_over(const Slab& slab, double begin, double end, bool continuous = true,
                       LightParts parts = LightParts::kAll);

// Irradiance at one mesh point over time, without evaluating the other vertices.
Rgb direct_at(const Slab& slab, const MeshPoint& point, double time, bool continuous = true);
Rgb indirect_at(const Slab& slab, const MeshPoint& point, double time, bool continuous = true);

// Throws BadInput unless every index is in range, parents precede children, and pieces are ordered and
// finite.
void validate(const Scene& scene, const Solution& solution);

}  // namespace strad
