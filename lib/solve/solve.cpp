#include "solve/solve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numeric>

#include "base/error.h"
#include "base/parallel.h"
#include "solve/direct_phase.h"
#include "solve/final_gather.h"
#include "solve/indirect_phase.h"
#include "solve/refinement.h"
#include "solve/transport.h"
static double tune(const char* n, double d) {
  const char* v = getenv(n);
  return v ? atof(v) : d;
}
namespace strad {
namespace {

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

// Mean radiance of the scene's surfaces, from the power of its lights and its mean reflectance.
double expected_mean_radiance(const Scene& scene, const std::vector<Instant>& instants) {
  double area = 0, reflected = 0;
  for (const Polygon& polygon : scene.polygons) {
    const double a = polygon_area(scene, polygon);
    const Rgb rho = scene.materials[polygon.material].reflectance;
    area += a;
    reflected += a * (rho.r + rho.g + rho.b) / 3;
  }
  double power = 0;
  const size_t stride = std::max<size_t>(1, instants.size() / 16);
  size_t dates = 0;
  for (size_t i = 0; i < instants.size(); i += stride, ++dates) {
    for (size_t s = 0; s < scene.spots.size(); ++s) {
      const double low = std::cos(scene.spots[s].outer), high = std::cos(scene.spots[s].inner);
      const Rgb intensity = instants[i].spots[s].intensity;
      power += 2 * kPi * ((1 - high) + 0.5 * (high - low)) * (intensity.r + intensity.g + intensity.b) / 3;
    }
    for (const Polygon& polygon : scene.polygons) {
      if (!emits(scene, polygon)) continue;
      const Rgb le = scene.materials[polygon.material].emission;
      power +=
          kPi * polygon_area(scene, polygon) * instants[i].glow[polygon.material] * (le.r + le.g + le.b) / 3;
    }
  }
  const double rho = area > 0 ? std::min(reflected / area, 0.9) : 0;
  return area > 0 && dates > 0 ? rho / kPi * power / static_cast<double>(dates) / area / (1 - rho) : 0;
}

double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<uint32_t> strided_dates(uint32_t count, uint32_t wanted) {
  std::vector<uint32_t> dates;
  const uint32_t n = std::min(count, wanted);
  for (uint32_t i = 0; i < n; ++i) dates.push_back(static_cast<uint32_t>((i + 0.5) * count / n));
  return dates;
}

// Radiance of all leaves at all dates, block by block.
TransportResult propagate_all(const TransportInput& input, std::vector<std::vector<Rgb>>* radiance) {
  constexpr uint32_t kBlock = 48;  // dates: the working set of some thousand nodes stays in the cache
  const uint32_t dates = input.grid->node_count();
  const uint32_t blocks = (dates + kBlock - 1) / kBlock;
  const std::vector<Node>& nodes = input.tree->nodes();
  radiance->assign(nodes.size(), {});
  for (size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].first_child == kNone) (*radiance)[n].resize(dates);
  std::vector<TransportResult> results(blocks);
  parallel_for(blocks, 1, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      std::vector<uint32_t> block(std::min(kBlock, dates - static_cast<uint32_t>(b) * kBlock));
      std::iota(block.begin(), block.end(), static_cast<uint32_t>(b) * kBlock);
      std::vector<Rgb> of_block;
      results[b] = propagate(input, block, &of_block);
      for (size_t n = 0; n < nodes.size(); ++n)
        if (nodes[n].first_child == kNone)
          std::copy_n(of_block.begin() + static_cast<ptrdiff_t>(n * block.size()), block.size(),
                      (*radiance)[n].begin() + static_cast<ptrdiff_t>(block.front()));
    }
  });
  TransportResult worst;
  for (const TransportResult& r : results) {
    worst.iterations = std::max(worst.iterations, r.iterations);
    worst.residual = std::max(worst.residual, r.residual);
  }
  return worst;
}

double mean_radiance(const NodeTree& tree, const std::vector<std::vector<Rgb>>& radiance) {
  double sum = 0, area = 0;
  for (size_t n = 0; n < radiance.size(); ++n) {
    if (radiance[n].empty()) continue;
    double of_node = 0;
    for (const Rgb& l : radiance[n]) of_node += (l.r + l.g + l.b) / 3;
    if (!(of_node > 0)) continue;
    sum += tree.nodes()[n].area * of_node / static_cast<double>(radiance[n].size());
    area += tree.nodes()[n].area;
  }
  return area > 0 ? sum / area : 0;
}

// Share of the hemisphere over each leaf that sees surfaces.
std::vector<float> openness_of(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                               const SweptBounds& swept, uint64_t* rays) {
  const std::vector<std::vector<Rgb>> everywhere(tree.nodes().size(), std::vector<Rgb>(1));
  const FinalGather gather(tree, tracer, grid, swept, everywhere, 128);
  std::vector<float> openness(tree.nodes().size(), 1.0f);
  std::vector<uint64_t> counts(tree.nodes().size(), 0);
  parallel_for(tree.nodes().size(), 16, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n)
      if (tree.nodes()[n].first_child == kNone)
        openness[n] = gather.openness(static_cast<uint32_t>(n), &counts[n]);
  });
  *rays += std::accumulate(counts.begin(), counts.end(), uint64_t{0});
  return openness;
}

// Replaces the radiance of all leaves by what one gather by rays over it makes of it. Returns the rays.
uint64_t bounce_by_rays(const NodeTree& tree, const FinalGather& gather,
                        const std::vector<std::vector<Rgb>>& direct,
                        std::vector<std::vector<Rgb>>* radiance) {
  std::vector<std::vector<Rgb>> reflected(radiance->size());
  std::vector<uint64_t> rays(radiance->size(), 0);
  parallel_for(radiance->size(), 8, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) {
      if ((*radiance)[n].empty()) continue;
      const GatheredFunction f = gather.over_node(static_cast<uint32_t>(n), &rays[n]);
      const Rgb brdf = static_cast<float>(1 / kPi) * tree.nodes()[n].reflectance;
      reflected[n] = f.irradiance;
      for (size_t i = 0; i < reflected[n].size(); ++i)
        reflected[n][i] = brdf * (direct[n][i] + reflected[n][i]);
    }
  });
  *radiance = std::move(reflected);
  return std::accumulate(rays.begin(), rays.end(), uint64_t{0});
}

double total_of(const NodeTree& tree, const std::vector<std::vector<Rgb>>& radiance) {
  double total = 0;
  for (size_t n = 0; n < radiance.size(); ++n) {
    double of_node = 0;
    for (const Rgb& l : radiance[n]) of_node += l.r + l.g + l.b;
    total += tree.nodes()[n].area * of_node;
  }
  return total;
}

// Links err by sums of small errors of one sign. Bounces by rays, which are unbiased, shrink what is left of
// them by one factor each; the factor is seen from two bounces, and the rest of the geometric series is added
// at once (Aitken's extrapolation).
uint64_t settle_by_rays(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                        const SweptBounds& swept, const std::vector<std::vector<Rgb>>& direct,
                        std::vector<std::vector<Rgb>>* radiance) {
  constexpr int kBounces = 2, kRays = 128;
  uint64_t rays = 0;
  std::vector<std::vector<Rgb>> before;
  double totals[kBounces + 1] = {total_of(tree, *radiance)};
  for (int b = 1; b <= kBounces; ++b) {
    before = *radiance;
    const FinalGather gather(tree, tracer, grid, swept, before, kRays);
    rays += bounce_by_rays(tree, gather, direct, radiance);
    totals[b] = total_of(tree, *radiance);
  }
  const double first = totals[kBounces - 1] - totals[kBounces - 2],
               second = totals[kBounces] - totals[kBounces - 1];
  const double factor = first != 0 ? std::clamp(second / first, 0.0, 0.8) : 0;
  const auto more = static_cast<float>(factor / (1 - factor));
  for (size_t n = 0; n < radiance->size(); ++n)
    for (size_t i = 0; i < (*radiance)[n].size(); ++i) {
      Rgb& l = (*radiance)[n][i];
      const Rgb further = l + more * (l - before[n][i]);
      l = {std::max(0.0f, further.r), std::max(0.0f, further.g), std::max(0.0f, further.b)};
    }
  return rays;
}

}  // namespace

Slab solve(const Scene& scene, const SolveOptions& options, SolveStats* stats, const Progress& progress) {
  SolveStats ignored;
  SolveStats& out = stats ? *stats : ignored;
  const auto report = [&](double done, const char* what) {
    if (progress) progress(done, what);
  };
  const double cpu_start = cpu_now(), wall_start = wall_now();
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

  MeshBuilder builder(scene);
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    for (uint32_t side = 0; side < 2; ++side) builder.face(p, side);
  DirectOptions direct_options;
  direct_options.largest_element = diagonal / 24;
  direct_options.smallest_element = diagonal / 600;
  direct_options.threshold = static_cast<float>(options.error * expected / tune("TD", 40));
  DirectPhase direct(scene, tracer, grid, instants, direct_options, &builder);
  direct.run();
  out.direct.kernel_evaluations = direct.evaluations();
  out.direct.cpu_seconds = cpu_now() - cpu_start;
  out.direct.wall_seconds = wall_now() - wall_start;

  report(0.3, "links");
  NodeTree tree(scene, &builder);
  const KernelEvaluator kernels(tree, tracer, grid, swept);
  const std::vector<uint32_t> watched = strided_dates(grid.node_count(), 32);
  Refinement refinement(grid, kernels, direct, watched, &tree);
  RefinementOptions refine_options;
  refine_options.smallest_radius = diagonal / 150;
  Balance scales;
  LinkTable table;
  TransportInput input{&grid, &tree, &table, &refinement.direct(), &scales, options.residual, 100};
  for (const double looseness : {16.0, 4.0, 1.0}) {
    refine_options.threshold = looseness * options.error * expected / tune("TL", 8);
    refinement.refine(refine_options);
    table = make_link_table(grid, static_cast<uint32_t>(tree.nodes().size()), refinement.links());
    scales =
        balance(grid, tree, refinement.links(), openness_of(tree, tracer, grid, swept, &out.indirect.rays));
    std::vector<Rgb> radiance;
    propagate(input, watched, &radiance);
    refinement.update_radiance(radiance);
  }
  std::vector<std::vector<Rgb>> radiance;
  if (getenv("VERB")) {
    double flux = 0, rs = 0, cs = 0, ra = 0;
    for (size_t n = 0; n < tree.nodes().size(); ++n)
      if (tree.nodes()[n].first_child == kNone) {
        flux += tree.nodes()[n].area * refinement.direct()[n][0].g;
        if (radiance.size() <= n || true) {
          rs += tree.nodes()[n].area * scales.receiver[n];
          cs += tree.nodes()[n].area * scales.emitter[n];
          ra += tree.nodes()[n].area;
        }
      }
    double want = 0;
    for (size_t k = 0; k < scene.spots.size(); ++k) {
      const double low = std::cos(scene.spots[k].outer), high = std::cos(scene.spots[k].inner);
      want += 2 * kPi * ((1 - high) + 0.5 * (high - low)) * instants[0].spots[k].intensity.g;
    }
    fprintf(stderr, "direct flux %g of %g; mean scale %g %g leaves %zu\n", flux, want, rs / ra, cs / ra,
            tree.nodes().size());
  }
  report(0.6, "propagation");
  const TransportResult result = propagate_all(input, &radiance);
  out.iterations = result.iterations;
  out.residual = result.residual;
  const double mean = mean_radiance(tree, radiance);

  // Leaves and sides that stay dark take no part in the final gather.
  std::vector<bool> lit(builder.mesh().faces.size(), false);
  for (size_t n = 0; n < radiance.size(); ++n) {
    const bool bright = std::any_of(radiance[n].begin(), radiance[n].end(),
                                    [&](Rgb l) { return max_channel(l) > 1e-4 * mean; });
    if (bright) lit[tree.nodes()[n].face] = true;
  }
  for (size_t n = 0; n < radiance.size(); ++n)
    if (!lit[tree.nodes()[n].face]) radiance[n].clear();

  report(0.65, "bounces");
  out.indirect.rays += settle_by_rays(tree, tracer, grid, swept, refinement.direct(), &radiance);
  report(0.7, "final gather");
  const FinalGather gather(tree, tracer, grid, swept, radiance, static_cast<int>(tune("RAYS", 512)));
  IndirectOptions indirect_options;
  indirect_options.largest_element = diagonal / 12;
  indirect_options.smallest_element = diagonal / tune("SI", 100);
  indirect_options.threshold = static_cast<float>(options.error * mean / tune("TI", 10));
  IndirectPhase indirect(scene, grid, gather, indirect_options, lit, &builder);
  indirect.run();
  const auto tolerance = static_cast<float>(options.error * mean * kPi / 8);
  slab.indirect = indirect.surpluses(tolerance);
  slab.direct = direct.surpluses(tolerance);
  slab.mesh = builder.take();

  out.indirect.rays += refinement.counts().rays + indirect.rays();
  out.indirect.links = refinement.links().size();
  out.indirect.links_refined_in_time = refinement.counts().refined_in_time;
  out.indirect.links_refined_in_space = refinement.counts().refined_in_space;
  out.indirect.kernel_evaluations = refinement.counts().evaluations;
  out.indirect.cpu_seconds = cpu_now() - cpu_start - out.direct.cpu_seconds;
  out.indirect.wall_seconds = wall_now() - wall_start - out.direct.wall_seconds;
  out.total.cpu_seconds = cpu_now() - cpu_start;
  out.total.wall_seconds = wall_now() - wall_start;
  out.elements = slab.mesh.elements.size();
  out.vertices = slab.mesh.vertices.size();
  out.coefficients = 3 * (slab.direct.coefficients.size() + slab.indirect.coefficients.size());
  return slab;
}

}  // namespace strad
