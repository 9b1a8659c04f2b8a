#include "solve/links/gather_links.h"

#include <algorithm>

namespace strad {
namespace {

constexpr size_t kMostSamples = 64;  // time samples of a block

// Kernel of a dynamic link at each of the time samples; zero outside its interval.
void kernel_at(const TimeGrid& grid, const LinkTable::Dynamic& link,
               const std::vector<uint32_t>& time_samples, float* kernel) {
  const auto order = static_cast<uint32_t>(grid.order);
  for (size_t i = 0; i < time_samples.size(); ++i) {
    const uint32_t cell = time_samples[i] / order;
    kernel[i] = 0;
    if (cell < link.interval.cell || cell >= link.interval.cell + link.interval.cell_count()) continue;
    const double s = (cell - link.interval.cell + gauss_nodes(grid.order)[time_samples[i] % order]) /
                     link.interval.cell_count();
    double weights[kMaxOrder];
    lagrange_weights(grid.order, s, weights);
    for (uint32_t k = 0; k < order; ++k) kernel[i] += static_cast<float>(weights[k]) * link.kernel[k];
    kernel[i] = std::max(kernel[i], 0.0f);  // near a step of visibility, a polynomial may fall below 0
  }
}

}  // namespace

LinkGather::LinkGather(const TimeGrid& grid, const NodeTree& tree, const LinkTable& links,
                       const std::vector<Instant>& instants, const std::vector<uint32_t>& time_samples)
    : tree_(tree), links_(links), count_(time_samples.size()) {
  for (const uint32_t time_sample : time_samples) instants_.push_back(&instants[time_sample]);
  const auto order = static_cast<uint32_t>(grid.order);
  const uint32_t first = time_samples.front() / order, last = time_samples.back() / order;
  const size_t nodes = links_.first_dynamic.size() - 1;
  first_dynamic_.push_back(0);
  for (size_t p = 0; p < nodes; ++p) {
    for (uint32_t i = links_.first_dynamic[p]; i < links_.first_dynamic[p + 1]; ++i) {
      const LinkTable::Dynamic& link = links_.dynamic[i];
      if (link.interval.cell > last || link.interval.cell + link.interval.cell_count() <= first) continue;
      emitters_.push_back(link.emitter);
      kernels_.resize(kernels_.size() + count_);
      kernel_at(grid, link, time_samples, kernels_.data() + kernels_.size() - count_);
    }
    first_dynamic_.push_back(static_cast<uint32_t>(emitters_.size()));
  }
}

// The vector from one node's centre to another's at a time sample, in the frame of the first one's body.
Vec3 LinkGather::towards(const Node& from, const Node& to, size_t time_sample) const {
  if (from.body == to.body) return to.centre - from.centre;
  const std::vector<Pose>& poses = instants_[time_sample]->world_from_body;
  return rotate_back(poses[from.body], poses[to.body] * to.centre - poses[from.body] * from.centre);
}

LinkGather::End LinkGather::receiving_end(const Node& p, const Node& q, size_t time_sample) const {
  if (!p.is_cluster()) return {{p.slot}, {1}, 1};
  End end{{}, {}, 3};
  if (!(length2(towards(p, q, time_sample)) > 0)) {  // no direction, so all lobes take part alike
    for (uint32_t l = 0; l < kLobes; ++l) end.slot[l] = p.slot + l, end.weight[l] = 1;
    end.count = kLobes;
    return end;
  }
  const LobeWeights w = lobes_towards(towards(p, q, time_sample), tree_.cluster(p).lobe_share);
  for (int l = 0; l < 3; ++l) {
    end.slot[l] = p.slot + static_cast<uint32_t>(w.lobe[l]);
    end.weight[l] = w.weight[l];
  }
  return end;
}

// The radiance of a cluster is the mean over its lobes, weighted by the area that each shows.
LinkGather::End LinkGather::emitting_end(const Node& p, const Node& q, size_t time_sample) const {
  End end = receiving_end(q, p, time_sample);
  if (!q.is_cluster()) return end;
  float sum = 0;
  for (int l = 0; l < end.count; ++l) {
    end.weight[l] *= tree_.cluster(q).lobe_share[end.slot[l] - q.slot];
    sum += end.weight[l];
  }
  for (float& w : end.weight) w = sum > 0 ? w / sum : 0;
  return end;
}

void LinkGather::add_still(const Node& p, const Node& q, float kernel, const float* radiance,
                           float* irradiance) const {
  const size_t width = 3 * count_;
  const End from = emitting_end(p, q, 0), to = receiving_end(p, q, 0);
  float carried[3 * kMostSamples] = {};
  for (int e = 0; e < from.count; ++e) {
    const float* l = radiance + from.slot[e] * width;
    const float w = kernel * from.weight[e];
    for (size_t j = 0; j < width; ++j) carried[j] += w * l[j];
  }
  for (int r = 0; r < to.count; ++r) {
    float* to_slot = irradiance + to.slot[r] * width;
    const float w = to.weight[r];
    for (size_t j = 0; j < width; ++j) to_slot[j] += w * carried[j];
  }
}

void LinkGather::add(const Node& p, const Node& q, const float* kernel, const float* radiance,
                     float* irradiance) const {
  const size_t width = 3 * count_;
  for (size_t j = 0; j < count_; ++j) {
    if (!(kernel[j] > 0)) continue;
    const End from = emitting_end(p, q, j), to = receiving_end(p, q, j);
    float carried[3] = {};
    for (int e = 0; e < from.count; ++e)
      for (size_t c = 0; c < 3; ++c)
        carried[c] += kernel[j] * from.weight[e] * radiance[from.slot[e] * width + 3 * j + c];
    for (int r = 0; r < to.count; ++r)
      for (size_t c = 0; c < 3; ++c) irradiance[to.slot[r] * width + 3 * j + c] += to.weight[r] * carried[c];
  }
}

void LinkGather::run(const float* radiance, float* irradiance) const {
  const std::vector<Node>& nodes = tree_.nodes();
  const size_t width = 3 * count_;
  for (size_t n = 0; n + 1 < first_dynamic_.size(); ++n) {
    const Node& p = nodes[n];
    float* e = irradiance + p.slot * width;
    for (uint32_t i = links_.first_still[n]; i < links_.first_still[n + 1]; ++i) {
      const Node& q = nodes[links_.still[i].emitter];
      const float k = links_.still[i].kernel;
      if (p.is_cluster() || q.is_cluster()) {
        add_still(p, q, k, radiance, irradiance);
        continue;
      }
      const float* l = radiance + q.slot * width;
      for (size_t j = 0; j < width; ++j) e[j] += k * l[j];
    }
    for (uint32_t i = first_dynamic_[n]; i < first_dynamic_[n + 1]; ++i) {
      const Node& q = nodes[emitters_[i]];
      const float* k = kernels_.data() + i * count_;
      if (p.is_cluster() || q.is_cluster()) {
        add(p, q, k, radiance, irradiance);
        continue;
      }
      const float* l = radiance + q.slot * width;
      for (size_t j = 0; j < count_; ++j)
        for (size_t c = 0; c < 3; ++c) e[3 * j + c] += k[j] * l[3 * j + c];
    }
  }
}

}  // namespace strad
