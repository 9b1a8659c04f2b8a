#include "frame/show_openness.h"

#include "base/parallel.h"
#include "frame/cosine_direction.h"
#include "frame/sobol.h"

namespace strad {
namespace {

constexpr int kRaysAPoint = 4;

// Rays that are not stopped, of kRaysAPoint with numbers from `first` on.
int open_rays(const ShowView& view, const SurfacePoint& point, double within, uint32_t first, uint64_t key) {
  const Vec3 from = point.position + view.tracer.offset() * point.normal;
  int open = 0;
  for (uint32_t i = first; i < first + kRaysAPoint; ++i) {
    const Vec3 direction = cosine_direction(point.normal, sobol_point(i, key));
    if (!view.tracer.occluded(view.instant.world_from_body, from, from + within * direction)) ++open;
  }
  return open;
}

float openness_of(const ShowView& view, double within, int samples, uint32_t x, uint32_t y) {
  const uint64_t of_points = hash_of(x, y), of_rays = mix64(of_points);
  int open = 0;
  for (int i = 0; i < samples; ++i) {
    const auto number = static_cast<uint32_t>(i);
    const Point2 at = sobol_point(number, of_points);
    const Sight sight = view.look(x + at.u, y + at.v);
    if (sight.point.polygon != kNone)
      open += open_rays(view, sight.point, within, kRaysAPoint * number, of_rays);
  }
  return static_cast<float>(open) / static_cast<float>(kRaysAPoint * samples);
}

}  // namespace

Image openness_picture(const ShowView& view, double within, int samples) {
  Image image(view.width, view.height);
  parallel_for(view.height, 1, [&](size_t begin, size_t end) {
    for (auto y = static_cast<uint32_t>(begin); y < end; ++y)
      for (uint32_t x = 0; x < view.width; ++x) {
        const float open = openness_of(view, within, samples, x, y);
        image.at(x, y) = {open, open, open};
      }
  });
  return image;
}

}  // namespace strad
