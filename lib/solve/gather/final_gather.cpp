#include "solve/gather/final_gather.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/links/leaves.h"

namespace strad {
namespace {

// A change is looked into when halving the interval leaves more of it than the tolerance: a quarter where
// light is smooth, half at the border of a shadow. So is one that stands out from the noise of its rays.
constexpr float kHalved = 0.5f;
constexpr float kDeviations = 1;

// Rays are sent in proportion to the deviation of what they bring, which for a given number of them all makes
// the sum of squared errors least (Neyman 1934); within these factors.
constexpr float kFewest = 1, kMost = 8;

constexpr float kFree = 0.95f;  // a view as open as this is not blocked

// Sums by leaf of what rays bring: three channels of irradiance / pi, then the share of unlit surfaces, each
// at all time samples.
constexpr size_t kSums = 4;

}  // namespace

FinalGather::FinalGather(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                         const SweptBounds& swept, const FunctionBlock& radiance, LeafSlopes slopes,
                         DirectionGuide guide, const GatherAccuracy& accuracy)
    : space_(tree, tracer, grid, swept, std::move(slopes), std::move(guide)),
      radiance_(radiance),
      accuracy_(accuracy),
      means_(tree.leaf_count(), 0.0f) {
  const std::vector<double> means = means_over_time(radiance);
  for (size_t i = 0; i < means.size(); ++i) means_[radiance.rows()[i]] = static_cast<float>(means[i]);
}

// Adds the leaves with their counts, blended over time, times `share`.
void FinalGather::add(const LeafCounts& counts, const LookBlends& blends, float share,
                      std::vector<float>* sums) const {
  const size_t samples = space_.grid.sample_count();
  std::vector<float> weights(samples);
  for (size_t row = 0; row < counts.leaves().size(); ++row) {
    const uint32_t leaf = counts.leaves()[row];
    if (leaf == kOpenView) continue;
    const SampleRange range = blends.weights(counts.counts(row), share, weights.data());
    if (leaf != kUnlit)
      radiance_.add(leaf, range.first, range.end, weights.data(), sums->data());
    else
      for (size_t i = range.first; i < range.end; ++i) (*sums)[3 * samples + i] += weights[i];
  }
}

// Compares what the watched rays bring in the middle of an interval with the blend of both ends. `sums`: of
// all other rays.
bool FinalGather::differs(const RayBundle& bundle, const std::vector<float>& sums, const Look& before,
                          const Look& middle, const Look& after) const {
  const uint32_t cell = space_.grid.spans[middle.span].first_cell + middle.cell;
  const size_t sample = size_t{cell} * static_cast<size_t>(space_.grid.order),
               samples = space_.grid.sample_count();
  const auto radiance = [&](const Seen& seen) {
    return seen.leaf == kOpenView || seen.leaf == kUnlit ? Rgb{}
                                                         : seen.weight * radiance_.get(seen.leaf, sample);
  };
  Rgb all, difference, squares;
  for (size_t r = 0; r < middle.seen.size(); ++r) {
    const Rgb own = radiance(middle.seen[r]);
    all += own;
    if (middle.seen[r].leaf == before.seen[r].leaf && middle.seen[r].leaf == after.seen[r].leaf) continue;
    const Rgb d = own - 0.5f * (radiance(before.seen[r]) + radiance(after.seen[r]));
    difference += d;
    squares += d * d;
  }
  // Means over the rays.
  const auto count = static_cast<float>(bundle.ray_count());
  float level = 0, change = 0, noise2 = 0;
  for (int c = 0; c < 3; ++c) {
    level = std::max(level, sums[static_cast<size_t>(c) * samples + sample] + all[c] / count);
    change = std::max(change, std::abs(difference[c]) / count);
    noise2 = std::max(noise2, squares[c] / (count * count));
  }
  const float tolerance = static_cast<float>(accuracy_.tolerance) * level;
  return kHalved * change > tolerance && change * change > kDeviations * kDeviations * noise2;
}

std::vector<Look> FinalGather::looks_of(const RayBundle& bundle, const std::vector<float>& sums) const {
  Looker looker;
  looker.see = [&](uint32_t span, uint32_t cell) { return bundle.see(span, cell); };
  looker.differs = [&](const Look& before, const Look& middle, const Look& after) {
    return differs(bundle, sums, before, middle, after);
  };
  const double unnoticed = accuracy_.tolerance * static_cast<double>(bundle.ray_count()) / kHalved;
  looker.may_happen = [&](uint32_t first_cell, uint32_t end_cell) {
    return bundle.surprise(first_cell, end_cell) > unnoticed;
  };
  return looks_over(space_.grid, looker);
}

// The standard error of the mean of what the rays bring, by the mean over time of what they see at the start.
float FinalGather::noise_of(const RayBundle& bundle, const std::vector<Look>& looks) const {
  double sum = 0, squares = 0;
  const auto add = [&](const std::vector<Seen>& all) {
    for (const Seen& seen : all) {
      if (seen.leaf == kOpenView || seen.leaf == kUnlit) continue;
      const double brought = double{seen.weight} * means_[seen.leaf];
      sum += brought, squares += brought * brought;
    }
  };
  add(bundle.always());
  if (!looks.empty()) add(looks[0].seen);
  if (!(sum > 0)) return 0;
  const double variance = squares / (sum * sum) - 1.0 / static_cast<double>(bundle.ray_count());
  return static_cast<float>(std::sqrt(std::max(0.0, variance)));
}

GatheredFunction FinalGather::gather(Receiver receiver, uint64_t* rays, DirectionCounts* counts) const {
  const float deviation = space_.guide.density(receiver.node).deviation();
  receiver.rays = static_cast<int>(static_cast<float>(receiver.rays) * std::clamp(deviation, kFewest, kMost));
  const RayBundle bundle(space_, receiver, rays);
  const size_t samples = space_.grid.sample_count();
  const float share = 1.0f / static_cast<float>(bundle.ray_count());
  std::vector<float> sums(kSums * samples);
  LeafCounts always(1);
  for (const Seen& seen : bundle.always()) always.add(seen.leaf, 0, seen.weight);
  add(always, LookBlends(space_.grid), share, &sums);
  std::vector<Look> looks;
  if (bundle.ray_count() > bundle.always().size()) {
    looks = looks_of(bundle, sums);
    LeafCounts seen(looks.size());
    for (size_t i = 0; i < looks.size(); ++i)
      for (const Seen& s : looks[i].seen) seen.add(s.leaf, i, s.weight);
    add(seen, LookBlends(space_.grid, looks), share, &sums);
  }
  GatheredFunction f{std::vector<Rgb>(samples), std::vector<float>(samples)};
  for (size_t i = 0; i < samples; ++i) {
    f.irradiance[i] = static_cast<float>(kPi) * Rgb{sums[i], sums[samples + i], sums[2 * samples + i]};
    f.unblocked[i] = 1 - sums[3 * samples + i];
  }
  f.noise = noise_of(bundle, looks);
  if (counts) bundle.count(means_, looks, counts);
  return f;
}

GatheredFunction FinalGather::at_vertex(uint32_t vertex, uint64_t* rays) const {
  GatheredFunction f = gather(receiver_of_vertex(space_.tree, vertex, accuracy_.rays), rays, nullptr);
  // A point with most of its view blocked lies inside something. Its value will be replaced by its
  // neighbours'.
  for (size_t i = 0; i < f.irradiance.size(); ++i)
    f.irradiance[i] = (1 / std::max(f.unblocked[i], 0.1f)) * f.irradiance[i];
  if (*std::min_element(f.unblocked.begin(), f.unblocked.end()) > kFree) f.unblocked = {};
  return f;
}

GatheredFunction FinalGather::over_leaf(uint32_t leaf, uint64_t* rays, DirectionCounts* counts) const {
  return gather(receiver_of_leaf(space_.tree, leaf, accuracy_.rays), rays, counts);
}

}  // namespace strad
