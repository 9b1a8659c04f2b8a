#include "solve/direct/direct_over_time.h"

#include <algorithm>

namespace strad {

DirectOverTime::DirectOverTime(const Scene& scene, const Tracer& tracer, const TimeGrid& grid,
                               const SweptBounds& swept, const std::vector<Instant>& instants, int samples)
    : scene_(scene),
      tracer_(tracer),
      grid_(grid),
      swept_(swept),
      instants_(instants),
      light_(scene, tracer),
      samples_(samples),
      brightest_(instants.front()) {
  for (const Instant& instant : instants)
    for (size_t m = 0; m < instant.glow.size(); ++m)
      brightest_.glow[m] = std::max(brightest_.glow[m], instant.glow[m]);
  for (uint32_t b = 0; b < scene.bodies.size(); ++b) {
    moving_mask_.push_back(swept.moves(b));
    still_mask_.push_back(!moving_mask_.back());
  }
}

void DirectOverTime::add_still_emitters(const SurfacePoint& point, const std::vector<uint32_t>& time_samples,
                                        uint64_t seed, std::vector<Rgb>* values, uint64_t* rays) const {
  const Vec3 lifted = point.position + tracer_.offset() * point.normal;
  std::vector<EmitterSample> free;  // sums by material, where nothing ever passes between
  for (const EmitterSample& sample :
       light_.emitter_samples(brightest_, point, samples_, seed, DirectLight::Which::kStill)) {
    ++*rays;
    Rgb through{1, 1, 1};  // what rests
    if (tracer_.occluded_by(brightest_.world_from_body, still_mask_, lifted, sample.target, &through))
      continue;
    const Vec3 towards = sample.target - lifted;
    if (!swept_.may_meet(lifted, towards, 1) && through == Rgb{1, 1, 1}) {
      if (free.empty() || free.back().material != sample.material) free.push_back({{}, 0, sample.material});
      free.back().irradiance += sample.irradiance;
      continue;
    }
    for (size_t i = 0; i < time_samples.size(); ++i) {
      const Instant& instant = instants_[time_samples[i]];
      const uint32_t cell = time_samples[i] / static_cast<uint32_t>(grid_.order);
      Rgb passed = through;
      if (swept_.may_meet_in(cell, lifted, towards, 1)) {
        ++*rays;
        if (tracer_.occluded_by(instant.world_from_body, moving_mask_, lifted, sample.target, &passed))
          continue;
      }
      (*values)[i] += passed * ((sample.irradiance * instant.glow[sample.material]) *
                                scene_.materials[sample.material].emission);
    }
  }
  for (const EmitterSample& sum : free)
    for (size_t i = 0; i < time_samples.size(); ++i)
      (*values)[i] += (sum.irradiance * instants_[time_samples[i]].glow[sum.material]) *
                      scene_.materials[sum.material].emission;
}

std::vector<Rgb> DirectOverTime::irradiance(const RestPoint& rest, const std::vector<uint32_t>& time_samples,
                                            uint64_t seed, uint64_t* rays) const {
  std::vector<Rgb> values(time_samples.size());
  const uint32_t body = body_of(scene_, scene_.polygons[rest.polygon]);
  const auto at = [&](const Instant& instant) {
    const Pose& pose = instant.world_from_body[body];
    return SurfacePoint{pose * rest.position, rotate(pose, rest.normal), rest.polygon};
  };
  if (swept_.moves(body)) {
    for (size_t i = 0; i < time_samples.size(); ++i)
      values[i] =
          light_.irradiance(instants_[time_samples[i]], at(instants_[time_samples[i]]), samples_, seed, rays);
    return values;
  }
  const SurfacePoint point = at(brightest_);
  for (size_t i = 0; i < time_samples.size(); ++i) {
    const Instant& instant = instants_[time_samples[i]];
    values[i] = light_.spots(instant, point, rays);
    if (light_.has_moving_emitters())
      values[i] += light_.emitters(instant, point, samples_, seed, DirectLight::Which::kMoving, rays);
  }
  add_still_emitters(point, time_samples, seed, &values, rays);
  return values;
}

}  // namespace strad
