// Random walks that show where light gets to: forth from the lights, and back from surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "light/instant.h"
#include "light/tracer.h"
#include "scene/scene.h"

namespace strad {

// Diffuse walks at fixed instants. How bright a light is plays no part. Thread-safe once made.
class LightWalks {
 public:
  // `instants` must outlive it, like the others. Walks forth from the lights at once.
  LightWalks(const Scene& scene, const Tracer& tracer, const std::vector<Instant>& instants);

  bool has_lights() const { return !emitters_.empty() || !scene_.spots.empty(); }
  // By side of a polygon (2 * polygon + side): how often the walks met it.
  const std::vector<uint32_t>& hits() const { return hits_; }
  // What walk `key` back from a point of a side finds: light (a lamp, or a point that a walk forth has met),
  // or at least a way out: to the open, or to a side of `lit` outside of `home`, a box at rest of the side's
  // body.
  enum class Found { kNothing, kWayOut, kLight };
  Found find_light(uint32_t side, const Box& home, const std::vector<bool>& lit, uint64_t key) const;
  // The side that ray `key` from a point of a side meets; kNone: none.
  uint32_t side_seen_from(uint32_t side, uint64_t key) const;

 private:
  struct Place {
    Vec3 position;  // world, lifted off the surface
    Vec3 normal;    // world, unit
  };
  struct Start {
    Vec3 position, direction;
  };
  Start start_of(const Instant& instant, uint64_t seed) const;
  Place place_of(const Instant& instant, const SurfaceHit& hit) const;
  Place on_side(const Instant& instant, uint32_t side, uint64_t seed) const;
  bool sees_lamp(const Instant& instant, const Place& place, uint64_t seed) const;
  bool sees_met_place(size_t instant, const Place& place, uint64_t seed) const;

  const Scene& scene_;
  const Tracer& tracer_;
  const std::vector<Instant>& instants_;
  std::vector<uint32_t> emitters_;          // polygons
  std::vector<uint32_t> hits_;              // [2 * polygon + side]
  std::vector<std::vector<Place>> places_;  // [instant]: where walks forth met a surface
};

}  // namespace strad
