#include "solve/links/refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/parallel.h"

namespace strad {
namespace {

constexpr size_t kBatch = 65536;  // links looked at together

float largest(Rgb a) { return std::max({std::abs(a.r), std::abs(a.g), std::abs(a.b)}); }

}  // namespace

Refinement::Refinement(const TimeGrid& grid, const KernelEvaluator& kernels, const DirectPhase& direct,
                       const std::vector<uint32_t>& time_samples, NodeTree* tree)
    : grid_(grid), kernels_(kernels), direct_phase_(direct), probe_samples_(time_samples), tree_(*tree) {
  for (const uint32_t time_sample : probe_samples_) {
    const uint32_t cell = time_sample / static_cast<uint32_t>(grid_.order);
    if (cells_.empty() || cells_.back() != cell) cells_.push_back(cell);
  }
  for (const Node& node : tree_.nodes()) total_area_ += 0.5 * node.area;  // both sides are nodes
  describe_new_nodes(0);
  linked_.assign(tree_.nodes().size(), false);
}

std::vector<Rgb> Refinement::direct_at_probes(uint32_t element) const {
  const auto order = static_cast<uint32_t>(grid_.order);
  const std::vector<Rgb> of_cells = direct_phase_.mean_irradiance(element, cells_);
  std::vector<Rgb> probe_samples;
  size_t cell = 0;
  for (const uint32_t time_sample : probe_samples_) {
    while (cells_[cell] != time_sample / order) ++cell;
    probe_samples.push_back(of_cells[cell * order + time_sample % order]);
  }
  return probe_samples;
}

void Refinement::describe_new_nodes(size_t first) {
  const std::vector<Node>& nodes = tree_.nodes();
  direct_.resize(tree_.slot_count() * probe_samples_.size());
  brightest_.resize(nodes.size() * probe_samples_.size());
  spread_.resize(nodes.size() * probe_samples_.size());
  weight_.resize(nodes.size() * probe_samples_.size(), 1);
  parallel_for(nodes.size() - first, 4, [&](size_t begin, size_t end) {
    for (size_t n = first + begin; n < first + end; ++n)
      nodes[n].is_cluster() ? describe_cluster(static_cast<uint32_t>(n))
                            : describe_patch(static_cast<uint32_t>(n));
  });
  // Until the next propagation a new node reflects as much indirect light as its parent.
  for (size_t n = first; n < nodes.size(); ++n) {
    if (nodes[n].parent == kNone) continue;
    const Node& parent = tree_.nodes()[nodes[n].parent];
    for (size_t i = 0; i < probe_samples_.size(); ++i) {
      weight_[n * probe_samples_.size() + i] = weight_[nodes[n].parent * probe_samples_.size() + i];
      float of_parent = 0;
      for (size_t s = 0; s < (parent.is_cluster() ? kLobes : 1u); ++s)
        of_parent = std::max(of_parent, largest(direct(parent.slot + s, i)));
      brightest_[n * probe_samples_.size() + i] +=
          std::max(0.0f, brightest_[nodes[n].parent * probe_samples_.size() + i] - of_parent);
    }
  }
}

// Radiance of direct light, and how it varies over the quarters.
void Refinement::describe_patch(uint32_t n) {
  const Node& node = tree_.nodes()[n];
  const size_t count = probe_samples_.size();
  const Rgb brdf = node.coverage / static_cast<float>(kPi) * node.reflectance;
  const std::vector<Rgb> own = direct_at_probes(node.element);
  for (size_t i = 0; i < count; ++i) {
    direct_[node.slot * count + i] = brdf * own[i];
    brightest_[n * count + i] = largest(direct_[node.slot * count + i]);
  }
  const uint32_t first = tree_.builder().mesh().elements[node.element].first_child;
  if (first == kNone) return;
  for (uint32_t c = 0; c < 4; ++c) {
    const std::vector<Rgb> quarter = direct_at_probes(first + c);
    for (size_t i = 0; i < count; ++i) {
      const float d = largest(brdf * (quarter[i] - own[i]));
      spread_[n * count + i] += d * d / 4;
    }
  }
  for (size_t i = 0; i < count; ++i) spread_[n * count + i] = std::sqrt(spread_[n * count + i]);
}

void Refinement::describe_cluster(uint32_t n) {
  const Node& node = tree_.nodes()[n];
  const Cluster& cluster = tree_.cluster(node);
  const size_t count = probe_samples_.size();
  std::vector<Rgb> faces;  // [face][time sample]
  for (uint32_t i = cluster.first_face; i < cluster.first_face + cluster.face_count; ++i) {
    const Face& face = tree_.builder().mesh().faces[tree_.cluster_faces()[i]];
    const Rgb reflectance =
        tree_.scene().materials[tree_.scene().polygons[face.polygon].material].reflectance;
    const float coverage = tree_.face_coverage(tree_.cluster_faces()[i]);
    for (const Rgb& e : direct_at_probes(face.element))
      faces.push_back(coverage / static_cast<float>(kPi) * (reflectance * e));
  }
  const auto for_faces = [&](const auto& visit) {
    for (uint32_t i = 0; i < cluster.face_count; ++i) {
      const uint32_t face = tree_.cluster_faces()[cluster.first_face + i];
      visit(static_cast<float>(std::max(tree_.face_area(face), 1e-12)) / node.area,
            lobes_of_normal(tree_.face_normal(face)), &faces[i * count]);
    }
  };
  Rgb* lobes = &direct_[node.slot * count];
  std::fill_n(lobes, kLobes * count, Rgb{});
  for_faces([&](float share, const LobeWeights& w, const Rgb* radiance) {
    for (int l = 0; l < 3; ++l) {
      const float part = share * w.weight[l] / std::max(cluster.lobe_share[w.lobe[l]], 1e-20f);
      for (size_t d = 0; d < count; ++d)
        lobes[static_cast<size_t>(w.lobe[l]) * count + d] += part * radiance[d];
    }
  });
  float* spread = &spread_[n * count];
  for_faces([&](float share, const LobeWeights& w, const Rgb* radiance) {
    for (size_t d = 0; d < count; ++d) {
      Rgb represented;
      for (int l = 0; l < 3; ++l)
        represented += w.weight[l] * lobes[static_cast<size_t>(w.lobe[l]) * count + d];
      const float differs = largest(radiance[d] - represented);
      spread[d] += share * differs * differs;
    }
  });
  for (size_t d = 0; d < count; ++d) {
    spread[d] = std::sqrt(spread[d]);
    for (size_t l = 0; l < kLobes; ++l)
      brightest_[n * count + d] = std::max(brightest_[n * count + d], largest(lobes[l * count + d]));
  }
}

void Refinement::update_light(size_t first, size_t count, const NodeLight& light) {
  const std::vector<Node>& nodes = tree_.nodes();
  const size_t probes = probe_samples_.size();
  local_.resize(nodes.size() * probes);
  std::vector<float> area(nodes.size(), 0);
  for (size_t n = nodes.size(); n-- > 0;) {  // children come after their parents
    const Node& node = nodes[n];
    area[n] += node.is_leaf() ? std::max(node.area, 1e-20f) : 0;
    for (size_t d = 0; d < count; ++d) {
      float& local = local_[n * probes + first + d];
      if (node.is_leaf()) local = 0;
      float brightest = 0;
      for (size_t s = 0; s < (node.is_cluster() ? kLobes : 1u); ++s) {
        const Rgb radiance = light.radiance[(node.slot + s) * count + d];
        brightest = std::max(brightest, max_channel(radiance));
        if (!node.is_leaf()) continue;
        const float share = node.is_cluster() ? tree_.cluster(node).lobe_share[s] : 1;
        const Rgb seen = static_cast<float>(1 / kPi) * light.irradiance[(node.slot + s) * count + d];
        local += share * std::max(max_channel(radiance), max_channel(seen));
      }
      brightest_[n * probes + first + d] = brightest;
      if (node.is_leaf()) local *= area[n];
      if (node.parent != kNone) local_[node.parent * probes + first + d] += local;
      local /= area[n];
    }
    if (node.parent != kNone) area[node.parent] += area[n];
  }
}

void Refinement::weigh_by_local_light(double mean, double dark) {
  const std::vector<Node>& nodes = tree_.nodes();
  const size_t probes = probe_samples_.size();
  // The brightest tenth of the area, at all probe time samples together.
  std::vector<std::pair<float, float>> by_brightness;
  double area = 0, bright_area = 0, bright = 0;
  for (size_t n = 0; n < nodes.size(); ++n) {
    if (!nodes[n].is_leaf()) continue;
    for (size_t i = 0; i < probes; ++i) by_brightness.emplace_back(local_[n * probes + i], nodes[n].area);
    area += static_cast<double>(probes) * nodes[n].area;
  }
  std::sort(by_brightness.begin(), by_brightness.end());
  while (!by_brightness.empty() && bright_area < 0.1 * area) {
    bright += double{by_brightness.back().first} * by_brightness.back().second;
    bright_area += by_brightness.back().second;
    by_brightness.pop_back();
  }
  const double floor = bright_area > 0 ? dark * bright / bright_area : 0;
  weight_.assign(nodes.size() * probes, 1);
  if (!(floor > 0)) return;
  for (size_t i = 0; i < weight_.size(); ++i)
    weight_[i] = static_cast<float>(std::max(1.0, mean / std::max(double{local_[i]}, floor)));
}

Refinement::Shading Refinement::shading_of(uint32_t n) const {
  const Node& node = tree_.nodes()[n];
  const size_t probes = probe_samples_.size();
  Shading sum{0, 0, 0};
  for (size_t i = 0; i < probes; ++i) {
    const float radiance = brightest_[n * probes + i];
    sum.radiance += radiance;
    sum.weight += weight_[n * probes + i];
    if (node.is_leaf()) {
      sum.spread += spread_[n * probes + i];
      continue;
    }
    float squares = 0;
    for (uint32_t c = 0; c < node.child_count; ++c) {
      const float d = brightest_[(node.first_child + c) * probes + i] - radiance;
      squares += d * d;
    }
    sum.spread += std::sqrt(squares / static_cast<float>(node.child_count));
  }
  const float share = 1 / static_cast<float>(probes);
  return {share * sum.radiance, share * sum.spread, share * sum.weight};
}

// Radiance weighted by what errors count at the receiver at that time.
Refinement::Brightness Refinement::brightness(const Link& link) const {
  Brightness b;
  const auto order = static_cast<uint32_t>(grid_.order);
  const size_t probes = probe_samples_.size();
  for (size_t i = 0; i < probes; ++i) {
    const uint32_t cell = probe_samples_[i] / order;
    if (cell < link.interval.cell || cell >= link.interval.cell + link.interval.cell_count()) continue;
    const float weight = weight_[link.receiver * probes + i];
    b.radiance = std::max(b.radiance, weight * brightest_[link.emitter * probes + i]);
    b.spread = std::max(b.spread, weight * spread_[link.emitter * probes + i]);
  }
  return b;
}

// From irradiance to the error that counts.
double Refinement::scale_of(const Node& receiver) const {
  return max_channel(receiver.reflectance) * std::sqrt(receiver.area / total_area_) / kPi;
}

bool Refinement::can_split(const Node& node, const RefinementOptions& options) const {
  return node.is_cluster()
             ? node.radius > options.smallest_radius
             : node.radius > options.smallest_radius && node.face >= tree_.builder().undivided_faces();
}

// What can be told of a link before a single ray.
Refinement::Action Refinement::decide_unseen(const Link& link, const RefinementOptions& options) const {
  const Node &p = tree_.nodes()[link.receiver], &q = tree_.nodes()[link.emitter];
  if (!p.is_cluster() && !q.is_cluster() && p.face == q.face) return Action::kDrop;  // they lie in one plane
  // Dark at some time samples is not enough: the sums of kernels must not depend on what is lit.
  if (!is_lit(link.emitter)) return Action::kWait;
  // Where boxes meet the whole view may be filled, and from anywhere.
  if (brightness(link).radiance * 0.5 * kPi * scale_of(p) <= options.threshold) return Action::kUnknown;
  if (!kernels_.overlap(link.receiver, link.emitter, link.interval)) return Action::kUnknown;
  const bool can_receiver = can_split(p, options), can_emitter = can_split(q, options);
  if (can_emitter && (q.radius > p.radius || !can_receiver)) return Action::kSplitEmitter;
  return can_receiver ? Action::kSplitReceiver : Action::kUnknown;
}

Refinement::Action Refinement::decide(const Link& link, const RefinementOptions& options) const {
  const KernelEstimate& e = link.estimate;
  const Node &p = tree_.nodes()[link.receiver], &q = tree_.nodes()[link.emitter];
  if (e.kernel[0] == 0 && e.kernel[1] == 0 && e.kernel[2] == 0 && e.receiver_error == 0 && e.time_error == 0)
    return e.dynamic ? Action::kAccept : Action::kDrop;
  const Brightness bright = brightness(link);
  const double scale = scale_of(p);
  const double of_receiver = e.receiver_error * bright.radiance * scale;
  const double of_emitter = e.emitter_error * bright.spread * scale;
  const double of_time = e.time_error * bright.radiance * scale;
  if (of_receiver * of_receiver + of_emitter * of_emitter + of_time * of_time <=
      options.threshold * options.threshold)
    return Action::kAccept;
  const bool can_time = link.interval.log2_cells > options.smallest_interval;
  const bool can_receiver = can_split(p, options), can_emitter = can_split(q, options);
  if (can_time && of_time > std::max(of_receiver, of_emitter)) return Action::kSplitTime;
  if (link.receiver == link.emitter && can_receiver) return Action::kSplitReceiver;
  // Partial visibility and nearness show at the receiver, but halving the larger end cures them fastest.
  const bool prefer_emitter = of_emitter > of_receiver || q.area > 2 * p.area;
  if (can_emitter && (prefer_emitter || !can_receiver)) return Action::kSplitEmitter;
  if (can_receiver) return Action::kSplitReceiver;
  if (can_time && of_time > options.threshold) return Action::kSplitTime;
  return Action::kAccept;
}

void Refinement::split_nodes(const std::vector<uint32_t>& nodes) {
  const size_t before = tree_.nodes().size();
  for (const uint32_t n : nodes)
    if (tree_.nodes()[n].is_leaf()) tree_.split(n);
  describe_new_nodes(before);
}

std::vector<Link> Refinement::children_of(const Link& link, Action action) {
  std::vector<Link> children;
  const Node &p = tree_.nodes()[link.receiver], &q = tree_.nodes()[link.emitter];
  if (action == Action::kSplitTime) {
    ++counts_.refined_in_time;
    const Interval left{link.interval.cell, link.interval.log2_cells - 1};
    children.push_back({link.receiver, link.emitter, left, {}});
    children.push_back({link.receiver, link.emitter, {left.cell + left.cell_count(), left.log2_cells}, {}});
    return children;
  }
  ++counts_.refined_in_space;
  const bool both = link.receiver == link.emitter;  // a cluster and itself: every child and every child
  const bool receiver = action == Action::kSplitReceiver || both,
             emitter = action == Action::kSplitEmitter || both;
  const uint32_t first_p = receiver ? p.first_child : link.receiver, count_p = receiver ? p.child_count : 1;
  const uint32_t first_q = emitter ? q.first_child : link.emitter, count_q = emitter ? q.child_count : 1;
  for (uint32_t i = first_p; i < first_p + count_p; ++i)
    for (uint32_t j = first_q; j < first_q + count_q; ++j)
      if (i != j || tree_.nodes()[i].is_cluster()) children.push_back({i, j, link.interval, {}});
  return children;
}

bool Refinement::is_lit(uint32_t node) const {
  const auto begin = brightest_.begin() + static_cast<ptrdiff_t>(node * probe_samples_.size());
  return std::any_of(begin, begin + static_cast<ptrdiff_t>(probe_samples_.size()),
                     [](float l) { return l > 0; });
}

void Refinement::refine(const RefinementOptions& options) {
  std::vector<Link> work = std::move(links_);
  work.insert(work.end(), waiting_.begin(), waiting_.end());
  links_ = {};
  waiting_ = {};
  refine(std::move(work), options);
  // Where the solve starts: all pairs of roots, over each span of time.
  const auto roots = static_cast<uint32_t>(linked_.size());
  work = {};
  for (uint32_t q = 0; q < roots; ++q) {
    if (linked_[q] || !is_lit(q)) continue;
    linked_[q] = true;
    for (uint32_t p = 0; p < roots; ++p)
      if (p != q || tree_.nodes()[p].is_cluster())
        for (const Span& span : grid_.spans) work.push_back({p, q, {span.first_cell, span.log2_cells}, {}});
    if (work.size() < kBatch && q + 1 < roots) continue;
    refine(std::move(work), options);
    work = {};
  }
  refine(std::move(work), options);
}

std::vector<Refinement::Action> Refinement::decide_all(const RefinementOptions& options,
                                                       std::vector<Link>* batch) {
  constexpr size_t kGrain = 64;
  std::vector<Action> actions(batch->size(), Action::kUnknown);
  std::vector<KernelCounts> counts(batch->size() / kGrain + 1);
  parallel_for(counts.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = kGrain * begin; i < std::min(kGrain * end, batch->size()); ++i) {
      Link& link = (*batch)[i];
      if (!link.estimate.known) {
        actions[i] = decide_unseen(link, options);
        if (actions[i] != Action::kUnknown) continue;
        link.estimate = kernels_.estimate(link.receiver, link.emitter, link.interval, &counts[i / kGrain]);
      }
      actions[i] = decide(link, options);
    }
  });
  for (const KernelCounts& c : counts) {
    counts_.rays += c.rays;
    counts_.evaluations += c.evaluations;
  }
  return actions;
}

// Depth first in batches: what waits stays short however many pairs there are.
void Refinement::refine(std::vector<Link> work, const RefinementOptions& options) {
  while (!work.empty()) {
    const auto first = work.end() - static_cast<ptrdiff_t>(std::min(work.size(), kBatch));
    std::vector<Link> batch(first, work.end());
    work.erase(first, work.end());
    const std::vector<Action> actions = decide_all(options, &batch);
    std::vector<uint32_t> to_split;
    for (size_t i = 0; i < batch.size(); ++i) {
      if (actions[i] == Action::kSplitReceiver) to_split.push_back(batch[i].receiver);
      if (actions[i] == Action::kSplitEmitter) to_split.push_back(batch[i].emitter);
    }
    split_nodes(to_split);
    for (size_t i = 0; i < batch.size(); ++i) {
      if (actions[i] == Action::kDrop) continue;
      if (actions[i] == Action::kAccept) {
        links_.push_back(batch[i]);
      } else if (actions[i] == Action::kWait) {
        waiting_.push_back(batch[i]);
      } else {
        const std::vector<Link> children = children_of(batch[i], actions[i]);
        work.insert(work.end(), children.begin(), children.end());
      }
    }
  }
}

}  // namespace strad
