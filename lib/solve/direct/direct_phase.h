// Direct light on the mesh, adaptive in space and time together.
//
// A vertex is evaluated only in the cells of time in which an element around it was worth splitting.
// Everywhere else its value is the mean of its parents' values. So where a spotlight sweeps over a wall, each
// fine vertex has values of its own only for the short time in which the edge of the beam passes.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "solve/direct/direct_over_time.h"
#include "solve/mesh/mesh_builder.h"
#include "time/field.h"
#include "time/sparse_function.h"
#include "time/time_grid.h"

namespace strad {

struct DirectOptions {
  double largest_element = 0.4;  // m: longer elements are always split
  double smallest_element = 0;   // m: shorter ones are never split
  float threshold = 0;  // split while surplus radiance * sqrt(area / total area) exceeds it, W / (sr m^2)
  float tolerance = 0;  // W / m^2: error of the functions that are kept
  int emitter_samples = 16;  // shadow rays per emitting polygon
};

class DirectPhase {
 public:
  // Keeps references. `instants`: one per time sample.
  DirectPhase(const Scene& scene, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept,
              const std::vector<Instant>& instants, const DirectOptions& options, MeshBuilder* builder);

  // Evaluates direct light on all faces of the builder, and splits their elements where it asks for it.
  void run();

  // Mean direct irradiance over an element at the time samples of some cells (ascending).
  std::vector<Rgb> mean_irradiance(uint32_t element, const std::vector<uint32_t>& cells) const;

  // Surpluses (see MeshVertex) of every vertex that the builder's mesh has now, with an error of about the
  // tolerance. Frees the values: mean_irradiance() must not be called afterwards.
  Field take_surpluses();

  uint64_t evaluations() const { return evaluations_; }
  uint64_t rays() const { return rays_; }

 private:
  struct Work {
    uint32_t element;
    std::vector<uint32_t> cells;  // of time, in which it is to be split
  };
  // At a vertex, one value per time sample asked for.
  std::vector<Rgb> irradiance(uint32_t vertex, const std::vector<uint32_t>& time_samples,
                              uint64_t* rays) const;
  void evaluate(const std::vector<uint32_t>& vertices, const std::vector<std::vector<uint32_t>>& cells);
  std::vector<Work> split(const std::vector<Work>& level);
  std::vector<uint32_t> worthwhile_cells(const Work& work) const;
  // Values of a vertex at the time samples of a cell: its own, or the means of its parents' values.
  void value(uint32_t vertex, uint32_t cell, Rgb* values) const;

  const Scene& scene_;
  const TimeGrid& grid_;
  DirectOptions options_;
  MeshBuilder& builder_;
  DirectOverTime light_;
  double total_area_ = 0;
  std::vector<SparseFunction> functions_;           // [vertex]
  std::vector<std::vector<uint32_t>> split_cells_;  // [element]
  Field undivided_rows_;                            // of the vertices of undivided faces
  uint64_t evaluations_ = 0, rays_ = 0;
};

}  // namespace strad
