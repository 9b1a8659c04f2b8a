#include "solve/solve.h"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "base/error.h"
#include "image/srgb.h"
#include "solve/direct_phase.h"
#include "solve/final_gather.h"
#include "solve/indirect_phase.h"
#include "solve/leaf_light.h"
#include "solve/power.h"
#include "solve/reach.h"
#include "solve/refinement.h"
#include "solve/transport.h"

namespace strad {
namespace {

constexpr int kVertexRays = 512;  // noise of a vertex below 1 %, fixed in time

// Nodes of the grid for the whole animation: one for every 1.6 frames, at least 24.
int sample_count(const Scene& scene, double begin, double end) {
  return static_cast<int>(std::max(24.0, (end - begin) * scene.rate / 1.6));
}

TimeGrid grid_for(const Scene& scene, const SolveOptions& options) {
  if (options.instant) return instant_grid(*options.instant);
  const double begin = options.begin.value_or(scene.start), end = options.end.value_or(scene.end);
  std::vector<double> steps;
  for (const double t : step_times(scene))
    if (t > begin && t < end) steps.push_back(t);
  return make_time_grid(begin, end, steps, options.order, sample_count(scene, begin, end));
}

std::vector<uint32_t> strided_dates(uint32_t count, uint32_t wanted) {
  std::vector<uint32_t> dates;
  const uint32_t n = std::min(count, wanted);
  for (uint32_t i = 0; i < n; ++i) dates.push_back(static_cast<uint32_t>((i + 0.5) * count / n));
  return dates;
}

Rgb mean_of(const Texture& texture) {
  double sum[3] = {0, 0, 0};
  for (size_t i = 0; i < texture.srgb.size(); ++i) sum[i % 3] += linear_from_byte(texture.srgb[i]);
  const double texels = std::max(1.0, static_cast<double>(texture.srgb.size() / 3));
  return {static_cast<float>(sum[0] / texels), static_cast<float>(sum[1] / texels),
          static_cast<float>(sum[2] / texels)};
}

// The scene with the mean of each texture in its material's reflectance: what light transport sees.
Scene without_textures(Scene scene) {
  for (Material& material : scene.materials) {
    if (material.texture == kNone) continue;
    material.reflectance = material.reflectance * mean_of(scene.textures[material.texture]);
    material.texture = kNone;
  }
  scene.textures.clear();
  return scene;
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
DirectOptions direct_options(double diagonal, double error, double mean) {
  DirectOptions options;
  options.largest_element = diagonal / 24;
  options.smallest_element = diagonal / 600;
  // Some thousands of elements are alive at an instant, and their squared errors add up.
  options.threshold = static_cast<float>(error * mean / 5);
  return options;
}

IndirectOptions indirect_options(double diagonal, double error, double mean) {
  IndirectOptions options;
  options.largest_element = diagonal / 12;
  options.smallest_element = diagonal / 100;
  options.threshold = static_cast<float>(error * mean / 3);
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

void count(const Refinement& refinement, const IndirectPhase& phase, PhaseStats* stats) {
  stats->rays += refinement.counts().rays + phase.rays();
  stats->links = refinement.links().size();
  stats->links_refined_in_time = refinement.counts().refined_in_time;
  stats->links_refined_in_space = refinement.counts().refined_in_space;
  stats->kernel_evaluations = refinement.counts().evaluations;
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
  if (!scene.textures.empty()) return solve(without_textures(scene), options, stats, progress);
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
  const auto tolerance = static_cast<float>(options.error * expected * kPi / 8);

  MeshBuilder builder(scene);
  const std::vector<bool> reached = reached_sides(scene, tracer, grid);
  for (uint32_t side = 0; side < reached.size(); ++side)
    if (reached[side]) builder.face(side / 2, side % 2);
  DirectPhase direct(scene, tracer, grid, instants, direct_options(diagonal, options.error, expected),
                     &builder);
  direct.run();
  out.direct.kernel_evaluations = direct.evaluations();
  out.direct.rays = direct.rays();
  all.into(&out.direct);

  const Stopwatch rest;
  report(0.3, "links");
  NodeTree tree(scene, &builder);
  const Workspace work{grid, tree, tracer, swept};
  const KernelEvaluator kernels(tree, tracer, grid, swept);
  const std::vector<uint32_t> watched = strided_dates(grid.node_count(), 32);
  Refinement refinement(grid, kernels, direct, watched, &tree);
  RefinementOptions refine_options;
  refine_options.smallest_radius = diagonal / 150;
  Balance scales;
  Views views;
  LinkTable table;
  TransportInput input{&grid,   &tree,
                       &table,  [&](size_t n, size_t i) { return refinement.direct()[n][i]; },
                       &scales, options.residual,
                       100};
  for (const double looseness : {16.0, 4.0, 1.0}) {
    refine_options.threshold = looseness * options.error * expected / 8;
    refinement.refine(refine_options);
    table = make_link_table(grid, static_cast<uint32_t>(tree.nodes().size()), refinement.links());
    views = views_of(work, &out.indirect.rays);
    scales = balance(grid, tree, refinement.links(), views.row_sums, views.column_sums);
    std::vector<Rgb> radiance;
    propagate(input, watched, 0, &radiance);
    refinement.update_radiance(radiance);
  }

  report(0.5, "propagation");
  PackedLeafFunctions leaf_direct = direct_of_leaves(work, direct);
  slab.direct = direct.surpluses(tolerance);
  malloc_trim(0);  // many small functions were freed: give their pages back before the leaves take theirs
  input.direct = [&](size_t n, size_t i) { return leaf_direct[n][i]; };
  LeafFunctions radiance;
  const TransportResult result = propagate_all(input, &radiance);
  malloc_trim(0);
  out.iterations = result.iterations;
  out.residual = result.residual;
  const double mean = mean_radiance(tree, radiance);

  report(0.6, "bounces");
  out.indirect.rays += settle_by_rays(work, leaf_direct, &radiance);
  leaf_direct = {};
  table = {};
  malloc_trim(0);

  report(0.7, "final gather");
  const FinalGather gather(tree, tracer, grid, swept, radiance, kVertexRays);
  IndirectPhase indirect(scene, grid, gather, indirect_options(diagonal, options.error, mean), &builder);
  indirect.run();
  slab.indirect = indirect.surpluses(tolerance);
  slab.mesh = builder.take();
  // Vertices that indirect light has added since have no direct light of their own.
  slab.direct.first_piece.resize(slab.mesh.vertices.size() + 1, slab.direct.first_piece.back());

  count(refinement, indirect, &out.indirect);
  rest.into(&out.indirect);
  all.into(&out.total);
  out.link_bytes = refinement.links().size() * sizeof(Link);
  measure(slab, &out);
  return slab;
}

}  // namespace strad
