#include "frame/surface_samples.h"

#include <algorithm>

#include "base/rng.h"
#include "scene/polygon_geometry.h"
#include "scene/texture.h"

namespace strad {
namespace {

// A triangle of a side, and the area of all triangles up to its end.
struct Stretch {
  uint32_t polygon, side;
  Vec3 corners[3];
  double area_before;
};

class Stretches {
 public:
  void add(const Scene& scene, uint32_t polygon, uint32_t side) {
    const Polygon& p = scene.polygons[polygon];
    for (int i = 2; i < p.corner_count(); ++i) {
      const Vec3 a = scene.vertices[p.corners[0]], b = scene.vertices[p.corners[i - 1]],
                 c = scene.vertices[p.corners[i]];
      stretches_.push_back({polygon, side, {a, b, c}, area_});
      area_ += length(cross(b - a, c - a)) / 2;
    }
  }
  double area() const { return area_; }
  const Stretch& at(double area) const {
    const auto after = std::upper_bound(stretches_.begin(), stretches_.end(), area,
                                        [](double a, const Stretch& s) { return a < s.area_before; });
    return *(after - 1);
  }

 private:
  std::vector<Stretch> stretches_;
  double area_ = 0;
};

// The unit square folded onto the triangle keeps areas.
Vec3 point_in(const Stretch& triangle, Point2 p) {
  if (p.u + p.v > 1) p = {1 - p.u, 1 - p.v};
  const Vec3 origin = triangle.corners[0];
  return origin + p.u * (triangle.corners[1] - origin) + p.v * (triangle.corners[2] - origin);
}

bool lies_in_hole(const Scene& scene, const RestSample& sample) {
  const Polygon& polygon = scene.polygons[sample.polygon];
  if (!may_have_holes(scene, polygon)) return false;
  const Vec2 at = parametric_of(scene, polygon, sample.rest_point);
  return is_hole(scene.textures[scene.materials[polygon.material].texture], texture_uv(scene, polygon, at));
}

}  // namespace

std::vector<RestSample> surface_samples(const Scene& scene, const std::vector<bool>& wanted, uint32_t count,
                                        const SampleShift& shift) {
  Stretches stretches;
  for (uint32_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]) stretches.add(scene, i / 2, i % 2);
  std::vector<RestSample> samples;
  if (!(stretches.area() > 0)) return samples;
  for (uint32_t i = 0; i < count; ++i) {
    const Stretch& triangle = stretches.at((i + shift.area) / count * stretches.area());
    const RestSample sample{triangle.polygon, triangle.side,
                            point_in(triangle, r2_point(i, shift.u, shift.v))};
    if (!lies_in_hole(scene, sample)) samples.push_back(sample);
  }
  return samples;
}

}  // namespace strad
