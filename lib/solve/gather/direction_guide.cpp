#include "solve/gather/direction_guide.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace strad {
namespace {

constexpr float kEverywhere = 0.5f;  // of the density
constexpr float kPrior = 2;          // rays that every bin is thought to have had, bringing what is usual
constexpr float kEnough = 1000;      // rays from which directions are told

int place_of(double x) { return std::clamp(static_cast<int>(x * kDirectionRows), 0, kDirectionRows - 1); }

// Maps `x` to the density `values`, constant on equal parts of 0 to 1, with mean `mean`. Returns the part.
template <typename Values>
int warp_one(const Values& values, float mean, double* x) {
  double left = *x * mean * kDirectionRows;
  int i = 0;
  while (i + 1 < kDirectionRows && left >= values[static_cast<size_t>(i)])
    left -= values[static_cast<size_t>(i++)];
  const double within = std::clamp(left / values[static_cast<size_t>(i)], 0.0, 1.0 - 1e-9);
  *x = (i + within) / kDirectionRows;
  return i;
}

}  // namespace

size_t direction_bin(Point2 xi) {
  return static_cast<size_t>(place_of(xi.u)) * kDirectionRows + static_cast<size_t>(place_of(xi.v));
}

void DirectionCounts::add(Point2 xi, double brought, double square) {
  const size_t bin = direction_bin(xi);
  rays[bin] += 1;
  sums[bin] += static_cast<float>(brought);
  squares[bin] += static_cast<float>(square);
}

DirectionCounts& DirectionCounts::operator+=(const DirectionCounts& other) {
  for (size_t b = 0; b < kDirectionBins; ++b)
    rays[b] += other.rays[b], sums[b] += other.sums[b], squares[b] += other.squares[b];
  return *this;
}

DirectionDensity::DirectionDensity() {
  row_density_.fill(1);
  for (Row& row : bin_density_) row.fill(1);
}

DirectionDensity::DirectionDensity(const DirectionCounts& counts) : DirectionDensity() {
  // Rays are not spread evenly when they were guided: the mean of the squares is that of the bins' means.
  float usual = 0;
  for (size_t b = 0; b < kDirectionBins; ++b)
    usual += counts.squares[b] / std::max(1.0f, counts.rays[b]) / kDirectionBins;
  if (!(usual > 0)) return;
  std::array<float, kDirectionBins> wanted;
  for (size_t b = 0; b < kDirectionBins; ++b)
    wanted[b] = std::sqrt((counts.squares[b] + kPrior * usual) / (counts.rays[b] + kPrior));
  const float mean = std::accumulate(wanted.begin(), wanted.end(), 0.0f) / kDirectionBins;
  const float rays = std::accumulate(counts.rays.begin(), counts.rays.end(), 0.0f);
  const float everywhere = 1 - (1 - kEverywhere) * std::min(1.0f, rays / kEnough);
  float brought = 0, square = 0;  // by a ray of this density, by its weight
  for (size_t r = 0; r < kDirectionRows; ++r) {
    row_density_[r] = 0;
    for (size_t c = 0; c < kDirectionRows; ++c) {
      const size_t b = r * kDirectionRows + c;
      bin_density_[r][c] = everywhere + (1 - everywhere) * wanted[b] / mean;
      row_density_[r] += bin_density_[r][c] / kDirectionRows;
      brought += counts.sums[b] / std::max(1.0f, counts.rays[b]) / kDirectionBins;
      square += wanted[b] * wanted[b] / bin_density_[r][c] / kDirectionBins;
    }
  }
  if (brought > 0) deviation_ = std::sqrt(std::max(0.0f, square / (brought * brought) - 1));
}

Point2 DirectionDensity::warp(Point2 xi, float* density) const {
  const auto row = static_cast<size_t>(warp_one(row_density_, 1, &xi.u));
  const auto column = static_cast<size_t>(warp_one(bin_density_[row], row_density_[row], &xi.v));
  *density = bin_density_[row][column];
  return xi;
}

DirectionGuide::DirectionGuide(const NodeTree& tree, std::vector<DirectionCounts> of_leaves)
    : densities_(1), density_of_(tree.nodes().size(), 0) {
  const std::vector<Node>& nodes = tree.nodes();
  const auto has_patch_above = [&](size_t n) {
    return !nodes[n].is_cluster() && nodes[n].parent != kNone && !nodes[nodes[n].parent].is_cluster();
  };
  for (size_t n = nodes.size(); n-- > 0;)  // children have higher numbers than their parents
    if (has_patch_above(n)) of_leaves[nodes[n].parent] += of_leaves[n];
  for (size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].is_cluster()) continue;
    const std::array<float, kDirectionBins>& all = of_leaves[n].rays;
    const float rays = std::accumulate(all.begin(), all.end(), 0.0f);
    if (rays >= kEnough || (rays > 0 && !has_patch_above(n))) {
      density_of_[n] = static_cast<uint32_t>(densities_.size());
      densities_.emplace_back(of_leaves[n]);
    } else if (has_patch_above(n)) {
      density_of_[n] = density_of_[nodes[n].parent];
    }
  }
}

const DirectionDensity& DirectionGuide::density(uint32_t node) const {
  return densities_[node < density_of_.size() ? density_of_[node] : 0];
}

}  // namespace strad
