// Indirect light on the mesh: a final gather at its vertices, split where interpolation is not exact enough.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "solve/gather/final_gather.h"
#include "solve/mesh/mesh_builder.h"
#include "time/field.h"
#include "time/scaled_function.h"
#include "time/time_grid.h"

namespace strad {

struct IndirectOptions {
  double largest_element = 0.8;    // m
  double smallest_element = 0.05;  // m
  float tolerance = 0;             // W / m^2: of the functions that are kept
  float threshold = 0;  // split while surplus radiance * sqrt(area / total area) exceeds it, W / (sr m^2)
  // W / m^2: what is darker than `bright` counts relative to its own irradiance, or to `dark` if that is
  // more.
  float bright = 0, dark = 0;
};

class IndirectPhase {
 public:
  // Keeps references.
  IndirectPhase(const Scene& scene, const TimeGrid& grid, const FinalGather& gather,
                const IndirectOptions& options, MeshBuilder* builder);

  void run();

  // Surpluses of every vertex of the builder's mesh as it is now, with an error about the tolerance.
  Field take_surpluses();

  uint64_t rays() const { return rays_; }

 private:
  using VertexFunction = Gathered<CoarseFunction>;  // a third of the memory
  void evaluate(const std::vector<uint32_t>& vertices);
  bool worth_splitting(uint32_t element) const;
  bool is_partly_blocked(uint32_t element) const;
  float brightest_at_corners(uint32_t element) const;
  void fill_blocked_vertices();
  std::vector<std::vector<Rgb>> gather_undivided_face(uint32_t face, uint64_t* rays) const;
  VertexFunction filled_from(uint32_t vertex, const std::vector<uint32_t>& neighbours) const;
  float weight_of(Rgb irradiance) const;
  float tolerance_for(uint32_t vertex, const std::vector<Rgb>& irradiance) const;
  std::vector<Rgb> parents_mean(uint32_t vertex) const;
  std::vector<uint32_t> last_users_of_functions() const;

  const Scene& scene_;
  const TimeGrid& grid_;
  const FinalGather& gather_;
  IndirectOptions options_;
  MeshBuilder& builder_;
  double total_area_ = 0;
  std::vector<VertexFunction> functions_;  // [vertex]; empty where none was asked for
  std::vector<uint32_t> visited_;          // elements whose corners have functions
  Field undivided_rows_;                   // of the vertices of undivided faces
  uint64_t rays_ = 0;
};

}  // namespace strad
