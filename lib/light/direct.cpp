#include "light/direct.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

// With more emitters than this above the horizon, those that give less than their share of all are faint.
constexpr int kFew = 48;

// An emitter gets all its samples where it likely gives one part in this many of the irradiance, or more.
constexpr double kFullAt = 8;

// Random draws from the faint emitters, relative to the samples of one emitter that gave as much.
constexpr int kFaintGain = 4;

// Keys of random numbers of the draws from faint emitters.
constexpr uint64_t kKeyOfFirst = 7, kKeyOfU = 8, kKeyOfV = 9;

bool is_above_horizon(const Emitter& emitter, const SurfacePoint& point) {
  double highest = -1;
  for (int c = 0; c < emitter.count; ++c)
    highest = std::max(highest, dot(emitter.corners[c] - point.position, point.normal));
  return highest > 0;
}

}  // namespace

DirectLight::DirectLight(const Scene& scene, const Tracer& tracer)
    : scene_(scene), tracer_(tracer), cones_(cones_of(scene.spots)) {
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    if (emits(scene, scene.polygons[p])) emitters_.push_back(p);
  const std::vector<bool> moving = moving_bodies(scene);
  const auto moves = [&](uint32_t p) { return moving[body_of(scene, scene.polygons[p])]; };
  std::stable_partition(emitters_.begin(), emitters_.end(), [&](uint32_t p) { return !moves(p); });
  const std::vector<Pose> poses = poses_at(scene, scene.start);
  for (const uint32_t p : emitters_)
    if (!moves(p)) still_.push_back(emitter_at(scene, p, poses));
}

Rgb DirectLight::spots(const Instant& instant, const SurfacePoint& point, uint64_t* rays) const {
  SpotRays spot_rays;
  const Rgb sum = spots_irradiance(tracer_, cones_, instant, point, &spot_rays);
  *rays += spot_rays.traced;
  return sum;
}

// From the distance of the middle and the radius, so that near emitters count although their middle may lie
// below the horizon.
double DirectLight::likely_irradiance(const Emitter& e, const Instant& instant,
                                      const SurfacePoint& point) const {
  const uint32_t material = scene_.polygons[e.polygon].material;
  const Vec3 to = e.centre - point.position;
  const double radius2 = length2(e.corners[0] - e.centre), distance2 = length2(to) + radius2;
  const double cosines = (std::max(0.0, dot(to, point.normal)) + std::sqrt(radius2)) *
                         (std::max(0.0, -dot(to, e.normal)) + std::sqrt(radius2)) / distance2;
  return max_channel(scene_.materials[material].emission) * instant.glow[material] * std::min(1.0, cosines) *
         e.area / distance2;
}

DirectLight::Candidates DirectLight::candidates_for(const Instant& instant, const SurfacePoint& point,
                                                    Which which) const {
  Candidates candidates;
  const size_t first = which == Which::kMoving ? still_.size() : 0;
  const size_t end = which == Which::kStill ? still_.size() : emitters_.size();
  for (size_t i = first; i < end; ++i) {
    const uint32_t material = scene_.polygons[emitters_[i]].material;
    if (emitters_[i] == point.polygon || instant.glow[material] == 0) continue;
    const Emitter e =
        i < still_.size() ? still_[i] : emitter_at(scene_, emitters_[i], instant.world_from_body);
    if (!is_before(e, point.position) || !is_above_horizon(e, point)) continue;
    candidates.list.push_back({e, material, likely_irradiance(e, instant, point)});
    candidates.total += candidates.list.back().likely;
  }
  if (candidates.list.size() <= kFew) return candidates;
  candidates.least = candidates.total / kFew;
  for (const Candidate& c : candidates.list)
    if (c.likely < candidates.least) candidates.faint += c.likely;
  return candidates;
}

// The point at (u, v) of the emitter, as a sample that represents all its area.
EmitterSample DirectLight::sample_at(const Candidate& from, const SurfacePoint& point, double u,
                                     double v) const {
  const Vec3 y = point_on(from.emitter, u, v);
  return {y + tracer_.offset() * from.emitter.normal,
          static_cast<float>(point_irradiance(from.emitter, y, point)), from.material};
}

// Adds a point from each cell of a grid of `side` x `side` cells on the emitter, weighted so that together
// they give the exact irradiance with nothing between.
void DirectLight::add_stratified(const Candidate& candidate, const SurfacePoint& point, int side,
                                 uint64_t seed, std::vector<EmitterSample>* chosen) const {
  const Emitter& emitter = candidate.emitter;
  const double unoccluded =
      unit_irradiance(point.position, point.normal, emitter.corners.data(), emitter.count);
  if (!(unoccluded > 0)) return;
  const size_t first = chosen->size();
  double all = 0;
  for (int i = 0; i < side * side; ++i) {
    const uint64_t h = hash_of(seed, emitter.polygon, static_cast<uint64_t>(i));
    const double u = (i % side + unit_from(h)) / side, v = (i / side + unit_from(mix64(h))) / side;
    const EmitterSample sample = sample_at(candidate, point, u, v);
    if (!(sample.irradiance > 0)) continue;
    chosen->push_back(sample);
    all += sample.irradiance;
  }
  for (size_t i = first; i < chosen->size(); ++i)
    (*chosen)[i].irradiance *= static_cast<float>(unoccluded / all);
}

// Adds points of faint emitters, each drawn with a probability in proportion to what it likely gives, by
// systematic resampling: one random offset and equal steps along the running sum (Kitagawa 1996).
void DirectLight::add_drawn(const Candidates& candidates, const SurfacePoint& point, int samples,
                            uint64_t seed, std::vector<EmitterSample>* chosen) const {
  const double faint = candidates.faint;
  const int draws = std::max(1, static_cast<int>(std::ceil(kFaintGain * samples * faint / candidates.total)));
  const double u0 = unit_from(hash_of(seed, kKeyOfU)), v0 = unit_from(hash_of(seed, kKeyOfV));
  double next = unit_from(hash_of(seed, kKeyOfFirst)) * faint / draws;
  double before = 0;
  uint32_t draw = 0;
  for (const Candidate& c : candidates.list) {
    if (!(c.likely < candidates.least)) continue;
    before += c.likely;
    for (; next < before; next += faint / draws) {
      const Point2 uv = r2_point(draw++, u0, v0);
      EmitterSample sample = sample_at(c, point, uv.u, uv.v);
      sample.irradiance *= static_cast<float>(faint / (draws * c.likely));
      if (sample.irradiance > 0) chosen->push_back(sample);
    }
  }
}

std::vector<EmitterSample> DirectLight::emitter_samples(const Instant& instant, const SurfacePoint& point,
                                                        int samples, uint64_t seed, Which which) const {
  const Candidates candidates = candidates_for(instant, point, which);
  std::vector<EmitterSample> chosen;
  for (const Candidate& c : candidates.list) {
    if (c.likely < candidates.least) continue;
    const double share = std::min(1.0, kFullAt * c.likely / candidates.total);
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(samples * share))));
    add_stratified(c, point, side, seed, &chosen);
  }
  if (candidates.faint > 0) add_drawn(candidates, point, samples, seed, &chosen);
  return chosen;
}

Rgb DirectLight::emitters(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                          Which which, uint64_t* rays) const {
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  Rgb sum;
  for (const EmitterSample& sample : emitter_samples(instant, point, samples, seed, which)) {
    ++*rays;
    Rgb passed{1, 1, 1};
    if (tracer_.occluded(instant.world_from_body, lifted, sample.target, &passed)) continue;
    sum += passed *
           ((sample.irradiance * instant.glow[sample.material]) * scene_.materials[sample.material].emission);
  }
  return sum;
}

Rgb DirectLight::irradiance(const Instant& instant, const SurfacePoint& point, int samples, uint64_t seed,
                            uint64_t* rays) const {
  uint64_t traced = 0;
  const Rgb sum =
      spots(instant, point, &traced) + emitters(instant, point, samples, seed, Which::kAll, &traced);
  if (rays) *rays += traced;
  return sum;
}

}  // namespace strad
