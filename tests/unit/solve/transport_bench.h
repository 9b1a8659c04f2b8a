// Links made by hand and light that goes along them, for tests.
#pragma once

#include <functional>
#include <initializer_list>
#include <vector>

#include "solve/links/transport.h"
#include "workbench.h"

namespace strad {

inline Link link_of(uint32_t receiver, uint32_t emitter, Interval interval,
                    std::initializer_list<float> kernel) {
  Link link;
  link.receiver = receiver;
  link.emitter = emitter;
  link.interval = interval;
  link.estimate.dynamic = kernel.size() > 1;
  std::fill(link.estimate.kernel, link.estimate.kernel + kMaxOrder, *kernel.begin());
  std::copy(kernel.begin(), kernel.end(), link.estimate.kernel);
  return link;
}

// Light along `links` at all time samples of a bench.
struct Transport {
  const Workbench& bench;
  LinkTable table;
  std::vector<ClusterReflection> reflections;
  TransportInput input;

  Transport(const Workbench& b, const std::vector<Link>& links)
      : bench(b),
        table(make_link_table(b.grid, static_cast<uint32_t>(b.nodes->nodes().size()), links)),
        reflections(reflections_of(*b.nodes)) {
    input.grid = &bench.grid, input.tree = bench.nodes.get(), input.instants = &bench.instants;
    input.links = &table, input.reflections = &reflections;
    input.residual = 1e-6;
  }
  Transport(const Transport&) = delete;

  std::vector<uint32_t> time_samples() const {
    std::vector<uint32_t> all;
    for (uint32_t t = 0; t < bench.grid.sample_count(); ++t) all.push_back(t);
    return all;
  }
  // `direct`: radiance reflected of direct light, by slot.
  NodeLight solve(const std::function<Rgb(size_t slot)>& direct) {
    input.direct = [&](size_t slot, size_t) { return direct(slot); };
    return propagate(input, time_samples(), 0);
  }
  Rgb radiance(const NodeLight& light, uint32_t node, uint32_t time_sample = 0, uint32_t lobe = 0) const {
    return light.radiance[(bench.node(node).slot + lobe) * bench.grid.sample_count() + time_sample];
  }
  Rgb irradiance(const NodeLight& light, uint32_t node, uint32_t time_sample = 0, uint32_t lobe = 0) const {
    return light.irradiance[(bench.node(node).slot + lobe) * bench.grid.sample_count() + time_sample];
  }
  // Mean over the lobes of a cluster.
  Rgb mean_radiance(const NodeLight& light, uint32_t node) const {
    Rgb sum;
    for (uint32_t l = 0; l < kLobes; ++l)
      sum += bench.cluster(node).lobe_share[l] * radiance(light, node, 0, l);
    return sum;
  }
};

// Links between two nodes as fine as needed for a relative error of `error` of all that p can receive.
// Clusters whose boxes meet are split, of what else errs the larger end is.
inline void make_links(Workbench* bench, uint32_t p, uint32_t q, float error, float smallest_radius,
                       std::vector<Link>* links) {
  const auto split = [&](uint32_t n) {
    return bench->node(n).is_cluster() || bench->node(n).radius > smallest_radius;
  };
  if (!bench->node(p).is_cluster() && bench->node(p).face == bench->node(q).face) return;
  const Interval always = bench->always();
  if (p != q || !bench->node(p).is_cluster()) {
    const bool larger_p = bench->node(p).radius > bench->node(q).radius;
    const bool meet = bench->kernels->overlap(p, q, always);
    const KernelEstimate e = meet ? KernelEstimate{} : bench->estimate(p, q, always);
    const bool fine = !meet && e.receiver_error + e.emitter_error <= error;
    if (fine || (!split(p) && !split(q))) {
      if (!meet && e.kernel[0] > 0) links->push_back({p, q, always, e});
      return;
    }
    if ((larger_p && split(p)) || !split(q)) {
      for (const uint32_t c : bench->children_of(p)) make_links(bench, c, q, error, smallest_radius, links);
    } else {
      for (const uint32_t c : bench->children_of(q)) make_links(bench, p, c, error, smallest_radius, links);
    }
    return;
  }
  const std::vector<uint32_t> children = bench->children_of(p);
  for (const uint32_t a : children)
    for (const uint32_t b : children)
      if (a != b || bench->node(a).is_cluster()) make_links(bench, a, b, error, smallest_radius, links);
}

}  // namespace strad
