// The space-time solve: light transport for a whole animation at once.
#pragma once

#include <optional>

#include "base/progress.h"
#include "scene/scene.h"
#include "solution/slab_work.h"
#include "solution/solution.h"

namespace strad {

struct SolveOptions {
  double error = 0.02;          // tolerated error, fraction of the scene's mean radiance, > 0
  int order = 3;                // temporal basis M_order: 1 constant (Haar), 2 linear, 3 quadratic
  std::optional<double> begin;  // s: solve only [begin, end]
  std::optional<double> end;
  std::optional<double> instant;  // s: solve this one date
  bool clusters = true;           // false: links between surfaces only
  double residual = 1e-4;         // iterate until the largest change of mean radiance falls below, relative
};

struct PhaseStats {
  double cpu_seconds = 0, wall_seconds = 0;
  uint64_t links = 0, links_refined_in_time = 0, links_refined_in_space = 0;
  uint64_t kernel_evaluations = 0;
  uint64_t rays = 0;
};

struct SolveStats {
  PhaseStats direct, indirect, total;
  uint64_t elements = 0, vertices = 0, clusters = 0, coefficients = 0;
  uint64_t peak_bytes = 0;  // resident, of the process
  uint64_t link_bytes = 0, mesh_bytes = 0, function_bytes = 0;
  int iterations = 0;
  double residual = 0;
};

// Throws BadInput for options out of range. Equal input gives equal results for any number of threads.
Slab solve(const Scene& scene, const SolveOptions& options, SolveStats* stats = nullptr,
           const Progress& progress = {});

// What is told of the solve along with its slab.
SlabWork work_of(const Slab& slab, const SolveStats& stats);

}  // namespace strad
