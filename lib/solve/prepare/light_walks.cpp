#include "solve/prepare/light_walks.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/rng.h"
#include "light/emitter.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

constexpr uint32_t kWalks = 16384;
constexpr int kBounces = 8;

Vec3 cosine_about(Vec3 normal, uint64_t seed) {
  const double u = unit_from(mix64(seed)), phi = 2 * kPi * unit_from(mix64(seed + 1));
  const Frame frame = frame_about(normal);
  return std::sqrt(u) * std::cos(phi) * frame.tangent + std::sqrt(u) * std::sin(phi) * frame.bitangent +
         std::sqrt(1 - u) * normal;
}

size_t choice_of(uint64_t seed, size_t count) {
  return static_cast<size_t>(unit_from(seed) * static_cast<double>(count));
}

bool contains(const Box& box, Vec3 point) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.lower[axis] <= point[axis] && point[axis] <= box.upper[axis])) return false;
  return true;
}

Vec3 random_point(const Scene& scene, const Polygon& polygon, uint64_t seed) {
  double u = unit_from(mix64(seed)), v = unit_from(mix64(seed + 1));
  if (polygon.corner_count() == 3 && u + v > 1) u = 1 - u, v = 1 - v;
  return point_of(scene, polygon, {u, v});
}

}  // namespace

LightWalks::LightWalks(const Scene& scene, const Tracer& tracer, const std::vector<Instant>& instants)
    : scene_(scene), tracer_(tracer), instants_(instants), places_(instants.size()) {
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    if (emits(scene, scene.polygons[p])) emitters_.push_back(p);
  hits_.assign(2 * scene.polygons.size(), 0);
  if (!has_lights()) return;
  struct Met {
    uint32_t side = kNone;
    Place place;
  };
  std::vector<Met> met(size_t{kWalks} * kBounces);
  parallel_for(kWalks, 256, [&](size_t begin, size_t end) {
    for (size_t w = begin; w < end; ++w) {
      const Instant& instant = instants_[w % instants_.size()];
      Start ray = start_of(instant, hash_of(w, 11));
      for (size_t b = 0; b < kBounces; ++b) {
        const SurfaceHit hit = tracer_.closest_through(instant.world_from_body, ray.position, ray.direction);
        if (hit.polygon == kNone) break;
        const Place place = place_of(instant, hit);
        met[w * kBounces + b] = {2 * hit.polygon + (hit.front ? 0 : 1), place};
        ray = {place.position, cosine_about(place.normal, hash_of(w, b, 5))};
      }
    }
  });
  for (size_t i = 0; i < met.size(); ++i) {
    if (met[i].side == kNone) continue;
    ++hits_[met[i].side];
    places_[i / kBounces % instants_.size()].push_back(met[i].place);
  }
}

// Where a walk leaves the lights: any of the spots and emitting polygons.
LightWalks::Start LightWalks::start_of(const Instant& instant, uint64_t seed) const {
  const size_t light = choice_of(seed, scene_.spots.size() + emitters_.size());
  if (light < scene_.spots.size()) {
    const SpotState& spot = instant.spots[light];
    const double cosine = 1 - unit_from(mix64(seed + 1)) * (1 - std::cos(scene_.spots[light].outer));
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
                 phi = 2 * kPi * unit_from(mix64(seed + 2));
    const Frame frame = frame_about(spot.direction);
    return {spot.position, sine * std::cos(phi) * frame.tangent + sine * std::sin(phi) * frame.bitangent +
                               cosine * spot.direction};
  }
  const Place place = on_side(instant, 2 * emitters_[light - scene_.spots.size()], seed + 1);
  return {place.position, cosine_about(place.normal, seed + 3)};
}

LightWalks::Place LightWalks::place_of(const Instant& instant, const SurfaceHit& hit) const {
  const Polygon& polygon = scene_.polygons[hit.polygon];
  const Pose& pose = instant.world_from_body[body_of(scene_, polygon)];
  const Vec3 normal = (hit.front ? 1.0 : -1.0) * rotate(pose, polygon_normal(scene_, polygon));
  return {pose * hit.rest_point + tracer_.offset() * normal, normal};
}

LightWalks::Place LightWalks::on_side(const Instant& instant, uint32_t side, uint64_t seed) const {
  const Polygon& polygon = scene_.polygons[side / 2];
  return place_of(instant, {side / 2, side % 2 == 0, 0, random_point(scene_, polygon, seed), {}});
}

bool LightWalks::sees_lamp(const Instant& instant, const Place& place, uint64_t seed) const {
  const size_t light = choice_of(seed, scene_.spots.size() + emitters_.size());
  Vec3 target;
  if (light < scene_.spots.size()) {
    const SpotState& spot = instant.spots[light];
    target = spot.position;
    const Vec3 from_spot = normalized(place.position - target);
    if (!(dot(from_spot, spot.direction) > std::cos(scene_.spots[light].outer))) return false;
  } else {
    const Place on_emitter = on_side(instant, 2 * emitters_[light - scene_.spots.size()], seed + 1);
    target = on_emitter.position;
    if (!(dot(place.position - target, on_emitter.normal) > 0)) return false;
  }
  if (!(dot(target - place.position, place.normal) > 0)) return false;
  return !tracer_.occluded(instant.world_from_body, place.position, target);
}

bool LightWalks::sees_met_place(size_t instant, const Place& place, uint64_t seed) const {
  const std::vector<Place>& places = places_[instant];
  if (places.empty()) return false;
  const Place& other = places[choice_of(seed, places.size())];
  const Vec3 to = other.position - place.position;
  if (!(dot(to, place.normal) > 0) || !(dot(to, other.normal) < 0)) return false;
  return !tracer_.occluded(instants_[instant].world_from_body, place.position, other.position);
}

uint32_t LightWalks::side_seen_from(uint32_t side, uint64_t key) const {
  const uint64_t seed = hash_of(side, key, 19);
  const Instant& instant = instants_[choice_of(seed, instants_.size())];
  const Place place = on_side(instant, side, seed + 1);
  const SurfaceHit hit =
      tracer_.closest_through(instant.world_from_body, place.position, cosine_about(place.normal, seed + 7));
  return hit.polygon == kNone ? kNone : 2 * hit.polygon + (hit.front ? 0 : 1);
}

LightWalks::Found LightWalks::find_light(uint32_t side, const Box& home, const std::vector<bool>& lit,
                                         uint64_t key) const {
  if (!has_lights()) return Found::kNothing;
  const uint64_t seed = hash_of(side, key, 13);
  const size_t i = choice_of(seed, instants_.size());
  const Pose back = inverse(instants_[i].world_from_body[body_of(scene_, scene_.polygons[side / 2])]);
  Place place = on_side(instants_[i], side, seed + 1);
  Found found = Found::kNothing;
  for (int b = 0; b < kBounces; ++b) {
    const uint64_t step = hash_of(seed, static_cast<uint64_t>(b));
    if (sees_lamp(instants_[i], place, step) || sees_met_place(i, place, step + 5)) return Found::kLight;
    const SurfaceHit hit = tracer_.closest_through(instants_[i].world_from_body, place.position,
                                                   cosine_about(place.normal, step + 7));
    if (hit.polygon == kNone) return Found::kWayOut;
    if (hit.front && emits(scene_, scene_.polygons[hit.polygon])) return Found::kLight;
    place = place_of(instants_[i], hit);
    if (lit[2 * hit.polygon + (hit.front ? 0 : 1)] && !contains(home, back * place.position))
      found = Found::kWayOut;
  }
  return found;
}

}  // namespace strad
