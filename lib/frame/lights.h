// The scene's lights prepared for an instant, and how they reach single points: the parts of direct light
// that the renderer weighs and samples apart.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "light/direct.h"
#include "light/tracer.h"

namespace strad {

// The emitting polygons of one object and material, lit and shadowed as one light.
struct AreaLight {
  uint32_t material = 0;
  std::vector<uint32_t> polygons;
};
std::vector<AreaLight> area_lights(const Scene& scene);

// An emitting polygon where it is at an instant, world.
struct Emitter {
  std::array<Vec3, 4> corners;
  int count = 3;
  Vec3 normal;
  double area = 0;
  bool parallelogram = false;
  uint32_t polygon = kNone;
};

struct LitInstant {
  Instant instant;
  std::vector<double> cos_outer;               // per spot
  std::vector<std::vector<Emitter>> emitters;  // per area light
  std::vector<Rgb> radiance;                   // per area light, W / (sr m^2)
};
LitInstant lit_instant(const Scene& scene, const std::vector<AreaLight>& lights, double time);

// W / m^2 from all spots. `reached` takes up which of them reach the point: equal sets give equal values.
Rgb spot_irradiance(const Scene& scene, const Tracer& tracer, const LitInstant& lit,
                    const SurfacePoint& point, uint64_t* reached);

// How an area light would reach a point if nothing stood between them.
struct AreaView {
  double irradiance = 0;      // for unit radiance, in [0, pi]
  std::vector<double> up_to;  // running sum of it over the emitters
};
// `view` is filled anew; it is a parameter so that its memory is used again.
void look_at(const std::vector<Emitter>& emitters, const SurfacePoint& point, AreaView* view);

// Shadow rays to an area light, each weighted by what its piece of the light would bring; the weights of all
// rays have mean 1.
struct Shadow {
  float seen = 0, all = 0;  // sums of weights of the free rays and of all
  int rays = 0, free = 0;
};
// The free fraction of an area light.
inline float free_fraction(const Shadow& shadow) { return shadow.all > 0 ? shadow.seen / shadow.all : 0; }

// Adds the rays to points [first, first + count) of the light's sequence.
void add_shadow_rays(const Tracer& tracer, const LitInstant& lit, const std::vector<Emitter>& emitters,
                     const SurfacePoint& point, const AreaView& view, uint32_t first, uint32_t count,
                     Shadow* shadow);

}  // namespace strad
