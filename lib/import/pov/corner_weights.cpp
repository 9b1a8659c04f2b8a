#include "import/pov/corner_weights.h"

#include <algorithm>
#include <cmath>

namespace strad {

std::vector<double> corner_weights(const std::vector<Vec3>& outline, Vec3 normal, Vec3 point) {
  const size_t count = outline.size();
  std::vector<double> weights(count, 0), distances(count);
  std::vector<Vec3> towards(count);
  double size = 0;
  for (size_t i = 0; i < count; ++i) {
    towards[i] = outline[i] - point;
    distances[i] = length(towards[i]);
    size = std::max(size, length(outline[i] - outline[0]));
  }
  const double touch = 1e-8 * size;
  for (size_t i = 0; i < count; ++i) {
    if (!(distances[i] <= touch)) continue;
    weights[i] = 1;
    return weights;
  }
  double sum = 0;
  for (size_t i = 0; i < count; ++i) {
    const size_t next = (i + 1) % count;
    const double edge = length(outline[next] - outline[i]);
    const double doubled_area = dot(cross(towards[i], towards[next]), normal);
    const double cosine = dot(towards[i], towards[next]);
    if (std::abs(doubled_area) <= touch * edge) {
      if (cosine > 0) continue;  // on the line beyond the edge
      std::fill(weights.begin(), weights.end(), 0.0);
      weights[i] = distances[next] / (distances[i] + distances[next]);
      weights[next] = 1 - weights[i];
      return weights;
    }
    // The tangent of half the angle under which the edge is seen, for both of its ends.
    const double tangent = (distances[i] * distances[next] - cosine) / doubled_area;
    weights[i] += tangent / distances[i];
    weights[next] += tangent / distances[next];
    sum += tangent * (1 / distances[i] + 1 / distances[next]);
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace strad
