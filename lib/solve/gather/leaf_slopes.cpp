#include "solve/gather/leaf_slopes.h"

#include <algorithm>
#include <cmath>

#include "solve/links/leaves.h"

namespace strad {
namespace {

constexpr float kSteepest = 0.95f;  // so that the darkest corner keeps some light

// Radiance of a patch, the mean over its area and over time.
struct PatchMean {
  double value = 0, variance = 0;
};

// The relative change of radiance over a patch, as its children show it.
struct Gradient {
  double u = 0, v = 0;
  double variance = 0;  // of either
};

// Corners of triangles are corners of their children 0 to 2; child 3, in the middle, is turned round (see
// triangle_child). Children of quadrilaterals go round as its corners do.
Gradient gradient_of(const PatchMean (&children)[4], const PatchMean& mean, bool quad) {
  if (!(mean.value > 0)) return {};
  const auto change = [&](int from, int to) { return children[to].value - children[from].value; };
  const double u = quad ? change(0, 1) + change(3, 2) : 2 * change(0, 1),
               v = quad ? change(0, 3) + change(1, 2) : 2 * change(0, 2);
  return {u / mean.value, v / mean.value, 16 * mean.variance / (mean.value * mean.value)};
}

}  // namespace

LeafSlopes::LeafSlopes(const NodeTree& tree, const FunctionBlock& radiance, const std::vector<float>& noise) {
  const std::vector<Node>& nodes = tree.nodes();
  std::vector<PatchMean> means(nodes.size());
  const std::vector<double> of_rows = means_over_time(radiance);
  for (size_t row = 0; row < of_rows.size() && radiance.rows()[row] < nodes.size(); ++row) {
    const double deviation = of_rows[row] * noise[row];
    means[radiance.rows()[row]] = {of_rows[row], deviation * deviation};
  }
  const auto is_quad = [&](const Node& node) {
    return tree.builder().mesh().elements[node.element].corner_count() == 4;
  };
  // Children have higher numbers than their parents: backwards for means, forwards for slopes.
  std::vector<Gradient> gradients(nodes.size());
  slopes_.resize(nodes.size());
  for (size_t n = nodes.size(); n-- > 0;) {
    const Node& node = nodes[n];
    if (node.is_cluster()) continue;
    slopes_[n].centre = is_quad(node) ? 0.5f : 1.0f / 3;
    if (node.is_leaf()) continue;
    PatchMean children[4];
    for (int c = 0; c < 4; ++c) {
      children[c] = means[node.first_child + static_cast<uint32_t>(c)];
      means[n].value += children[c].value / 4;
      means[n].variance += children[c].variance / 16;
    }
    gradients[n] = gradient_of(children, means[n], is_quad(node));
  }
  for (size_t n = 0; n < nodes.size(); ++n) {
    const Node& node = nodes[n];
    Slope& slope = slopes_[n];
    if (node.is_cluster()) continue;
    if (node.parent != kNone && !nodes[node.parent].is_cluster() && means[n].value > 0) {
      const bool turned = !is_quad(node) && n == nodes[node.parent].first_child + 3;
      const auto half = static_cast<float>((turned ? -0.5 : 0.5) * means[node.parent].value / means[n].value);
      slope.u = half * slopes_[node.parent].u;
      slope.v = half * slopes_[node.parent].v;
    }
    if (!node.is_leaf()) {
      // What the children show beyond that, as far as it stands out from noise (James & Stein 1961).
      const Gradient& g = gradients[n];
      const double u = g.u - slope.u, v = g.v - slope.v, size2 = u * u + v * v;
      const double trust = size2 > 0 ? std::max(0.0, 1 - 2 * g.variance / size2) : 0;
      slope.u += static_cast<float>(trust * u);
      slope.v += static_cast<float>(trust * v);
      continue;
    }
    const float darkest =
        is_quad(node) ? -(std::abs(slope.u) + std::abs(slope.v)) / 2
                      : std::min({-(slope.u + slope.v), 2 * slope.u - slope.v, 2 * slope.v - slope.u}) / 3;
    if (-darkest > kSteepest) slope.u *= kSteepest / -darkest, slope.v *= kSteepest / -darkest;
  }
}

}  // namespace strad
