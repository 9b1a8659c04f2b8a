// Direct light on the mesh, adaptive in space and time together.
//
// A vertex is evaluated only in the cells of time in which an element around it was worth splitting;
// everywhere else its value is the mean of its parents' values. So a spot that sweeps a wall leaves fine
// vertices that are alive for a moment each.
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
  double largest_element = 0.4;  // m: elements that light may reach are split down to this
  double smallest_element = 0;   // m
  float threshold = 0;  // split while surplus radiance * sqrt(area / total area) exceeds it, W / (sr m^2)
  float tolerance = 0;  // W / m^2: of the functions that are kept
  int emitter_samples = 16;  // shadow rays per emitting polygon
};

class DirectPhase {
 public:
  // Keeps references. `instants`: one per time sample.
  DirectPhase(const Scene& scene, const Tracer& tracer, const TimeGrid& grid, const SweptBounds& swept,
              const std::vector<Instant>& instants, const DirectOptions& options, MeshBuilder* builder);

  // Refines all faces that the builder holds.
  void run();

  // Mean direct irradiance over an element at the nodes of some cells (ascending).
  std::vector<Rgb> mean_irradiance(uint32_t element, const std::vector<uint32_t>& cells) const;

  // Surpluses of every vertex of the builder's mesh as it is now, with an error about the tolerance. Gives
  // back the memory of the values.
  Field take_surpluses();

  uint64_t evaluations() const { return evaluations_; }
  uint64_t rays() const { return rays_; }

 private:
  struct Work {
    uint32_t element;
    std::vector<uint32_t> cells;  // in which it is to be split
  };
  // At a vertex and time samples.
  std::vector<Rgb> irradiance(uint32_t vertex, const std::vector<uint32_t>& nodes, uint64_t* rays) const;
  void evaluate(const std::vector<uint32_t>& vertices, const std::vector<std::vector<uint32_t>>& cells);
  std::vector<Work> split(const std::vector<Work>& level);
  std::vector<uint32_t> worthwhile_cells(const Work& work) const;
  // Value of a vertex at the nodes of a cell: its own, or the mean of its parents'.
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
