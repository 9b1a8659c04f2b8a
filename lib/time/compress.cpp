// Compresses values at all time samples to as few dyadic pieces as the tolerance allows, bottom-up.
//
// Merging halves is truncation of the coefficients of multiwavelets, the bases M1 to M3 (Alpert 1993; for
// radiosity Gortler et al. 1993).
#include <algorithm>
#include <array>
#include <cmath>

#include "time/field.h"

namespace strad {
namespace {

struct Candidate {
  std::array<Rgb, kMaxOrder> values;  // at the Gauss nodes of its interval
  float error2 = 0;                   // mean square error against the cells' values
  float norm2 = 0;                    // mean square of the cells' values
  bool single = false;                // one polynomial is exact enough for its interval
  bool zero = false;                  // zero is exact enough
};

float mean_square(const Rgb& a) { return std::max(a.r * a.r, std::max(a.g * a.g, a.b * a.b)); }

// Quadrature weight of each Gauss node of [0, 1] (Abramowitz & Stegun 1964, table 25.4).
const double* gauss_weights(int order) {
  static constexpr double kWeights[3][3] = {{1, 0, 0}, {0.5, 0.5, 0}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
  return kWeights[order - 1];
}

// The two-scale relation of an order: parent = projection * (left values, right values), children =
// restriction * parent values.
struct TwoScale {
  double projection[kMaxOrder][2 * kMaxOrder];
  double restriction[2 * kMaxOrder][kMaxOrder];
};

TwoScale make_two_scale(int order) {
  TwoScale t{};
  for (int c = 0; c < 2 * order; ++c) {
    const double s = 0.5 * (gauss_nodes(order)[c % order] + c / order);
    lagrange_weights(order, s, t.restriction[c]);
    // The Lagrange polynomials of Gauss nodes are orthogonal with norm^2 = the node's weight.
    for (int i = 0; i < order; ++i)
      t.projection[i][c] =
          0.5 * gauss_weights(order)[c % order] * t.restriction[c][i] / gauss_weights(order)[i];
  }
  return t;
}

const TwoScale& two_scale(int order) {
  static const TwoScale kTables[3] = {make_two_scale(1), make_two_scale(2), make_two_scale(3)};
  return kTables[order - 1];
}

Candidate merge(int order, const Candidate& left, const Candidate& right) {
  const TwoScale& t = two_scale(order);
  const auto child = [&](int c) { return c < order ? left.values[c] : right.values[c - order]; };
  Candidate parent;
  for (int i = 0; i < order; ++i)
    for (int c = 0; c < 2 * order; ++c) parent.values[i] += static_cast<float>(t.projection[i][c]) * child(c);
  float added = 0;
  for (int c = 0; c < 2 * order; ++c) {
    Rgb interpolated;
    for (int i = 0; i < order; ++i)
      interpolated += static_cast<float>(t.restriction[c][i]) * parent.values[i];
    added +=
        0.5f * static_cast<float>(gauss_weights(order)[c % order]) * mean_square(interpolated - child(c));
  }
  parent.error2 =
      0.5f * (left.error2 + right.error2) + added;  // projections are orthogonal, so squared errors add up
  parent.norm2 = 0.5f * (left.norm2 + right.norm2);
  return parent;
}

// The tree of one span, heap order: node 1 is the span, node n has halves 2n and 2n + 1.
void emit(const std::vector<Candidate>& tree, size_t node, Interval interval, Field* field) {
  const Candidate& candidate = tree[node];
  if (candidate.zero) return;
  if (candidate.single) {
    field->pieces.push_back(interval);
    field->coefficients.insert(field->coefficients.end(), candidate.values.begin(),
                               candidate.values.begin() + field->order);
    return;
  }
  const Interval left{interval.cell, interval.log2_cells - 1};
  emit(tree, 2 * node, left, field);
  emit(tree, 2 * node + 1, {left.cell + left.cell_count(), left.log2_cells}, field);
}

}  // namespace

void append_row(const TimeGrid& grid, const std::vector<Rgb>& sample_values, const std::vector<bool>& active,
                float tolerance, Field* field) {
  const int order = field->order;
  const float tolerance2 = tolerance * tolerance;
  std::vector<Candidate> tree;
  for (const Span& span : grid.spans) {
    const uint32_t cells = 1u << span.log2_cells;
    tree.assign(2 * static_cast<size_t>(cells), {});
    for (uint32_t c = 0; c < cells; ++c) {
      Candidate& leaf = tree[cells + c];
      const uint32_t cell = span.first_cell + c;
      leaf.single = true;
      if (active.empty() || active[cell])
        for (int k = 0; k < order; ++k) {
          leaf.values[k] = sample_values[static_cast<size_t>(cell) * order + k];
          leaf.norm2 += static_cast<float>(gauss_weights(order)[k]) * mean_square(leaf.values[k]);
        }
      leaf.zero = leaf.norm2 <= tolerance2;
    }
    for (size_t n = cells - 1; n >= 1; --n) {
      tree[n] = merge(order, tree[2 * n], tree[2 * n + 1]);
      const bool both_zero = tree[2 * n].zero && tree[2 * n + 1].zero;
      tree[n].zero = both_zero && tree[n].norm2 <= tolerance2;
      // Halves are merged only if each of them is a single polynomial, so that no short event is averaged
      // away.
      tree[n].single = tree[2 * n].single && tree[2 * n + 1].single && tree[n].error2 <= tolerance2;
    }
    emit(tree, 1, {span.first_cell, span.log2_cells}, field);
  }
  field->first_piece.push_back(static_cast<uint32_t>(field->pieces.size()));
}

}  // namespace strad
