#include "frame/check.h"

#include <algorithm>

#include "base/parallel.h"
#include "frame/cosine_direction.h"
#include "frame/paths.h"
#include "frame/sobol.h"

namespace strad {
namespace {

// To each emitter group, for the direct light that frames trace: an error far below that of a mesh.
constexpr uint32_t kShadowRays = 256;
// Points between two looks into the file.
constexpr size_t kBlock = 64;
// Points of sides that the solution takes for dark get so much fewer paths: most of them are dark.
constexpr uint32_t kUnmeshedPaths = 8;
// Looks around from a point without light. It is covered when this fraction of them end on sides that the
// solution takes for dark, or nearer than this fraction of the scene's diagonal: inside legs, plates and
// other closed bodies or under them, where no camera stands.
constexpr uint32_t kLooks = 64;
constexpr double kCovered = 0.75, kNarrow = 0.02;

// [2 * polygon + side]: any slab has a face there.
std::vector<bool> meshed_sides(SolutionFile* file) {
  std::vector<bool> meshed(2 * file->scene().polygons.size());
  for (double time = file->begin();;) {
    const Slab& slab = file->slab_at(time);
    for (const Face& face : slab.mesh.faces) meshed[2 * size_t{face.polygon} + face.side] = true;
    if (!(slab_end(slab) > time) || slab_end(slab) >= file->end()) return meshed;
    time = slab_end(slab);
  }
}

class Checker {
 public:
  Checker(SolutionFile* file, const CheckOptions& options)
      : file_(file),
        options_(options),
        probe_(file->scene(), {}, {options.direct, false, kShadowRays}),
        paths_(file->scene(), probe_.tracer(), probe_.surfaces()),
        cones_(cones_of(file->scene().spots)),
        meshed_(meshed_sides(file)) {}

  std::vector<CheckSample> run(const Progress& progress);

 private:
  std::vector<CheckPoint> draw() const;
  bool counts(const CheckSample& sample) const;
  bool covered(const CheckPoint& point) const;
  void measure(const Slab& slab, size_t i, CheckSample* sample) const;
  Rgb estimate(const Instant& instant, const Sight& sight, uint64_t key, uint32_t paths) const;

  SolutionFile* file_;
  const CheckOptions& options_;
  Probe probe_;
  Paths paths_;
  std::vector<SpotCone> cones_;
  std::vector<bool> meshed_;
};

std::vector<CheckPoint> Checker::draw() const {
  const Scene& scene = file_->scene();
  std::vector<CheckPoint> points =
      options_.camera ? points_by_camera(scene, probe_.surfaces(), *options_.camera, options_.size,
                                         options_.range, options_.points, options_.seed)
                      : points_by_area(scene, meshed_, options_.range, options_.points, options_.seed);
  std::stable_sort(points.begin(), points.end(),
                   [](const CheckPoint& a, const CheckPoint& b) { return a.time < b.time; });
  return points;
}

// Irradiance, W / m^2, but for spotlights: the mean of some paths whose first directions are stratified.
Rgb Checker::estimate(const Instant& instant, const Sight& sight, uint64_t key, uint32_t paths) const {
  double sum[3] = {0, 0, 0};
  for (uint32_t p = 0; p < paths; ++p) {
    PathRandom random(hash_of(key, p, 1));
    const Rgb irradiance = paths_.but_spots(instant, sight.point, sobol_point(p, key), &random);
    for (int c = 0; c < 3; ++c) sum[c] += irradiance[c];
  }
  const double count = paths;
  return {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count),
          static_cast<float>(sum[2] / count)};
}

void Checker::measure(const Slab& slab, size_t i, CheckSample* sample) const {
  const CheckPoint& point = sample->point;
  const LightsAtInstant lights = probe_.lights_at(point.time);
  const ProbePoint& place = point.place;
  const Sight sight = probe_.surfaces().at(lights.instant, place.polygon, place.front, place.rest_point);
  const Rgb reflected = static_cast<float>(1 / kPi) * sight.reflectance;
  sample->solution = reflected * probe_.at(slab, i, lights).irradiance;
  // One shadow ray to each spotlight makes its light exact.
  SpotRays rays;
  const Rgb spots = spots_irradiance(probe_.tracer(), cones_, lights.instant, sight.point, &rays);
  const uint32_t parts = kCheckEstimates * (point.meshed ? 1 : kUnmeshedPaths);
  const uint32_t paths = (options_.paths + parts - 1) / parts;
  for (uint64_t e = 0; e < kCheckEstimates; ++e) {
    const uint64_t key = hash_of(hash_of(options_.seed, i), e);
    sample->estimates[e] = reflected * (spots + estimate(lights.instant, sight, key, paths));
  }
}

bool Checker::covered(const CheckPoint& point) const {
  const Instant instant = instant_at(file_->scene(), point.time);
  const ProbePoint& place = point.place;
  const Tracer& tracer = probe_.tracer();
  const SurfacePoint at = probe_.surfaces().at(instant, place.polygon, place.front, place.rest_point).point;
  const Vec3 lifted = at.position + tracer.offset() * at.normal;
  const double narrow = kNarrow * tracer.scene_box().diagonal();
  uint32_t blocked = 0;
  for (uint32_t i = 0; i < kLooks; ++i) {
    const Vec3 direction = cosine_direction(at.normal, sobol_point(i, 0));
    const SurfaceHit hit = tracer.closest(instant.world_from_body, lifted, direction);
    if (hit.polygon == kNone) continue;
    blocked += hit.distance < narrow || !meshed_[2 * size_t{hit.polygon} + (hit.front ? 0 : 1)];
  }
  return blocked >= kCovered * kLooks;
}

bool Checker::counts(const CheckSample& sample) const {
  if (options_.camera) return true;
  if (!std::all_of(std::begin(sample.estimates), std::end(sample.estimates), is_black)) return true;
  if (!sample.point.meshed) return !is_black(sample.solution);
  return !covered(sample.point);
}

std::vector<CheckSample> Checker::run(const Progress& progress) {
  std::vector<CheckSample> samples;
  std::vector<ProbePoint> places;
  for (const CheckPoint& point : draw()) {
    samples.push_back({point, {}, {}});
    places.push_back(point.place);
  }
  probe_.follow(places);
  for (size_t first = 0; first < samples.size();) {
    if (progress) progress(static_cast<double>(first) / static_cast<double>(samples.size()), "paths");
    const size_t most = std::min(first + kBlock, samples.size());
    const Slab& slab = file_->slab_for(samples[first].point.time, samples[most - 1].point.time);
    size_t end = first + 1;
    while (end < most && samples[end].point.time < slab_end(slab)) ++end;
    probe_.prepare(slab);
    parallel_for(end - first, 1, [&](size_t from, size_t to) {
      for (size_t i = first + from; i < first + to; ++i) measure(slab, i, &samples[i]);
    });
    first = end;
  }
  std::erase_if(samples, [&](const CheckSample& sample) { return !counts(sample); });
  return samples;
}

}  // namespace

std::vector<CheckSample> check_solution(SolutionFile* file, const CheckOptions& options,
                                        const Progress& progress) {
  return Checker(file, options).run(progress);
}

}  // namespace strad
