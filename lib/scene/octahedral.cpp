#include "scene/octahedral.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

constexpr double kHalf = 32767;  // the middle of the square, of which 0 to 65534 are used

double sign_of(double value) { return value < 0 ? -1 : 1; }

}  // namespace

uint32_t octahedral_code(Vec3 vector) {
  const double sum = std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z);
  double u = vector.x / sum, v = vector.y / sum;
  if (vector.z < 0) {  // the lower half folds outwards
    const double folded = (1 - std::abs(v)) * sign_of(u);
    v = (1 - std::abs(u)) * sign_of(v);
    u = folded;
  }
  double a = std::round(u * kHalf), b = std::round(v * kHalf);
  if (std::abs(a) == kHalf) b = std::abs(b);
  if (std::abs(b) == kHalf) a = std::abs(a);
  return static_cast<uint32_t>(a + kHalf) << 16 | static_cast<uint32_t>(b + kHalf);
}

Vec3 octahedral_vector(uint32_t code) {
  const double u = std::clamp((code >> 16) / kHalf - 1, -1.0, 1.0);
  const double v = std::clamp((code & 0xffff) / kHalf - 1, -1.0, 1.0);
  const double z = 1 - std::abs(u) - std::abs(v);
  if (z >= 0) return normalized(Vec3{u, v, z});
  return normalized(Vec3{(1 - std::abs(v)) * sign_of(u), (1 - std::abs(u)) * sign_of(v), z});
}

}  // namespace strad
