#include "solve/links/patch_quarters.h"

#include <algorithm>

#include "light/emitter.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

Quarter finish(Quarter quarter) {
  const Vec3* c = quarter.corners;
  quarter.area = area_of(c, quarter.count);
  for (int i = 0; i < quarter.count; ++i) quarter.centre += c[i] / quarter.count;
  quarter.radius = 0;
  for (int i = 0; i < quarter.count; ++i)
    quarter.radius = std::max(quarter.radius, length(c[i] - quarter.centre));
  return quarter;
}

}  // namespace

void quarters_of(const PatchPoints& patch, const Pose& pose, Quarter* quarters) {
  const int n = patch.corner_count;
  Vec3 c[4], m[4], mid;
  for (int i = 0; i < n; ++i) c[i] = pose * patch.corners[i];
  for (int i = 0; i < n; ++i) {
    m[i] = 0.5 * (c[i] + c[(i + 1) % n]);
    mid += c[i] / n;
  }
  for (int i = 0; i < n; ++i) {
    const Vec3 before = m[(i + n - 1) % n];
    quarters[i] = n == 4 ? finish({{c[i], m[i], mid, before}, 4, {}, 0, 0})
                         : finish({{c[i], m[i], before, {}}, 3, {}, 0, 0});
  }
  if (n == 3) quarters[3] = finish({{m[0], m[1], m[2], {}}, 3, {}, 0, 0});
}

double unoccluded_irradiance(Vec3 x, Vec3 normal, const Quarter& quarter, Vec3 emitter_normal) {
  const Vec3 to = quarter.centre - x;
  const double distance2 = length2(to);
  // Beyond 4 radii a point is exact enough: the error falls with the square of the ratio, here below 2 %.
  if (distance2 < 16 * quarter.radius * quarter.radius) {
    if (!(dot(x - quarter.centre, emitter_normal) > 0)) return 0;
    return unit_irradiance(x, normal, quarter.corners, quarter.count);
  }
  const double cos_x = dot(to, normal), cos_y = -dot(to, emitter_normal);
  if (!(cos_x > 0) || !(cos_y > 0)) return 0;
  return cos_x * cos_y * quarter.area / (distance2 * distance2);
}

}  // namespace strad
