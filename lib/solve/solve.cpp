#include "solve/solve.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "base/clock.h"
#include "base/error.h"
#include "base/memory.h"
#include "solve/direct/direct_phase.h"
#include "solve/gather/bounces.h"
#include "solve/gather/final_gather.h"
#include "solve/gather/form_factor_sums.h"
#include "solve/gather/indirect_phase.h"
#include "solve/links/leaf_radiance.h"
#include "solve/links/link_phase.h"
#include "solve/prepare/mean_reflectance.h"
#include "solve/prepare/power.h"
#include "solve/prepare/reach.h"
#include "solve/prepare/wall_cuts.h"

namespace strad {
namespace {

// Rays per vertex: at the default error their noise is below 1 % (3 % for a small face) and the same at all
// times. A larger tolerated error gives fewer: in strata noise falls almost as fast as rays are added
// (Mitchell 1996).
int rays_for(double error) { return static_cast<int>(512 * std::clamp(0.02 / error, 0.125, 1.0)); }

// Rays per leaf: noise of some 5 % (10 % for a small face) at the default error, averaged over the hundreds
// that a point sees.
int leaf_rays_for(double error) { return static_cast<int>(128 * std::clamp(0.02 / error, 0.25, 1.0)); }

// Time samples of the animation: one for every 3.2 frames, at least 24.
int samples_for(const Scene& scene, double begin, double end) {
  return static_cast<int>(std::max(24.0, (end - begin) * scene.rate / 3.2));
}

TimeGrid grid_for(const Scene& scene, const SolveOptions& options) {
  if (options.instant) return instant_grid(*options.instant);
  const double begin = options.begin.value_or(scene.start), end = options.end.value_or(scene.end);
  std::vector<double> steps;
  for (const double t : step_times(scene))
    if (t > begin && t < end) steps.push_back(t);
  return make_time_grid(begin, end, steps, options.order, samples_for(scene, begin, end));
}

std::vector<Instant> instants_of(const Scene& scene, const TimeGrid& grid) {
  std::vector<Instant> instants;
  for (uint32_t i = 0; i < grid.sample_count(); ++i)
    instants.push_back(instant_at(scene, sample_time(grid, i)));
  return instants;
}

// Tells one phase after another: how far the solve is, and what each phase cost.
class PhaseClock {
 public:
  explicit PhaseClock(const Progress& progress) : progress_(progress) {}
  // Ends the phase before. `done`: share of the whole solve that lies before this phase.
  void begin(double done, const char* name, PhaseStats* stats) {
    end();
    stats_ = stats;
    cpu_start_ = cpu_now(), wall_start_ = wall_now();
    if (progress_) progress_(done, name);
  }
  void end() {
    if (!stats_) return;
    stats_->cpu_seconds = cpu_now() - cpu_start_;
    stats_->wall_seconds = wall_now() - wall_start_;
    stats_ = nullptr;
  }

 private:
  const Progress& progress_;
  PhaseStats* stats_ = nullptr;
  double cpu_start_ = 0, wall_start_ = 0;
};

// Direct light: every face split where it varies. `mean`: mean radiance to expect.
DirectOptions direct_options(double diagonal, double error, double mean, float tolerance) {
  DirectOptions options;
  options.largest_element = diagonal / 24;
  options.smallest_element = diagonal / 600;
  // Some thousands of elements are alive at an instant, and their squared errors add up.
  options.threshold = static_cast<float>(error * mean / 5);
  options.tolerance = tolerance;
  // The noise of stratified shadow rays falls at least with the root of their number.
  options.emitter_samples = static_cast<int>(16 * std::clamp(std::sqrt(0.02 / error), 0.25, 1.0));
  return options;
}

// `dark`: as in SolveOptions.
IndirectOptions indirect_options(double diagonal, double error, double mean, double dark, float tolerance) {
  IndirectOptions options;
  options.largest_element = diagonal / 12;
  options.smallest_element = diagonal / 100;
  options.bright = static_cast<float>(kPi * mean);
  options.dark = static_cast<float>(dark) * options.bright;
  options.threshold = static_cast<float>(error * mean / 8);
  options.tolerance = tolerance;
  return options;
}

// Throws BadInput for what cannot be meant.
void check(const Scene& scene, const SolveOptions& options) {
  const auto within = [&](double time, const char* what) {
    if (!(time >= scene.start && time <= scene.end))
      throw BadInput(std::string("the slab's ") + what + ": found " + std::to_string(time) +
                     " s, expected a time in the animation, " + std::to_string(scene.start) + " to " +
                     std::to_string(scene.end) + " s");
  };
  if (!(options.error > 0) || !std::isfinite(options.error))
    throw BadInput("error: found " + std::to_string(options.error) + ", expected a number above 0");
  if (!(options.dark > 0 && options.dark <= 1))
    throw BadInput("dark: found " + std::to_string(options.dark) + ", expected a share above 0, at most 1");
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
  stats->indirect = stats->links + stats->bounces + stats->gather;
  stats->total = stats->prepare + stats->direct + stats->indirect;
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

// What all phases share. Filled by the first phase, and not moved since parts refer to one another.
struct Prepared {
  const Scene& scene;  // without colours of textures: reflectances are means over polygons
  TimeGrid grid;
  std::vector<Instant> instants;  // by time sample
  Tracer tracer;
  SweptBounds swept;
  double diagonal;           // m, of the scene
  double expected_radiance;  // W / (sr m^2), the mean
  float tolerance;           // W / m^2, of functions of time
  MeshBuilder builder;

  Prepared(const Scene& s, const std::vector<bool>& dark, const SolveOptions& options)
      : scene(s),
        grid(grid_for(s, options)),
        instants(instants_of(s, grid)),
        tracer(s),
        swept(s, tracer, grid),
        diagonal(tracer.scene_box().diagonal()),
        expected_radiance(expected_mean_radiance(s, instants)),
        tolerance(static_cast<float>(options.error * expected_radiance * kPi / 5)),
        builder(s) {
    builder.add_faces(reached_sides(s, tracer, grid, dark), diagonal / 100);
  }
  Prepared(const Prepared&) = delete;
};

RefinedLinks links_of(const Workspace& work, const Prepared& p, const SolveOptions& options,
                      const DirectPhase& direct, NodeTree* tree, SolveStats* stats) {
  const LinkOptions link_options{options.error * p.expected_radiance / 8, p.diagonal / 150,
                                 p.expected_radiance, options.dark, options.residual};
  const auto sums = [&](uint64_t* rays) { return form_factor_sums_by_rays(work, rays); };
  RefinedLinks links = refine_links(work, p.instants, link_options, direct, sums, tree);
  if (options.look_at_links) options.look_at_links(*tree, links.table);
  stats->links.rays = links.counts.rays + links.form_factor_rays;
  stats->links.links = links.count;
  stats->links.links_refined_in_time = links.counts.refined_in_time;
  stats->links.links_refined_in_space = links.counts.refined_in_space;
  stats->links.kernel_evaluations = links.counts.evaluations;
  stats->link_bytes = links.count * sizeof(Link);
  stats->clusters = tree->cluster_count();
  return links;
}

struct LeafLight {
  FunctionBlock radiance;
  LeafSlopes slopes;
  DirectionGuide guide;
  double mean = 0;  // W / (sr m^2), as the links gave it
};

// Radiance that leaves reflect. Takes the surpluses of direct light from its phase on the way.
LeafLight light_of_leaves(const Prepared& p, const SolveOptions& options, NodeTree* tree, DirectPhase* direct,
                          Field* direct_surpluses, PhaseClock* clock, SolveStats* stats) {
  const Workspace work{p.grid, *tree, p.tracer, p.swept, leaf_rays_for(options.error)};
  LeafLight light;
  const RefinedLinks links = links_of(work, p, options, *direct, tree, stats);
  FunctionBlock divided = direct_of_divided_leaves(work, *direct);
  *direct_surpluses = direct->take_surpluses();
  release_freed_memory();  // before the radiance of all leaves is allocated
  const DirectOfLeaves direct_of_leaves(work, std::move(divided), *direct_surpluses);
  const LeafSource of_direct = [&](uint32_t leaf, uint32_t first_cell, uint32_t cells) {
    return direct_of_leaves.reflected(leaf, first_cell, cells);
  };
  light.radiance = FunctionBlock(tree->leaf_count(), leaves_of(*tree), p.grid.sample_count());
  set_to_source(work, of_direct, &light.radiance);
  TransportInput input = input_of(work, p.instants, links, options.residual);
  const Propagation propagation = add_reflected(work, of_direct, input, 1, &light.radiance);
  stats->iterations = propagation.iterations;
  stats->residual = propagation.residual;
  light.mean = mean_radiance(*tree, light.radiance);
  clock->begin(0.6, "bounces", &stats->bounces);
  input.residual = 1e-2;  // of a correction
  Bounces bounces = correct_by_bounces(work, direct_of_leaves, input, options.error, &light.radiance);
  stats->bounces.rays = bounces.rays;
  light.slopes = std::move(bounces.slopes);
  light.guide = std::move(bounces.guide);
  return light;
}

// Final gather at the vertices of the mesh, which it refines. Frees the radiance before surpluses are made.
Field gather_surpluses(const SolveOptions& options, const NodeTree& tree, LeafLight light, Prepared* p,
                       SolveStats* stats) {
  const FinalGather gather(tree, p->tracer, p->grid, p->swept, light.radiance, light.slopes, light.guide,
                           {rays_for(options.error), options.error / 5});
  IndirectPhase indirect(p->scene, p->grid, gather,
                         indirect_options(p->diagonal, options.error, light.mean, options.dark, p->tolerance),
                         &p->builder);
  indirect.run();
  stats->gather.rays = indirect.rays();
  light = {};
  release_freed_memory();
  return indirect.take_surpluses();
}

// `dark`: see CutScene.
Slab solve_untextured(const Scene& scene, const std::vector<bool>& dark, const SolveOptions& options,
                      PhaseClock* clock, SolveStats* stats) {
  Prepared p(scene, dark, options);
  Slab slab;
  slab.grid = p.grid;

  clock->begin(0.05, "direct light", &stats->direct);
  DirectPhase direct(scene, p.tracer, p.grid, p.swept, p.instants,
                     direct_options(p.diagonal, options.error, p.expected_radiance, p.tolerance), &p.builder);
  direct.run();
  stats->direct.kernel_evaluations = direct.evaluations();
  stats->direct.rays = direct.rays();

  clock->begin(0.3, "links", &stats->links);
  NodeTree tree(scene, &p.builder, options.clusters);
  LeafLight light = light_of_leaves(p, options, &tree, &direct, &slab.direct, clock, stats);
  release_freed_memory();

  clock->begin(0.7, "final gather", &stats->gather);
  slab.indirect = gather_surpluses(options, tree, std::move(light), &p, stats);
  slab.mesh = p.builder.take();
  // Vertices that the gather has added have no direct light of their own.
  slab.direct.first_piece.resize(slab.mesh.vertices.size() + 1, slab.direct.first_piece.back());
  clock->end();
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

}  // namespace

Solved solve(Scene scene, const SolveOptions& options, const Progress& progress) {
  check(scene, options);
  Solved solved;
  PhaseClock clock(progress);
  clock.begin(0, "preparation", &solved.stats.prepare);
  CutScene cut = cut_under_walls(std::move(scene));
  solved.scene = std::move(cut.scene);
  if (solved.scene.textures.empty())
    solved.slab = solve_untextured(solved.scene, cut.dark, options, &clock, &solved.stats);
  else
    solved.slab =
        solve_untextured(with_mean_reflectances(solved.scene), cut.dark, options, &clock, &solved.stats);
  measure(solved.slab, &solved.stats);
  solved.work = work_of(solved.slab, solved.stats);
  return solved;
}

}  // namespace strad
