#include "solve/solve.h"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "base/error.h"
#include "solve/direct/direct_phase.h"
#include "solve/gather/final_gather.h"
#include "solve/gather/indirect_phase.h"
#include "solve/gather/leaf_light.h"
#include "solve/links/link_light.h"
#include "solve/prepare/mean_reflectance.h"
#include "solve/prepare/power.h"
#include "solve/prepare/reach.h"

namespace strad {
namespace {

// Of a vertex: at the default error its noise is below 1 %, of a small face 3 %, fixed in time; who tolerates
// more gets fewer rays, down to half.
int rays_for(double error) { return static_cast<int>(512 * std::clamp(std::sqrt(0.02 / error), 0.5, 1.0)); }

// Nodes of the grid for the whole animation: one for every 3.2 frames, at least 24.
int sample_count(const Scene& scene, double begin, double end) {
  return static_cast<int>(std::max(24.0, (end - begin) * scene.rate / 3.2));
}

TimeGrid grid_for(const Scene& scene, const SolveOptions& options) {
  if (options.instant) return instant_grid(*options.instant);
  const double begin = options.begin.value_or(scene.start), end = options.end.value_or(scene.end);
  std::vector<double> steps;
  for (const double t : step_times(scene))
    if (t > begin && t < end) steps.push_back(t);
  return make_time_grid(begin, end, steps, options.order, sample_count(scene, begin, end));
}

// Seconds since it was made.
struct Stopwatch {
  double cpu_start = cpu_now(), wall_start = wall_now();
  static double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
  static double wall_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  void into(PhaseStats* stats) const {
    stats->cpu_seconds = cpu_now() - cpu_start;
    stats->wall_seconds = wall_now() - wall_start;
  }
};

// Direct light: every face split where it varies. `mean`: mean radiance to expect.
DirectOptions direct_options(double diagonal, double error, double mean, float tolerance) {
  DirectOptions options;
  options.largest_element = diagonal / 24;
  options.smallest_element = diagonal / 600;
  // Some thousands of elements are alive at an instant, and their squared errors add up.
  options.threshold = static_cast<float>(error * mean / 5);
  options.tolerance = tolerance;
  return options;
}

IndirectOptions indirect_options(double diagonal, double error, double mean, float tolerance) {
  IndirectOptions options;
  options.largest_element = diagonal / 12;
  options.smallest_element = diagonal / 100;
  options.smoothed_up_to = diagonal / 20;
  options.threshold = static_cast<float>(error * mean / 8);
  options.tolerance = tolerance;
  return options;
}

// Throws BadInput for what cannot be meant.
void check(const Scene& scene, const SolveOptions& options) {
  const auto within = [&](double time, const char* what) {
    if (!(time >= scene.start && time <= scene.end))
      throw BadInput(std::string(what) + ": found " + std::to_string(time) +
                     " s, expected a time in the animation, " + std::to_string(scene.start) + " to " +
                     std::to_string(scene.end) + " s");
  };
  if (!(options.error > 0) || !std::isfinite(options.error))
    throw BadInput("error: found " + std::to_string(options.error) + ", expected a number above 0");
  if (options.order < 1 || options.order > kMaxOrder)
    throw BadInput("basis: found order " + std::to_string(options.order) + ", expected 1 to 3");
  if (options.instant && (options.begin || options.end))
    throw BadInput("an instant or a slab of time, not both");
  if (options.instant) within(*options.instant, "instant");
  if (options.begin) within(*options.begin, "begin");
  if (options.end) within(*options.end, "end");
  if (options.begin.value_or(scene.start) > options.end.value_or(scene.end))
    throw BadInput("the slab of time ends before it begins");
}

void measure(const Slab& slab, SolveStats* stats) {
  const auto bytes_of = [](const Field& field) {
    return field.pieces.size() * sizeof(Interval) + field.coefficients.size() * sizeof(Rgb) +
           field.first_piece.size() * sizeof(uint32_t);
  };
  stats->total.links = stats->indirect.links;
  stats->total.links_refined_in_time = stats->indirect.links_refined_in_time;
  stats->total.links_refined_in_space = stats->indirect.links_refined_in_space;
  stats->total.kernel_evaluations = stats->direct.kernel_evaluations + stats->indirect.kernel_evaluations;
  stats->total.rays = stats->direct.rays + stats->indirect.rays;
  stats->elements = slab.mesh.elements.size();
  stats->vertices = slab.mesh.vertices.size();
  stats->coefficients = 3 * (slab.direct.coefficients.size() + slab.indirect.coefficients.size());
  stats->mesh_bytes =
      slab.mesh.vertices.size() * sizeof(MeshVertex) + slab.mesh.elements.size() * sizeof(Element);
  stats->function_bytes = bytes_of(slab.direct) + bytes_of(slab.indirect);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  stats->peak_bytes = static_cast<uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

Slab solve(const Scene& scene, const SolveOptions& options, SolveStats* stats, const Progress& progress) {
  SolveStats ignored;
  SolveStats& out = stats ? *stats : ignored;
  const auto report = [&](double done, const char* what) {
    if (progress) progress(done, what);
  };
  check(scene, options);
  if (!scene.textures.empty()) return solve(with_mean_reflectances(scene), options, stats, progress);
  const Stopwatch all;
  report(0, "direct light");
  Slab slab;
  slab.grid = grid_for(scene, options);
  const TimeGrid& grid = slab.grid;
  std::vector<Instant> instants(grid.node_count());
  for (uint32_t i = 0; i < grid.node_count(); ++i) instants[i] = instant_at(scene, node_time(grid, i));
  const Tracer tracer(scene);
  const SweptBounds swept(scene, tracer, grid);
  const double diagonal = tracer.scene_box().diagonal();
  const double expected = expected_mean_radiance(scene, instants);
  const auto tolerance = static_cast<float>(options.error * expected * kPi / 5);

  MeshBuilder builder(scene);
  const std::vector<bool> reached = reached_sides(scene, tracer, grid);
  builder.add_faces(reached, diagonal / 100);
  DirectPhase direct(scene, tracer, grid, swept, instants,
                     direct_options(diagonal, options.error, expected, tolerance), &builder);
  direct.run();
  out.direct.kernel_evaluations = direct.evaluations();
  out.direct.rays = direct.rays();
  all.into(&out.direct);

  const Stopwatch rest;
  report(0.3, "links");
  NodeTree tree(scene, &builder, options.clusters);
  const Workspace work{grid, tree, tracer, swept};
  std::optional<LinkLight> light =
      light_along_links(work, instants, {options.error * expected / 8, diagonal / 150, options.residual},
                        &tree, &direct, &slab.direct, &out);
  malloc_trim(0);
  const double mean = mean_radiance(tree, light->radiance);

  report(0.6, "bounces");
  out.indirect.rays += settle_by_rays(work, light->direct, &light->radiance);
  LightFunctions radiance = std::move(light->radiance);
  light.reset();
  malloc_trim(0);

  report(0.7, "final gather");
  const FinalGather gather(tree, tracer, grid, swept, radiance, rays_for(options.error));
  IndirectPhase indirect(scene, grid, gather, indirect_options(diagonal, options.error, mean, tolerance),
                         &builder);
  indirect.run();
  radiance = {};
  malloc_trim(0);
  slab.indirect = indirect.surpluses();
  slab.mesh = builder.take();
  // Vertices that indirect light has added since have no direct light of their own.
  slab.direct.first_piece.resize(slab.mesh.vertices.size() + 1, slab.direct.first_piece.back());

  out.indirect.rays += indirect.rays();
  rest.into(&out.indirect);
  all.into(&out.total);
  measure(slab, &out);
  return slab;
}

SlabWork work_of(const Slab& slab, const SolveStats& stats) {
  const PhaseStats& total = stats.total;
  return {slab_begin(slab),
          slab_end(slab),
          stats.clusters,
          total.links,
          total.links_refined_in_time,
          total.links_refined_in_space,
          total.kernel_evaluations,
          total.rays,
          static_cast<uint64_t>(stats.iterations)};
}

}  // namespace strad
