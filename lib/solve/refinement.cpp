#include "solve/refinement.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace strad {

Refinement::Refinement(const TimeGrid& grid, const KernelEvaluator& kernels, const DirectPhase& direct,
                       const std::vector<uint32_t>& dates, NodeTree* tree)
    : grid_(grid), kernels_(kernels), direct_phase_(direct), dates_(dates), tree_(*tree) {
  for (const uint32_t date : dates_) {
    const uint32_t cell = date / static_cast<uint32_t>(grid_.order);
    if (cells_.empty() || cells_.back() != cell) cells_.push_back(cell);
  }
  const size_t roots = tree_.nodes().size();
  direct_.resize(roots);
  radiance_.resize(roots);
  spread_.resize(roots);
  linked_.assign(roots, false);
  for (const Node& node : tree_.nodes()) total_area_ += 0.5 * node.area;  // both sides are nodes
  parallel_for(roots, 1, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) describe(static_cast<uint32_t>(n));
  });
}

std::vector<Rgb> Refinement::watched_direct(uint32_t element) const {
  const auto order = static_cast<uint32_t>(grid_.order);
  const std::vector<Rgb> of_cells = direct_phase_.mean_irradiance(element, cells_);
  std::vector<Rgb> watched;
  size_t cell = 0;
  for (const uint32_t date : dates_) {
    while (cells_[cell] != date / order) ++cell;
    watched.push_back(of_cells[cell * order + date % order]);
  }
  return watched;
}

// Direct irradiance of a new node, its radiance as far as known, and how that varies over its quarters.
void Refinement::describe(uint32_t n) {
  const Node& node = tree_.nodes()[n];
  direct_[n] = watched_direct(node.element);
  const Rgb brdf = static_cast<float>(1 / kPi) * node.reflectance;
  radiance_[n].resize(dates_.size());
  for (size_t i = 0; i < dates_.size(); ++i) {
    radiance_[n][i] = brdf * direct_[n][i];
    if (node.parent == kNone) continue;
    const Rgb reflected = radiance_[node.parent][i] - brdf * direct_[node.parent][i];
    radiance_[n][i] +=
        Rgb{std::max(0.0f, reflected.r), std::max(0.0f, reflected.g), std::max(0.0f, reflected.b)};
  }
  spread_[n].assign(dates_.size(), 0.0f);
  const uint32_t first = tree_.builder().mesh().elements[node.element].first_child;
  if (first == kNone) return;
  for (uint32_t c = 0; c < 4; ++c) {
    const std::vector<Rgb> quarter = watched_direct(first + c);
    for (size_t i = 0; i < dates_.size(); ++i) {
      const Rgb d = brdf * (quarter[i] - direct_[n][i]);
      const float largest = std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)});
      spread_[n][i] += largest * largest / 4;
    }
  }
  for (float& s : spread_[n]) s = std::sqrt(s);
}

bool Refinement::is_lit(uint32_t node) const {
  return std::any_of(radiance_[node].begin(), radiance_[node].end(),
                     [](Rgb l) { return max_channel(l) > 0; });
}

void Refinement::update_radiance(const std::vector<Rgb>& radiance) {
  for (size_t n = 0; n < radiance_.size(); ++n)
    std::copy_n(radiance.begin() + static_cast<ptrdiff_t>(n * dates_.size()), dates_.size(),
                radiance_[n].begin());
}

Refinement::Action Refinement::decide(const Link& link, const RefinementOptions& options) const {
  const KernelEstimate& e = link.estimate;
  const Node &p = tree_.nodes()[link.receiver], &q = tree_.nodes()[link.emitter];
  if (e.kernel[0] == 0 && e.kernel[1] == 0 && e.kernel[2] == 0 && e.receiver_error == 0 && e.time_error == 0)
    return e.dynamic ? Action::kAccept : Action::kDrop;
  float radiance = 0, spread = 0;
  const auto order = static_cast<uint32_t>(grid_.order);
  for (size_t i = 0; i < dates_.size(); ++i) {
    const uint32_t cell = dates_[i] / order;
    if (cell < link.interval.cell || cell >= link.interval.cell + link.interval.cell_count()) continue;
    radiance = std::max(radiance, max_channel(p.reflectance * radiance_[link.emitter][i]));
    spread = std::max(spread, max_channel(p.reflectance) * spread_[link.emitter][i]);
  }
  const double scale = std::sqrt(p.area / total_area_) / kPi;
  const double of_receiver = e.receiver_error * radiance * scale;
  const double of_emitter = 2 * e.emitter_error * spread * scale;  // Cauchy-Schwarz over the four quarters
  const double of_time = e.time_error * radiance * scale;
  if (of_receiver * of_receiver + of_emitter * of_emitter + of_time * of_time <=
      options.threshold * options.threshold)
    return Action::kAccept;
  const bool can_time = link.interval.log2_cells > options.smallest_interval;
  const bool can_receiver = p.radius > options.smallest_radius,
             can_emitter = q.radius > options.smallest_radius;
  if (can_time && of_time > std::max(of_receiver, of_emitter)) return Action::kSplitTime;
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
    if (tree_.nodes()[n].first_child == kNone) tree_.split(n);
  const size_t after = tree_.nodes().size();
  direct_.resize(after);
  radiance_.resize(after);
  spread_.resize(after);
  parallel_for(after - before, 4, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) describe(static_cast<uint32_t>(before + n));
  });
}

void Refinement::refine(const RefinementOptions& options) {
  std::vector<Link> pending;
  const auto roots = static_cast<uint32_t>(linked_.size());
  std::vector<uint32_t> newly_lit;
  for (uint32_t q = 0; q < roots; ++q)
    if (!linked_[q] && is_lit(q)) newly_lit.push_back(q);
  for (const uint32_t q : newly_lit) {
    linked_[q] = true;
    for (uint32_t p = 0; p < roots; ++p)
      if (tree_.nodes()[p].face != tree_.nodes()[q].face)
        for (const Span& span : grid_.spans)
          pending.push_back({p, q, {span.first_cell, span.log2_cells}, {}});
  }
  size_t fresh = 0;  // pending[fresh..] wait for an estimate; those before have one and wait for a decision
  pending.insert(pending.begin(), links_.begin(), links_.end());
  fresh = links_.size();
  links_.clear();
  while (!pending.empty()) {
    parallel_for(pending.size() - fresh, 16, [&](size_t begin, size_t end) {
      for (size_t i = fresh + begin; i < fresh + end; ++i)
        pending[i].estimate = kernels_.estimate(pending[i].receiver, pending[i].emitter, pending[i].interval);
    });
    for (size_t i = fresh; i < pending.size(); ++i) {
      counts_.rays += pending[i].estimate.rays;
      counts_.evaluations += pending[i].estimate.evaluations;
    }
    std::vector<Action> actions(pending.size());
    parallel_for(pending.size(), 256, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) actions[i] = decide(pending[i], options);
    });
    std::vector<uint32_t> to_split;
    for (size_t i = 0; i < pending.size(); ++i) {
      if (actions[i] == Action::kSplitReceiver) to_split.push_back(pending[i].receiver);
      if (actions[i] == Action::kSplitEmitter) to_split.push_back(pending[i].emitter);
    }
    split_nodes(to_split);
    std::vector<Link> next;
    for (size_t i = 0; i < pending.size(); ++i) {
      const Link& link = pending[i];
      switch (actions[i]) {
        case Action::kDrop:
          break;
        case Action::kAccept:
          links_.push_back(link);
          break;
        case Action::kSplitTime: {
          ++counts_.refined_in_time;
          const Interval left{link.interval.cell, link.interval.log2_cells - 1};
          next.push_back({link.receiver, link.emitter, left, {}});
          next.push_back({link.receiver, link.emitter, {left.cell + left.cell_count(), left.log2_cells}, {}});
          break;
        }
        case Action::kSplitReceiver:
          ++counts_.refined_in_space;
          for (uint32_t c = 0; c < 4; ++c)
            next.push_back({tree_.nodes()[link.receiver].first_child + c, link.emitter, link.interval, {}});
          break;
        case Action::kSplitEmitter:
          ++counts_.refined_in_space;
          for (uint32_t c = 0; c < 4; ++c)
            next.push_back({link.receiver, tree_.nodes()[link.emitter].first_child + c, link.interval, {}});
          break;
      }
    }
    pending = std::move(next);
    fresh = 0;
  }
}

}  // namespace strad
