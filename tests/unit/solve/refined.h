// A scene whose links are refined, for tests.
#pragma once

#include <memory>
#include <vector>

#include "solve/direct/direct_phase.h"
#include "solve/links/refinement.h"
#include "workbench.h"

namespace strad {

struct Refined {
  Workbench bench;
  std::unique_ptr<DirectPhase> direct;
  std::unique_ptr<Refinement> refinement;
  std::vector<uint32_t> probe_samples{3, 11, 20, 29};

  Refined(Scene scene, Roots roots, std::initializer_list<double> thresholds, double uniform_below = 0)
      : bench(std::move(scene), 2, 16, roots, uniform_below) {
    DirectOptions options;
    options.threshold = 0.01f, options.smallest_element = 0.1;
    direct = std::make_unique<DirectPhase>(bench.scene, bench.tracer, bench.grid, bench.swept, bench.instants,
                                           options, &bench.builder);
    direct->run();
    bench.plant(roots);
    refinement =
        std::make_unique<Refinement>(bench.grid, *bench.kernels, *direct, probe_samples, bench.nodes.get());
    for (const double threshold : thresholds) refine(threshold);
  }
  // `smallest`: m, radius of nodes that are still split.
  void refine(double threshold, double smallest = 0.1) {
    RefinementOptions options;
    options.threshold = threshold, options.smallest_radius = smallest;
    refinement->refine(options);
  }
  // As if all surfaces reflected `radiance` at all time samples.
  void light_all(float radiance) {
    const size_t count = bench.nodes->slot_count() * probe_samples.size();
    const Rgb colour{radiance, radiance, radiance};
    NodeLight light;
    light.radiance.assign(count, colour);
    light.irradiance.assign(count, static_cast<float>(kPi) * colour);
    refinement->update_light(0, probe_samples.size(), light);
  }
  const std::vector<Link>& links() const { return refinement->links(); }
};

}  // namespace strad
