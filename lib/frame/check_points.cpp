#include "frame/check_points.h"

#include <cmath>

#include "base/rng.h"
#include "frame/camera.h"
#include "frame/surface_samples.h"

namespace strad {
namespace {

// What the numbers are drawn for.
enum Draw : uint64_t { kMeshed = 1, kUnmeshed = 2, kPicture = 3 };

constexpr uint32_t kUnmeshedShare = 8;

double random_of(uint64_t seed, Draw draw, uint64_t which) { return unit_from(hash_of(seed, draw, which)); }
double fraction(double x) { return x - std::floor(x); }

bool reflects(const Scene& scene, uint32_t polygon) {
  return !is_black(scene.materials[scene.polygons[polygon].material].reflectance);
}

double instant_of(TimeRange range, double at) { return range.begin + at * (range.end - range.begin); }

double area_of_sides(const Scene& scene, const std::vector<bool>& wanted) {
  double area = 0;
  for (uint32_t side = 0; side < wanted.size(); ++side)
    if (wanted[side]) area += polygon_area(scene, scene.polygons[side / 2]);
  return area;
}

void add_points(const Scene& scene, const std::vector<bool>& wanted, TimeRange range, uint32_t count,
                uint64_t seed, Draw draw, std::vector<CheckPoint>* points) {
  const SampleShift shift{random_of(seed, draw, 0), random_of(seed, draw, 1), random_of(seed, draw, 2)};
  const double first = random_of(seed, draw, 3), weight = area_of_sides(scene, wanted) / count;
  const std::vector<RestSample> samples = surface_samples(scene, wanted, count, shift);
  for (size_t i = 0; i < samples.size(); ++i) {
    // The golden ratio's multiples: neighbours in order of polygons are far apart in time.
    const double at = fraction(first + 0.6180339887498949 * static_cast<double>(i));
    const RestSample& sample = samples[i];
    points->push_back({{sample.polygon, sample.side == 0, sample.rest_point},
                       instant_of(range, at),
                       weight,
                       draw == kMeshed});
  }
}

}  // namespace

std::vector<CheckPoint> points_by_area(const Scene& scene, const std::vector<bool>& meshed, TimeRange range,
                                       uint32_t count, uint64_t seed) {
  std::vector<bool> lit(meshed.size()), dark(meshed.size());
  for (uint32_t side = 0; side < meshed.size(); ++side) {
    if (reflects(scene, side / 2)) (meshed[side] ? lit : dark)[side] = true;
  }
  std::vector<CheckPoint> points;
  add_points(scene, lit, range, count, seed, kMeshed, &points);
  add_points(scene, dark, range, (count + kUnmeshedShare - 1) / kUnmeshedShare, seed, kUnmeshed, &points);
  return points;
}

std::vector<CheckPoint> points_by_camera(const Scene& scene, const Surfaces& surfaces, const Camera& camera,
                                         PictureSize size, TimeRange range, uint32_t count, uint64_t seed) {
  std::vector<CheckPoint> points;
  for (uint32_t i = 0; i < count; ++i) {
    // The sequence R3 (Roberts 2018).
    const auto at = [&](uint64_t dimension, double step) {
      return fraction(random_of(seed, kPicture, dimension) + step * i);
    };
    const double x = at(0, 0.8191725133961645) * size.width, y = at(1, 0.6710436067037893) * size.height;
    const double time = instant_of(range, at(2, 0.5497004779019703));
    const Instant instant = instant_at(scene, time);
    const CameraRays rays(camera_at(camera, time), size.width, size.height);
    const Sight sight = surfaces.look(instant, rays.from(), rays.direction(x, y));
    if (sight.point.polygon == kNone || !reflects(scene, sight.point.polygon)) continue;
    const Polygon& polygon = scene.polygons[sight.point.polygon];
    points.push_back({{sight.point.polygon, sight.front, point_of(scene, polygon, sight.at)}, time, 1, true});
  }
  return points;
}

}  // namespace strad
