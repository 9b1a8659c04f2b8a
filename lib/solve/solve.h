// The space-time solve: light transport for a whole animation at once.
#pragma once

#include <functional>
#include <optional>

#include "base/progress.h"
#include "scene/scene.h"
#include "solution/slab_work.h"
#include "solution/solution.h"
#include "solve/stats.h"

namespace strad {

class NodeTree;
struct LinkTable;

struct SolveOptions {
  double error = 0.02;  // tolerated error, fraction of the scene's mean radiance, > 0
  // Errors count relative to the light that is there, down to this share of what is bright; 1: all alike.
  double dark = 1e-4;
  int order = 3;                // temporal basis M_order: 1 constant (Haar), 2 linear, 3 quadratic
  std::optional<double> begin;  // s: solve only [begin, end]
  std::optional<double> end;
  std::optional<double> instant;  // s: solve only this instant
  bool clusters = true;           // false: links between surfaces only
  double residual = 1e-4;         // iterate until the largest change of mean radiance falls below, relative
  // Shown the links once they are final, before light is sent along them. May be empty.
  std::function<void(const NodeTree&, const LinkTable&)> look_at_links;
};

// `scene` is the scene that was solved: the given one with polygons cut under walls (cut_under_walls).
struct Solved {
  Scene scene;
  Slab slab;
  SlabWork work;
  SolveStats stats;
};

// Throws BadInput for options out of range. Equal input gives equal results for any number of threads.
Solved solve(Scene scene, const SolveOptions& options, const Progress& progress = {});

}  // namespace strad
