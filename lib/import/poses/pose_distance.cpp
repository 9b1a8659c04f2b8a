#include "import/poses/pose_distance.h"

#include <algorithm>
#include <cmath>

namespace strad {

double pose_distance(const Pose& a, const Pose& b, const Box& box) {
  double worst = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                      i & 4 ? box.upper.z : box.lower.z};
    worst = std::max(worst, length2(a * corner - b * corner));
  }
  return std::sqrt(worst);
}

}  // namespace strad
