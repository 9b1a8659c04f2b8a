#include "solve/links/transport.h"

#include <algorithm>
#include <cmath>

#include "solve/links/gather_links.h"

namespace strad {
namespace {

size_t slots_of(const Node& node) { return node.is_cluster() ? kLobes : 1; }

// Gives every node what its ancestors have gathered: immediate push.
void push(const NodeTree& tree, size_t width, float* irradiance) {
  for (const Node& node : tree.nodes()) {  // parents come before their children
    if (node.parent == kNone) continue;
    const Node& parent = tree.nodes()[node.parent];
    const float* from = irradiance + parent.slot * width;
    float* to = irradiance + node.slot * width;
    if (!parent.is_cluster() || node.is_cluster()) {
      for (size_t j = 0; j < slots_of(node) * width; ++j) to[j] += from[j];
      continue;
    }
    const LobeWeights w = lobes_of_normal(node.normal);
    for (int l = 0; l < 3; ++l)
      for (size_t j = 0; j < width; ++j)
        to[j] += w.weight[l] * from[static_cast<size_t>(w.lobe[l]) * width + j];
  }
}

// Mean radiance of every inner node from its children: delayed pull.
void pull(const NodeTree& tree, size_t width, float* radiance) {
  const std::vector<Node>& nodes = tree.nodes();
  for (size_t n = nodes.size(); n-- > 0;) {
    const Node& node = nodes[n];
    if (node.is_leaf()) continue;
    float* to = radiance + node.slot * width;
    std::fill_n(to, slots_of(node) * width, 0.0f);
    float area[kLobes] = {};
    const auto add = [&](size_t lobe, float a, const float* from) {
      area[lobe] += a;
      for (size_t j = 0; j < width; ++j) to[lobe * width + j] += a * from[j];
    };
    for (uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const Node& child = nodes[c];
      const float* from = radiance + child.slot * width;
      const float a = std::max(child.area, 1e-20f);
      if (!node.is_cluster()) {
        add(0, a, from);
      } else if (!child.is_cluster()) {
        const LobeWeights w = lobes_of_normal(child.normal);
        for (int l = 0; l < 3; ++l) add(static_cast<size_t>(w.lobe[l]), a * w.weight[l], from);
      } else {
        for (size_t l = 0; l < kLobes; ++l) add(l, a * tree.cluster(child).lobe_share[l], from + l * width);
      }
    }
    for (size_t l = 0; l < slots_of(node); ++l)
      for (size_t j = 0; j < width; ++j) to[l * width + j] *= area[l] > 0 ? 1 / area[l] : 0;
  }
}

std::vector<float> scales_of(const TransportInput& input, const LinkGather& gather, size_t count) {
  // A larger scale means a gap or a contact, where the sums are not reliable.
  constexpr float kHighest = 1.6f;
  const NodeTree& tree = *input.tree;
  std::vector<float> scales(tree.slot_count() * count, 1.0f);
  if (!input.form_factor_sums) return scales;
  const size_t width = 3 * count;
  const std::vector<float> unit(tree.slot_count() * width, 1.0f);
  std::vector<float> sums(tree.slot_count() * width, 0.0f);
  gather.run(unit.data(), sums.data());
  push(tree, width, sums.data());
  const auto all = static_cast<float>(kPi);  // irradiance from a full view of unit radiance
  for (size_t n = 0; n < tree.nodes().size(); ++n) {
    const Node& node = tree.nodes()[n];
    if (!node.is_leaf()) continue;
    for (size_t j = 0; j < count; ++j) {
      const auto sum_of = [&](size_t s) { return sums[(node.slot + s) * width + 3 * j]; };
      float mean = 0;
      for (size_t s = 0; s < slots_of(node); ++s)
        mean += sum_of(s) * (node.is_cluster() ? tree.cluster(node).lobe_share[s] : 1.0f);
      if (!(mean > 0)) continue;
      const float scale = std::min(all * (*input.form_factor_sums)[n] / mean, kHighest);
      for (size_t s = 0; s < slots_of(node); ++s)
        scales[(node.slot + s) * count + j] = scale * sum_of(s) > all ? all / sum_of(s) : scale;
    }
  }
  return scales;
}

// Radiance that leaves reflect of direct light, by slot and time sample.
std::vector<Rgb> direct_of_slots(const TransportInput& input, uint32_t first_column, size_t count) {
  std::vector<Rgb> direct(input.tree->slot_count() * count);
  for (const Node& node : input.tree->nodes())
    if (node.is_leaf())
      for (size_t s = node.slot; s < node.slot + slots_of(node); ++s)
        for (size_t j = 0; j < count; ++j) direct[s * count + j] = input.direct(s, first_column + j);
  return direct;
}

// How much a new radiance differs from the one before, summed over areas and time samples.
class RadianceChange {
 public:
  void set(Rgb* radiance, float area, Rgb now) {
    const Rgb& before = *radiance;
    change_ += area * static_cast<double>(std::abs(now.r - before.r) + std::abs(now.g - before.g) +
                                          std::abs(now.b - before.b));
    total_ += area * static_cast<double>(std::abs(now.r) + std::abs(now.g) + std::abs(now.b));
    *radiance = now;
  }
  double relative() const { return total_ > 0 ? change_ / total_ : 0; }

 private:
  double change_ = 0, total_ = 0;
};

// `e`: irradiance of a leaf cluster at all time samples, lobe after lobe; `direct` and `radiance` likewise.
void reflect_cluster(const TransportInput& input, const Node& node, size_t count, const Rgb* e,
                     const Rgb* direct, Rgb* radiance, RadianceChange* change) {
  const ClusterReflection& reflection = (*input.reflections)[node.cluster];
  for (size_t to = 0; to < kLobes; ++to) {
    const float area = node.area * input.tree->cluster(node).lobe_share[to];
    for (size_t j = 0; j < count; ++j) {
      Rgb now = direct[to * count + j];
      for (size_t from = 0; from < kLobes; ++from) now += reflection.radiance[to][from] * e[from * count + j];
      change->set(&radiance[to * count + j], area, now);
    }
  }
}

// Radiance of all leaves from what they have gathered, which is balanced by `scales`. Returns the relative
// change.
double reflect(const TransportInput& input, const std::vector<float>& scales, const std::vector<Rgb>& direct,
               size_t count, NodeLight* light) {
  RadianceChange change;
  for (const Node& node : input.tree->nodes()) {
    if (!node.is_leaf()) continue;
    const size_t first = node.slot * count;
    Rgb* e = &light->irradiance[first];
    for (size_t j = 0; j < slots_of(node) * count; ++j) e[j] = scales[first + j] * e[j];
    if (node.is_cluster()) {
      reflect_cluster(input, node, count, e, &direct[first], &light->radiance[first], &change);
      continue;
    }
    const Rgb brdf = node.coverage / static_cast<float>(kPi) * node.reflectance;
    for (size_t j = 0; j < count; ++j)
      change.set(&light->radiance[first + j], node.area, direct[first + j] + brdf * e[j]);
  }
  return change.relative();
}

}  // namespace

std::vector<ClusterReflection> reflections_of(const NodeTree& tree) {
  std::vector<ClusterReflection> all(tree.cluster_count());
  const auto& faces = tree.builder().mesh().faces;
  for (const Node& node : tree.nodes()) {
    if (!node.is_cluster() || !node.is_leaf()) continue;
    const Cluster& cluster = tree.cluster(node);
    Rgb(&m)[kLobes][kLobes] = all[node.cluster].radiance;
    float area[kLobes] = {};
    for (uint32_t i = cluster.first_face; i < cluster.first_face + cluster.face_count; ++i) {
      const uint32_t face = tree.cluster_faces()[i];
      const auto a = static_cast<float>(std::max(tree.face_area(face), 1e-12));
      const float covered = a * tree.face_coverage(face);
      const Material& material = tree.scene().materials[tree.scene().polygons[faces[face].polygon].material];
      const LobeWeights w = lobes_of_normal(tree.face_normal(face));
      for (int to = 0; to < 3; ++to) {
        area[w.lobe[to]] += a * w.weight[to];
        for (int from = 0; from < 3; ++from)
          m[w.lobe[to]][w.lobe[from]] +=
              (covered * w.weight[to] * w.weight[from] / static_cast<float>(kPi)) * material.reflectance;
      }
    }
    for (int to = 0; to < kLobes; ++to)
      for (Rgb& r : m[to]) r = (area[to] > 0 ? 1 / area[to] : 0) * r;
  }
  return all;
}

NodeLight propagate(const TransportInput& input, const std::vector<uint32_t>& time_samples,
                    uint32_t first_column) {
  const NodeTree& tree = *input.tree;
  const size_t count = time_samples.size(), width = 3 * count;
  const LinkGather gather(*input.grid, *input.tree, *input.links, *input.instants, time_samples);
  const std::vector<float> scales = scales_of(input, gather, count);
  const std::vector<Rgb> direct = direct_of_slots(input, first_column, count);
  NodeLight light;
  light.radiance.assign(tree.slot_count() * count, {});
  light.irradiance.assign(tree.slot_count() * count, {});
  float* radiance = &light.radiance.data()->r;
  float* irradiance = &light.irradiance.data()->r;
  for (int i = 0; i <= input.max_iterations; ++i) {
    if (i > 0) {
      std::fill(light.irradiance.begin(), light.irradiance.end(), Rgb{});
      gather.run(radiance, irradiance);
      push(tree, width, irradiance);
    }
    light.residual = reflect(input, scales, direct, count, &light);
    pull(tree, width, radiance);
    light.iterations = i;
    if (light.residual < input.residual) break;
  }
  return light;
}

std::vector<float> balance(const TransportInput& input, const std::vector<uint32_t>& time_samples) {
  return scales_of(input, LinkGather(*input.grid, *input.tree, *input.links, *input.instants, time_samples),
                   time_samples.size());
}

}  // namespace strad
