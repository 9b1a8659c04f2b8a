// A tracer at an instant, which looks only into those moving bodies whose bounds a ray meets.
//
// A Tracer carries each ray into the frame of every moving body, which costs more than the ray itself where
// there are many. Here a ray is first tried against the bounds of all bodies where they are, eight at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "light/tracer.h"

namespace strad {

class PosedTracer {
 public:
  // Keeps references to both; the poses are those of `scene` at one instant.
  PosedTracer(const Tracer& tracer, const Scene& scene, const std::vector<Pose>& world_from_body);

  // The same results as the Tracer's.
  bool occluded(Vec3 from, Vec3 to, Rgb* passed = nullptr) const;
  SurfaceHit closest(Vec3 from, Vec3 direction) const;
  double offset() const { return tracer_.offset(); }
  GlassKind glass_kind(uint32_t polygon) const { return tracer_.glass_kind(polygon); }

 private:
  // Sets the flags of the moving bodies whose bounds the ray meets.
  void find(Vec3 from, Vec3 direction, double reach, std::vector<bool>* bodies) const;

  const Tracer& tracer_;
  const std::vector<Pose>& world_from_body_;
  std::vector<uint32_t> moving_;              // bodies with polygons
  std::array<std::vector<float>, 6> bounds_;  // lower x, y, z, upper x, y, z of each, world
};

}  // namespace strad
