// What a solve did and cost, phase by phase.
#pragma once

#include <cstdint>

namespace strad {

struct PhaseStats {
  double cpu_seconds = 0, wall_seconds = 0;
  uint64_t links = 0, links_refined_in_time = 0, links_refined_in_space = 0;
  uint64_t kernel_evaluations = 0;  // of a link's kernel, or of direct light at a vertex and time sample
  uint64_t rays = 0;
};

struct SolveStats {
  PhaseStats prepare, direct, links, bounces, gather;
  PhaseStats indirect;  // links, bounces and gather
  PhaseStats total;
  uint64_t elements = 0, vertices = 0, clusters = 0, coefficients = 0;
  uint64_t peak_bytes = 0;  // resident, of the process
  uint64_t link_bytes = 0, mesh_bytes = 0, function_bytes = 0;
  int iterations = 0;   // of propagation along links
  double residual = 0;  // of the last one
};

// The sum of two phases' work and cost.
PhaseStats operator+(PhaseStats a, const PhaseStats& b);

}  // namespace strad
