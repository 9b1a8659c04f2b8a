// Exact visibility at an instant: one static ray-tracing structure per moving body, rays carried into the
// frame of each. Rays pass the holes of textures, and light passes glass. The only user of Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scene/glass.h"
#include "scene/scene.h"

namespace strad {

struct SurfaceHit {
  uint32_t polygon = kNone;  // kNone: nothing was hit
  bool front = true;         // the ray came from the front side
  double distance = 0;       // in units of the ray's direction
  Vec3 rest_point;           // where, in rest coordinates
  Vec2 uv;                   // the same on the polygon, see parametric_of()
};

class Tracer {
 public:
  explicit Tracer(const Scene& scene);  // keeps a reference; thread-safe from then on
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // Is anything strictly between two world points? Callers lift end points off their surfaces by `offset()`
  // along the normal on the side that counts. Glass occludes nothing: `passed`, if given, is multiplied by
  // the share of light that goes straight through.
  bool occluded(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 to, Rgb* passed = nullptr) const;
  // The same for the bodies with mask[body] only.
  bool occluded_by(const std::vector<Pose>& world_from_body, const std::vector<bool>& mask, Vec3 from,
                   Vec3 to, Rgb* passed = nullptr) const;

  // Nearest surface along `direction` (unit length) no farther than `reach`.
  SurfaceHit closest(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 direction,
                     double reach = 1e30) const;
  SurfaceHit closest_of(const std::vector<Pose>& world_from_body, const std::vector<bool>& mask, Vec3 from,
                        Vec3 direction, double reach) const;
  // What a ray sees by diffuse light through any glass, and what share of that arrives, which is multiplied
  // into `passed`. Of glass that also reflects diffusely, a ray meets the one or the other as its numbers
  // fall: many rays together see both. Without glass the same as closest().
  // `mask`: of bodies, empty: all.
  SurfaceHit closest_through(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 direction,
                             Rgb* passed = nullptr, const std::vector<bool>& mask = {}) const;
  bool has_glass() const;
  GlassKind glass_kind(uint32_t polygon) const;

  double offset() const;                     // m: 1e-5 of the scene's diagonal
  const Box& body_box(uint32_t body) const;  // rest
  const Box& scene_box() const;              // rest

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace strad
