#include "solve/transport.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// Kernel of a dynamic link at each of the dates; zero outside its interval.
void kernel_at(const TimeGrid& grid, const LinkTable::Dynamic& link, const std::vector<uint32_t>& dates,
               float* kernel) {
  const auto order = static_cast<uint32_t>(grid.order);
  for (size_t i = 0; i < dates.size(); ++i) {
    const uint32_t cell = dates[i] / order;
    kernel[i] = 0;
    if (cell < link.interval.cell || cell >= link.interval.cell + link.interval.cell_count()) continue;
    const double s =
        (cell - link.interval.cell + gauss_nodes(grid.order)[dates[i] % order]) / link.interval.cell_count();
    double weights[kMaxOrder];
    lagrange_weights(grid.order, s, weights);
    for (uint32_t k = 0; k < order; ++k) kernel[i] += static_cast<float>(weights[k]) * link.kernel[k];
    kernel[i] = std::max(kernel[i], 0.0f);  // a polynomial may undershoot where visibility steps
  }
}

// Calls add(receiver, emitter, kernel of every date or nullptr, constant kernel) for all links at the dates.
class Gather {
 public:
  Gather(const TransportInput& input, const std::vector<uint32_t>& dates)
      : links_(*input.links), count_(dates.size()) {
    const auto order = static_cast<uint32_t>(input.grid->order);
    const uint32_t first = dates.front() / order, last = dates.back() / order;
    const size_t nodes = links_.first_dynamic.size() - 1;
    first_dynamic_.push_back(0);
    for (size_t p = 0; p < nodes; ++p) {
      for (uint32_t i = links_.first_dynamic[p]; i < links_.first_dynamic[p + 1]; ++i) {
        const LinkTable::Dynamic& link = links_.dynamic[i];
        if (link.interval.cell > last || link.interval.cell + link.interval.cell_count() <= first) continue;
        emitters_.push_back(link.emitter);
        kernels_.resize(kernels_.size() + count_);
        kernel_at(*input.grid, link, dates, kernels_.data() + kernels_.size() - count_);
      }
      first_dynamic_.push_back(static_cast<uint32_t>(emitters_.size()));
    }
  }

  // irradiance[receiver] += sum of kernel * radiance[emitter]; arrays of 3 * count floats a node.
  void run(const float* radiance, float* irradiance) const {
    const size_t width = 3 * count_;
    for (size_t p = 0; p + 1 < first_dynamic_.size(); ++p) {
      float* e = irradiance + p * width;
      for (uint32_t i = links_.first_still[p]; i < links_.first_still[p + 1]; ++i) {
        const float* l = radiance + links_.still[i].emitter * width;
        const float k = links_.still[i].kernel;
        for (size_t j = 0; j < width; ++j) e[j] += k * l[j];
      }
      for (uint32_t i = first_dynamic_[p]; i < first_dynamic_[p + 1]; ++i) {
        const float* l = radiance + emitters_[i] * width;
        const float* k = kernels_.data() + i * count_;
        for (size_t j = 0; j < count_; ++j)
          for (size_t c = 0; c < 3; ++c) e[3 * j + c] += k[j] * l[3 * j + c];
      }
    }
  }

 private:
  const LinkTable& links_;
  size_t count_;
  std::vector<uint32_t> first_dynamic_, emitters_;
  std::vector<float> kernels_;
};

void push(const NodeTree& tree, size_t width, float* irradiance) {
  const std::vector<Node>& nodes = tree.nodes();
  for (size_t n = 0; n < nodes.size(); ++n) {  // parents come before their children
    if (nodes[n].parent == kNone) continue;
    const float* from = irradiance + nodes[n].parent * width;
    float* to = irradiance + n * width;
    for (size_t j = 0; j < width; ++j) to[j] += from[j];
  }
}

void pull(const NodeTree& tree, size_t width, float* radiance) {
  const std::vector<Node>& nodes = tree.nodes();
  for (size_t n = nodes.size(); n-- > 0;) {
    if (nodes[n].first_child == kNone) continue;
    float* to = radiance + n * width;
    std::fill_n(to, width, 0.0f);
    float area = 0;
    for (uint32_t c = 0; c < 4; ++c) area += nodes[nodes[n].first_child + c].area;
    for (uint32_t c = 0; c < 4; ++c) {
      const uint32_t child = nodes[n].first_child + c;
      const float share = area > 0 ? nodes[child].area / area : 0.25f;
      const float* from = radiance + child * width;
      for (size_t j = 0; j < width; ++j) to[j] += share * from[j];
    }
  }
}

}  // namespace

LinkTable make_link_table(const TimeGrid& grid, uint32_t node_count, const std::vector<Link>& links) {
  LinkTable table;
  std::vector<uint32_t> order(links.size());
  for (uint32_t i = 0; i < links.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return links[a].receiver < links[b].receiver; });
  size_t next = 0;
  const uint32_t whole = grid.cell_count();
  for (uint32_t p = 0; p < node_count; ++p) {
    for (; next < order.size() && links[order[next]].receiver == p; ++next) {
      const Link& link = links[order[next]];
      const float* k = link.estimate.kernel;
      if (!link.estimate.dynamic && link.interval.cell_count() == whole) {
        if (k[0] > 0) table.still.push_back({link.emitter, k[0]});
      } else if (k[0] != 0 || k[1] != 0 || k[2] != 0) {
        table.dynamic.push_back({link.emitter, link.interval, {k[0], k[1], k[2]}});
      }
    }
    table.first_still.push_back(static_cast<uint32_t>(table.still.size()));
    table.first_dynamic.push_back(static_cast<uint32_t>(table.dynamic.size()));
  }
  return table;
}

TransportResult propagate(const TransportInput& input, const std::vector<uint32_t>& dates,
                          uint32_t first_column, std::vector<Rgb>* radiance) {
  const std::vector<Node>& nodes = input.tree->nodes();
  const size_t count = dates.size(), width = 3 * count;
  const Gather gather(input, dates);
  std::vector<Rgb> direct_at(nodes.size() * count);
  for (size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].first_child == kNone)
      for (size_t j = 0; j < count; ++j) direct_at[n * count + j] = input.direct(n, first_column + j);
  std::vector<float> irradiance(nodes.size() * width);
  radiance->assign(nodes.size() * count, {});
  float* l = &radiance->data()->r;
  TransportResult result;
  for (int i = 0; i <= input.max_iterations; ++i) {
    if (i > 0) {
      std::fill(irradiance.begin(), irradiance.end(), 0.0f);
      gather.run(l, irradiance.data());
      push(*input.tree, width, irradiance.data());
    }
    double change = 0, total = 0;
    for (size_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].first_child != kNone) continue;
      const float scale = input.balance->receiver[n], emitter_scale = input.balance->emitter[n];
      const Rgb brdf = (emitter_scale / static_cast<float>(kPi)) * nodes[n].reflectance;
      float moved = 0, sum = 0;
      for (size_t j = 0; j < count; ++j) {
        const float* e = irradiance.data() + n * width + 3 * j;
        const Rgb now = brdf * (direct_at[n * count + j] + scale * Rgb{e[0], e[1], e[2]});
        Rgb& before = (*radiance)[n * count + j];
        moved += std::abs(now.r - before.r) + std::abs(now.g - before.g) + std::abs(now.b - before.b);
        sum += now.r + now.g + now.b;
        before = now;
      }
      change += static_cast<double>(nodes[n].area) * moved;
      total += static_cast<double>(nodes[n].area) * sum;
    }
    pull(*input.tree, width, l);
    result = {i, total > 0 ? change / total : 0};
    if (result.residual < input.residual) break;
  }
  // Links saw radiance scaled for their balance; all others see it as it is.
  for (size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].first_child == kNone)
      for (size_t j = 0; j < count; ++j)
        (*radiance)[n * count + j] = (1 / input.balance->emitter[n]) * (*radiance)[n * count + j];
  pull(*input.tree, width, l);
  return result;
}

Balance balance(const TimeGrid& grid, const NodeTree& tree, const std::vector<Link>& links,
                const std::vector<float>& row_sums, const std::vector<float>& column_sums) {
  const std::vector<Node>& nodes = tree.nodes();
  Balance b{std::vector<float>(nodes.size(), 1.0f), std::vector<float>(nodes.size(), 1.0f)};
  // Mean kernel of each link over all time.
  std::vector<float> kernels(links.size(), 0.0f);
  for (size_t i = 0; i < links.size(); ++i) {
    const int dates = links[i].estimate.dynamic ? grid.order : 1;
    for (int k = 0; k < dates; ++k) kernels[i] += links[i].estimate.kernel[k] / static_cast<float>(dates);
    kernels[i] *=
        static_cast<float>((interval_end(grid, links[i].interval) - interval_begin(grid, links[i].interval)) /
                           std::max(1e-30, grid.spans.back().end - grid.spans.front().begin));
    if (grid.cell_count() == 1) kernels[i] = links[i].estimate.kernel[0];
  }
  // Row sums weigh what a receiver sees by the emitters' scale, column sums the other way round by
  // reciprocity. A scale beyond these bounds tells of a gap or a contact, where no sum is to be trusted.
  constexpr float kLowest = 0.6f, kHighest = 1.6f;
  std::vector<float> mean(nodes.size()), sum(nodes.size());
  const auto pull_means = [&](const std::vector<float>& scale) {
    for (size_t n = nodes.size(); n-- > 0;) {
      mean[n] = scale[n];
      if (nodes[n].first_child == kNone) continue;
      mean[n] = 0;
      for (uint32_t c = 0; c < 4; ++c) mean[n] += 0.25f * mean[nodes[n].first_child + c];
    }
  };
  const auto settle = [&](const std::vector<float>& wanted, std::vector<float>* scale) {
    for (size_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].parent != kNone) sum[n] += sum[nodes[n].parent];
      if (nodes[n].first_child == kNone && sum[n] > 0)
        (*scale)[n] = std::clamp(static_cast<float>(kPi) * wanted[n] / sum[n], kLowest, kHighest);
    }
  };
  for (int round = 0; round < 4; ++round) {
    pull_means(b.receiver);
    std::fill(sum.begin(), sum.end(), 0.0f);
    for (size_t i = 0; i < links.size(); ++i) {
      const Node &p = nodes[links[i].receiver], &q = nodes[links[i].emitter];
      sum[links[i].emitter] += kernels[i] * p.area / q.area * mean[links[i].receiver];
    }
    settle(column_sums, &b.emitter);
    pull_means(b.emitter);
    std::fill(sum.begin(), sum.end(), 0.0f);
    for (size_t i = 0; i < links.size(); ++i) sum[links[i].receiver] += kernels[i] * mean[links[i].emitter];
    settle(row_sums, &b.receiver);
  }
  return b;
}

}  // namespace strad
