#include "solve/gather/leaf_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "solve/gather/final_gather.h"

namespace strad {
namespace {

// A leaf's noise, some 5 % (10 % of a small face), is averaged over the hundreds that a point sees.
constexpr int kLeafRays = 128;

constexpr float kLeastOpen = 0.2f;   // a leaf more covered than this is all but unseen
constexpr float kOpenEnough = 0.4f;  // and tells of itself from here on

uint64_t sum_of(const std::vector<uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

// What a light is made of.
struct LightSurface {
  uint32_t element;
  double area;
  Rgb brdf;
};
LightSurface surface_of(const NodeTree& tree, uint32_t light) {
  const auto inverse_pi = static_cast<float>(1 / kPi);
  if (light < tree.nodes().size()) {
    const Node& node = tree.nodes()[light];
    return {node.element, node.area, inverse_pi * node.reflectance};
  }
  const uint32_t f = light - static_cast<uint32_t>(tree.nodes().size());
  const Face& face = tree.builder().mesh().faces[f];
  const Material& material = tree.scene().materials[tree.scene().polygons[face.polygon].material];
  return {face.element, tree.face_area(f), inverse_pi * material.reflectance};
}

// All lights, ascending.
std::vector<uint32_t> lights_of(const NodeTree& tree) {
  std::vector<uint32_t> lights;
  const auto nodes = static_cast<uint32_t>(tree.nodes().size());
  for (uint32_t n = 0; n < nodes; ++n)
    if (tree.nodes()[n].is_leaf() && !tree.nodes()[n].is_cluster()) lights.push_back(n);
  for (uint32_t light = nodes; light < tree.light_count(); ++light)
    if (tree.nodes()[tree.node_of_face(light - nodes)].is_cluster()) lights.push_back(light);
  return lights;
}

double total_of(const NodeTree& tree, const LightFunctions& radiance) {
  double total = 0;
  for (const uint32_t light : radiance.lights()) {
    double of_light = 0;
    for (size_t d = 0; d < radiance.dates(); ++d) {
      const Rgb l = radiance.get(light, d);
      of_light += l.r + l.g + l.b;
    }
    total += surface_of(tree, light).area * of_light;
  }
  return total;
}

// A patch that something stands on, and how much of it is seen at every date.
struct Covered {
  uint32_t node;
  std::vector<float> open;
};

// How far to believe in what a patch has, by how much of it is open: too few rays tell of a sliver.
float trust_in(float open) {
  return std::clamp((open - kLeastOpen) / (kOpenEnough - kLeastOpen), 0.0f, 1.0f);
}

// Gives slivers the radiance of what is open around them: the foot of a box sees little else.
void fill_covered(const NodeTree& tree, const std::vector<Covered>& covered, LightFunctions* radiance) {
  const std::vector<Node>& nodes = tree.nodes();
  std::vector<const Covered*> of_node(nodes.size(), nullptr);
  for (const Covered& c : covered) of_node[c.node] = &c;
  std::vector<std::vector<Rgb>> filled(covered.size());
  parallel_for(covered.size(), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Covered& own = covered[i];
      std::vector<uint32_t> around, open_nodes{nodes[own.node].parent};
      if (open_nodes[0] == kNone || nodes[open_nodes[0]].is_cluster()) continue;
      while (!open_nodes.empty()) {
        const Node& node = nodes[open_nodes.back()];
        const uint32_t index = open_nodes.back();
        open_nodes.pop_back();
        if (node.is_leaf() && index != own.node && radiance->has(index)) around.push_back(index);
        for (uint32_t c = 0; !node.is_leaf() && c < node.child_count; ++c)
          open_nodes.push_back(node.first_child + c);
      }
      filled[i].resize(own.open.size());
      for (size_t d = 0; d < own.open.size(); ++d) {
        Rgb sum;
        float weights = 0;
        for (const uint32_t n : around) {
          const float weight = nodes[n].area * (of_node[n] ? trust_in(of_node[n]->open[d]) : 1);
          sum += weight * radiance->get(n, d);
          weights += weight;
        }
        const float trust = weights > 0 ? trust_in(own.open[d]) : 1;
        filled[i][d] = trust * radiance->get(own.node, d);
        if (trust < 1) filled[i][d] += ((1 - trust) / weights) * sum;
      }
    }
  });
  for (size_t i = 0; i < covered.size(); ++i)
    for (size_t d = 0; d < filled[i].size(); ++d) radiance->set(covered[i].node, d, filled[i][d]);
}

// One gather by rays over the radiance of all lights, in place: chunk after chunk, so that a chunk already
// sees the light of those before it and no second copy is held.
struct Bounce {
  uint64_t rays = 0;
  double direct = 0;  // of what is reflected now, in the units of total_of(): what was so for the first time
};
Bounce bounce(const Workspace& work, const DirectOfLights& direct, LightFunctions* radiance) {
  constexpr size_t kChunk = 512;  // fixed: results must not depend on the number of threads
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, *radiance, kLeafRays);
  const std::vector<uint32_t>& lights = radiance->lights();
  std::vector<uint64_t> rays(lights.size(), 0);
  std::vector<double> reflected_direct(lights.size(), 0.0);
  std::vector<std::vector<Rgb>> reflected(kChunk);
  std::vector<std::vector<float>> open(kChunk);
  std::vector<Covered> covered;
  for (size_t first = 0; first < lights.size(); first += kChunk) {
    const size_t count = std::min(kChunk, lights.size() - first);
    parallel_for(count, 8, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const uint32_t light = lights[first + i];
        const LightSurface surface = surface_of(work.tree, light);
        GatheredFunction f = gather.over_light(light, &rays[first + i]);
        const std::vector<Rgb> from_direct = direct.irradiance(light, 0, work.grid.cell_count());
        reflected[i] = std::move(f.irradiance);
        open[i] = std::move(f.open);
        // Means over the leaf become means over what of it is exposed at that date.
        for (size_t d = 0; d < reflected[i].size(); ++d) {
          const Rgb brdf = (1 / std::max(open[i][d], kLeastOpen)) * surface.brdf;
          const Rgb once = brdf * from_direct[d];
          reflected_direct[first + i] += surface.area * static_cast<double>(once.r + once.g + once.b);
          reflected[i][d] = once + brdf * reflected[i][d];
        }
      }
    });
    for (size_t i = 0; i < count; ++i) {
      const uint32_t light = lights[first + i];
      for (size_t d = 0; d < reflected[i].size(); ++d) radiance->set(light, d, reflected[i][d]);
      if (light < work.tree.nodes().size() && *std::min_element(open[i].begin(), open[i].end()) < kOpenEnough)
        covered.push_back({light, std::move(open[i])});
    }
  }
  fill_covered(work.tree, covered, radiance);
  return {sum_of(rays), std::accumulate(reflected_direct.begin(), reflected_direct.end(), 0.0)};
}

// Radiance that leaves reflect of direct light at the nodes of some cells: [slot][date].
std::vector<Rgb> direct_of_slots(const Workspace& work, const DirectOfLights& direct, uint32_t first_cell,
                                 uint32_t cells) {
  const NodeTree& tree = work.tree;
  const size_t count = cells * static_cast<size_t>(work.grid.order);
  std::vector<Rgb> radiance(tree.slot_count() * count);
  const auto nodes = static_cast<uint32_t>(tree.nodes().size());
  for (uint32_t n = 0; n < nodes; ++n) {
    const Node& node = tree.nodes()[n];
    if (!node.is_leaf()) continue;
    const auto add = [&](const std::vector<Rgb>& irradiance, Rgb brdf, size_t slot) {
      for (size_t d = 0; d < count; ++d) radiance[slot * count + d] += brdf * irradiance[d];
    };
    if (!node.is_cluster()) {
      add(direct.irradiance(n, first_cell, cells), surface_of(tree, n).brdf, node.slot);
      continue;
    }
    const Cluster& cluster = tree.cluster(node);
    for (uint32_t i = cluster.first_face; i < cluster.first_face + cluster.face_count; ++i) {
      const uint32_t face = tree.cluster_faces()[i];
      const LobeWeights w = lobes_of_normal(tree.face_normal(face));
      const float share = static_cast<float>(tree.face_area(face)) / node.area;
      const std::vector<Rgb> irradiance = direct.irradiance(nodes + face, first_cell, cells);
      const Rgb brdf = surface_of(tree, nodes + face).brdf;
      for (int l = 0; l < 3; ++l)
        add(irradiance, (share * w.weight[l] / std::max(cluster.lobe_share[w.lobe[l]], 1e-20f)) * brdf,
            node.slot + static_cast<size_t>(w.lobe[l]));
    }
  }
  return radiance;
}

}  // namespace

std::vector<float> openness_of(const Workspace& work, uint64_t* rays) {
  const std::vector<Node>& nodes = work.tree.nodes();
  const LightFunctions unseen;
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, unseen, kLeafRays);
  std::vector<float> openness(nodes.size(), 1.0f);
  std::vector<uint64_t> counts(nodes.size(), 0);
  parallel_for(nodes.size(), 16, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) {
      if (!nodes[n].is_leaf()) continue;
      const FinalGather::View view = gather.view_of(static_cast<uint32_t>(n), &counts[n]);
      openness[n] = view.lit / std::max(1 - view.dead, kLeastOpen);
    }
  });
  *rays += sum_of(counts);
  return openness;
}

DirectOfLights::DirectOfLights(const Workspace& work, const DirectPhase& phase, const Field& kept)
    : work_(work), kept_(kept) {
  const NodeTree& tree = work.tree;
  std::vector<uint32_t> all_cells(work.grid.cell_count());
  std::iota(all_cells.begin(), all_cells.end(), 0u);
  std::vector<uint32_t> lights;
  for (const uint32_t light : lights_of(tree))
    if (!is_uniform(tree.builder().mesh().elements[surface_of(tree, light).element])) lights.push_back(light);
  held_ = LightFunctions(tree.light_count(), lights, work.grid.node_count());
  parallel_for(lights.size(), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::vector<Rgb> mean = phase.mean_irradiance(surface_of(tree, lights[i]).element, all_cells);
      for (size_t d = 0; d < mean.size(); ++d) held_.set(lights[i], d, mean[d]);
    }
  });
}

std::vector<Rgb> DirectOfLights::irradiance(uint32_t light, uint32_t first, uint32_t count) const {
  const auto order = static_cast<size_t>(work_.grid.order);
  std::vector<Rgb> values(count * order);
  if (!held_.has(light)) {
    const Element& element = work_.tree.builder().mesh().elements[surface_of(work_.tree, light).element];
    add_values(work_.grid, kept_, element.vertices[0], first, count, values.data());
    return values;
  }
  for (size_t i = 0; i < values.size(); ++i) values[i] = held_.get(light, first * order + i);
  return values;
}

LightFunctions propagate_all(const Workspace& work, const DirectOfLights& direct, TransportInput input,
                             int* iterations, double* residual) {
  constexpr uint32_t kBlock = 12;  // dates: the working set of some thousand nodes stays in the cache
  const NodeTree& tree = work.tree;
  const auto order = static_cast<uint32_t>(work.grid.order);
  const uint32_t cells = work.grid.cell_count(), block_cells = std::max(1u, kBlock / order);
  const std::vector<uint32_t> lights = lights_of(tree);
  LightFunctions radiance(tree.light_count(), lights, work.grid.node_count());
  const uint32_t blocks = (cells + block_cells - 1) / block_cells;
  std::vector<int> block_iterations(blocks);
  std::vector<double> block_residuals(blocks);
  parallel_for(blocks, 1, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      const uint32_t first = static_cast<uint32_t>(b) * block_cells;
      const uint32_t count = std::min(block_cells, cells - first);
      std::vector<uint32_t> dates(count * order);
      std::iota(dates.begin(), dates.end(), first * order);
      const std::vector<Rgb> from_direct = direct_of_slots(work, direct, first, count);
      TransportInput of_block = input;
      of_block.direct = [&](size_t slot, size_t i) { return from_direct[slot * dates.size() + i]; };
      const NodeLight light = propagate(of_block, dates, 0);
      block_iterations[b] = light.iterations;
      block_residuals[b] = light.residual;
      for (const uint32_t l : lights) {
        if (l < tree.nodes().size()) {
          const size_t slot = tree.nodes()[l].slot;
          for (size_t d = 0; d < dates.size(); ++d)
            radiance.set(l, dates[d], light.radiance[slot * dates.size() + d]);
          continue;
        }
        const uint32_t face = l - static_cast<uint32_t>(tree.nodes().size());
        const Node& cluster = tree.nodes()[tree.node_of_face(face)];
        const LobeWeights w = lobes_of_normal(tree.face_normal(face));
        std::vector<Rgb> e = direct.irradiance(l, first, count);
        for (int i = 0; i < 3; ++i) {
          const Rgb* from = &light.irradiance[(cluster.slot + static_cast<size_t>(w.lobe[i])) * dates.size()];
          for (size_t d = 0; d < dates.size(); ++d) e[d] += w.weight[i] * from[d];
        }
        const Rgb brdf = surface_of(tree, l).brdf;
        for (size_t d = 0; d < dates.size(); ++d) radiance.set(l, dates[d], brdf * e[d]);
      }
    }
  });
  *iterations = *std::max_element(block_iterations.begin(), block_iterations.end());
  *residual = *std::max_element(block_residuals.begin(), block_residuals.end());
  return radiance;
}

double mean_radiance(const NodeTree& tree, const LightFunctions& radiance) {
  double sum = 0, area = 0;
  for (const uint32_t light : radiance.lights()) {
    double of_light = 0;
    for (size_t d = 0; d < radiance.dates(); ++d) {
      const Rgb l = radiance.get(light, d);
      of_light += (l.r + l.g + l.b) / 3;
    }
    if (!(of_light > 0)) continue;
    const double a = surface_of(tree, light).area;
    sum += a * of_light / static_cast<double>(radiance.dates());
    area += a;
  }
  return area > 0 ? sum / area : 0;
}

uint64_t settle_by_rays(const Workspace& work, const DirectOfLights& direct, LightFunctions* radiance) {
  const Bounce first = bounce(work, direct, radiance);
  const double before = total_of(work.tree, *radiance);
  const Bounce second = bounce(work, direct, radiance);
  const double after = total_of(work.tree, *radiance);
  if (!(after > 0)) return first.rays + second.rays;
  // L = D + T L: the share of light that was reflected before is what a bounce multiplies errors by. Done in
  // place it does better, for leaves see ever more that was corrected: e' = f (e - e0) along the way.
  const double f = std::clamp(1 - second.direct / after, 1e-3, 0.95);
  const double factor = 1 - (1 - f) * std::expm1(f) / f;
  const auto scale = static_cast<float>(1 + (after - before) / after * factor / (1 - factor));
  for (const uint32_t light : radiance->lights())
    for (size_t d = 0; d < radiance->dates(); ++d) radiance->set(light, d, scale * radiance->get(light, d));
  return first.rays + second.rays;
}

}  // namespace strad
