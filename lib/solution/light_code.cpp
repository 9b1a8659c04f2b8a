// Irradiance as 16-bit integers.
#include "solution/light_code.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// Half of the quantum is the largest error near zero. The quantum is a share of the mean irradiance, and of
// what all but the darkest vertices have, down to a share of the mean.
constexpr double kQuantum = 2e-4, kQuantumInTheDark = 2e-3, kDarkestVertices = 0.02, kDarkest = 1e-4;
constexpr uint32_t kEvenCodes = 2u << kMantissaBits;  // smaller codes are multiples of the quantum
constexpr int kLargestCode = 32767;

// Values of parents can be added channel by channel, but not their largest channels. So channels are summed
// apart.
struct Mean {
  double channel[3] = {0, 0, 0};
};

Mean row_integral(const TimeGrid& grid, const Field& field, uint32_t row) {
  double weights[kMaxOrder];
  lagrange_means(field.order, 0, 1, weights);
  Mean mean;
  for (uint32_t p = field.first_piece[row]; p < field.first_piece[row + 1]; ++p) {
    const double length = interval_end(grid, field.pieces[p]) - interval_begin(grid, field.pieces[p]);
    for (int k = 0; k < field.order; ++k)
      for (int c = 0; c < 3; ++c)
        mean.channel[c] +=
            std::max(length, 1e-30) * weights[k] *
            field.coefficients[size_t{p} * static_cast<size_t>(field.order) + static_cast<size_t>(k)][c];
  }
  return mean;
}

// The irradiance that the quantum is a share of, kQuantum.
double typical_irradiance(const Slab& slab) {
  const auto& vertices = slab.mesh.vertices;
  std::vector<Mean> values(vertices.size());
  double sum = 0;
  std::vector<double> lit;
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    const Mean direct = row_integral(slab.grid, slab.direct, v);
    const Mean indirect = row_integral(slab.grid, slab.indirect, v);
    const uint32_t* parents = vertices[v].parents;
    const int count = vertices[v].parent_count();
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
      double& value = values[v].channel[c];
      for (int i = 0; i < count; ++i) value += values[parents[i]].channel[c] / count;
      value += direct.channel[c] + indirect.channel[c];
      largest = std::max(largest, value);
    }
    sum += largest;
    if (largest > 0) lit.push_back(largest);
  }
  if (lit.empty()) return 0;
  const auto dark =
      lit.begin() + static_cast<std::ptrdiff_t>(kDarkestVertices * static_cast<double>(lit.size()));
  std::nth_element(lit.begin(), dark, lit.end());
  const double mean = sum / static_cast<double>(vertices.size());
  const double length = std::max(slab_end(slab) - slab_begin(slab), 1e-30);
  return std::clamp(kQuantumInTheDark / kQuantum * *dark, kDarkest * mean, mean) / length;
}

}  // namespace

int quantum_exponent(const Slab& slab) {
  const double quantum = kQuantum * typical_irradiance(slab);
  if (!(quantum > 0)) return kLowestExponent;
  return std::clamp(std::ilogb(quantum), kLowestExponent, kHighestExponent);
}

int16_t light_code(float value, double quantum) {
  const double quanta = std::abs(static_cast<double>(value)) / quantum;
  double code = std::nearbyint(quanta);
  if (code >= kEvenCodes) {
    const int shift = std::ilogb(quanta) - kMantissaBits;
    // If the mantissa rounds up to a power of two, the carry increases the exponent, as it should.
    code = std::nearbyint(std::ldexp(quanta, -shift)) + std::ldexp(shift, kMantissaBits);
  }
  const int magnitude = static_cast<int>(std::min<double>(code, kLargestCode));
  return static_cast<int16_t>(value < 0 ? -magnitude : magnitude);
}

float light_of(int16_t code, double quantum) {
  const uint32_t magnitude = static_cast<uint32_t>(std::abs(static_cast<int>(code)));
  double quanta = magnitude;
  if (magnitude >= kEvenCodes) {
    const uint32_t mantissa = (magnitude & ((1u << kMantissaBits) - 1)) | (1u << kMantissaBits);
    const uint32_t shift = (magnitude >> kMantissaBits) - 1;
    quanta = shift < 32 ? static_cast<double>(uint64_t{mantissa} << shift)
                        : std::ldexp(mantissa, static_cast<int>(shift));
  }
  return static_cast<float>(code < 0 ? -quanta * quantum : quanta * quantum);
}

}  // namespace strad
