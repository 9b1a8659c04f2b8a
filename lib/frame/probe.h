// Light at points of surfaces over time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/lit_groups.h"
#include "frame/reconstruction.h"
#include "frame/surfaces.h"
#include "light/tracer.h"
#include "solution/solution.h"

namespace strad {

// A point as the user asks for it.
struct ProbeQuery {
  Vec3 position;               // near a surface at rest, m
  std::optional<Vec3> normal;  // the side that faces it, and of surfaces equally near the one that faces it
                               // most; without one: the front of the first
};

// The nearest point of a surface at rest.
struct ProbePoint {
  uint32_t polygon = kNone;
  bool front = true;
  Vec3 rest_point;
};
// REQUIRES: the scene has a polygon.
ProbePoint nearest_point(const Scene& scene, const ProbeQuery& query);

enum class ProbeDirect {
  kPoint,  // by shadow rays from the point itself
  kMesh,   // from the solution
  kNone,   // left out
};

struct ProbeOptions {
  ProbeDirect direct = ProbeDirect::kPoint;
  bool flat = false;            // the leaf's mean, and intervals of time as they are
  uint32_t shadow_rays = 1024;  // to each emitter group: steps of a thousandth while a shadow passes
};

struct ProbeValue {
  Rgb radiance;    // leaving the surface, W / (sr m^2)
  Rgb irradiance;  // W / m^2
};

class Probe {
 public:
  Probe(const Scene& scene, std::vector<ProbePoint> points,
        const ProbeOptions& options);  // keeps a reference
  ~Probe();
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  // Other points in place of those so far.
  void follow(std::vector<ProbePoint> points);

  // One value per point. REQUIRES: `slab` holds `time`.
  std::vector<ProbeValue> at(const Slab& slab, double time);

  // One point at one instant. Thread-safe. REQUIRES: `slab` was prepared last and holds `lights`'s time.
  ProbeValue at(const Slab& slab, size_t point, const LightsAtInstant& lights) const;
  void prepare(const Slab& slab);
  LightsAtInstant lights_at(double time) const { return strad::lights_at(scene_, groups_, time); }

  const Tracer& tracer() const { return tracer_; }
  const Surfaces& surfaces() const { return surfaces_; }

 private:
  Rgb solved(const Slab& slab, size_t point, double time) const;
  Rgb direct(const LightsAtInstant& lights, const SurfacePoint& point) const;

  const Scene& scene_;
  std::vector<ProbePoint> points_;
  const ProbeOptions options_;
  Tracer tracer_;
  Surfaces surfaces_;
  std::vector<EmitterGroup> groups_;
  std::vector<std::vector<VertexWeight>> sources_;  // per point, in the mesh of the slab prepared last
  const Slab* prepared_ = nullptr;
  double prepared_begin_ = 0;
};

}  // namespace strad
