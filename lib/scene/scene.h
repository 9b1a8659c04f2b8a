// A scene at rest and how it moves. Plain data with indices, filled by import/ and by the motion language.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/none.h"
#include "base/pose.h"
#include "base/rgb.h"
#include "base/vec.h"

namespace strad {

// How opaque a texture is: its holes are where it is less than half. Rows from the top.
struct Opacity {
  uint32_t width = 0, height = 0;  // need not be the texture's
  std::vector<uint8_t> values;     // width * height, 255: opaque; empty: no holes
};

// Texture of a material's reflectance, 8-bit sRGB, rows from the top.
struct Texture {
  std::string name;  // as the MTL file spells it
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> srgb;  // width * height * 3
  bool clamp = false;         // outside of 0..1 its edge goes on; else it repeats
  Opacity opacity{};
};

constexpr float kLeastIor = 0.01f, kMostIor = 100;

// What a surface does to light beside diffuse reflection: a mirror, or glass. The solve knows of it only what
// goes straight through. At an angle, the share R of what comes is reflected: the specular reflectance, times
// what Fresnel's equations say if `fresnel`. Of the rest, 1 - R, the transmission goes through.
struct Finish {
  Rgb specular;           // 0..1
  float roughness = 0;    // 0..1: alpha of a GGX distribution of facets; 0 a perfect mirror; glass is smooth
  Rgb transmission;       // 0..1, of light that is not reflected; black: opaque
  float ior = 1.5f;       // index of refraction over that of air, kLeastIor..kMostIor
  bool fresnel = false;   // the specular reflectance is multiplied by that of a dielectric
  bool metallic = false;  // the specular reflectance grows to white at grazing angles
  bool operator==(const Finish&) const = default;
};

struct Material {
  std::string name;
  Rgb reflectance{0.5f, 0.5f, 0.5f};  // 0..1; multiplied by the texture where there is one
  Rgb emission;                       // radiance Le, W / (sr m^2), from the front side, before any glow
  uint32_t texture = kNone;
  Finish finish{};
};

inline bool is_plain(const Finish& finish) {
  return is_black(finish.specular) && is_black(finish.transmission);
}

// An OBJ object or group. Several may have the same body.
struct Object {
  std::string name;
  uint32_t body = 0;
};

// Planar and convex, counter-clockwise seen from its front.
struct Polygon {
  uint32_t corners[4] = {kNone, kNone, kNone, kNone};  // vertices; the last is kNone for a triangle
  uint32_t uvs[4] = {kNone, kNone, kNone, kNone};      // texture coordinates, kNone where there are none
  uint32_t material = 0;
  uint32_t object = 0;
  // Of a smooth surface that the polygon is a facet of, at all its corners; kNone at all of a flat one.
  uint32_t normals[4] = {kNone, kNone, kNone, kNone};
  int corner_count() const { return corners[3] == kNone ? 3 : 4; }
  bool is_smooth() const { return normals[0] != kNone; }
};

enum class Ease : uint8_t { kLinear = 0, kSmooth = 1 };

struct BodyKey {
  double time = 0;  // s
  Vec3 move;        // m
  double turn = 0;  // radians about the body's axis; used unless `has_quat`
  bool has_quat = false;
  Quat quat;
};

// A rigid body. At rest coordinates x it is at pivot + move(t) + R(t) (x - pivot), then its parent's
// transform.
struct Body {
  std::string name;
  uint32_t parent = 0;  // always smaller than the body's own index
  Vec3 pivot{};
  Vec3 axis{0, 1, 0};  // unit length
  Ease ease = Ease::kLinear;
  std::vector<BodyKey> keys{};       // ordered by time; two at the same time: a step; none: at rest
  std::vector<std::string> parts{};  // the patterns as given, for strad-info
};

struct SpotKey {
  double time = 0;
  Vec3 at, aim;   // points at rest, m
  Rgb intensity;  // W / sr
};

// I(theta) = I0 * smoothstep(cos outer, cos inner, cos theta), falling with 1 / r^2.
struct Spot {
  std::string name;
  uint32_t body = 0;
  double inner = 0, outer = 0;  // half-angles, radians, 0 <= inner <= outer < pi
  std::vector<SpotKey> keys;    // at least one
};

struct GlowKey {
  double time = 0;
  float value = 1;
  bool operator==(const GlowKey&) const = default;
};

// Scale of a material's emission over time.
struct Glow {
  uint32_t material = 0;
  std::vector<GlowKey> keys;
};

struct CameraKey {
  double time = 0;
  Vec3 from, to, up{0, 1, 0};
  double fov = 0.7;  // vertical, radians
};

struct Camera {
  std::string name;
  std::vector<CameraKey> keys;
};

struct Scene {
  std::vector<Vec3> vertices;  // rest, world, m (stored as float)
  std::vector<Vec2> uvs;
  std::vector<Vec3> normals;  // of smooth surfaces, rest, unit, on the side of the polygon's front
  std::vector<Polygon> polygons;
  std::vector<Object> objects;
  std::vector<Material> materials;
  std::vector<Texture> textures;

  double start = 0, end = 0;  // s; equal: a still
  double rate = 25;           // frames per second
  // 0 is the world: no keys, never moves.
  std::vector<Body> bodies{Body{"world", 0, {}, {0, 1, 0}, Ease::kLinear, {}, {}}};
  std::vector<Spot> spots;
  std::vector<Glow> glows;  // at most one per material
  std::vector<Camera> cameras;

  std::vector<std::string> provenance;  // one line per tool that was run: version and command line
};

// Throws BadInput, which names the first fault, unless every index is in range, every number finite and every
// key list in order. All other functions of the library assume that it passed.
void validate(const Scene& scene);

inline uint32_t body_of(const Scene& scene, const Polygon& polygon) {
  return scene.objects[polygon.object].body;
}
inline bool emits(const Scene& scene, const Polygon& polygon) {
  return !is_black(scene.materials[polygon.material].emission);
}

bool has_finishes(const Scene& scene);  // does any material mirror or let light through?

// Frame k (1-based) is the instant start + (k - 1) / rate.
inline double frame_time(const Scene& scene, double frame) { return scene.start + (frame - 1) / scene.rate; }
// Number of frames in [start, end): 600 for 24 s at 25 per second; at least 1.
int frame_count(const Scene& scene);

}  // namespace strad
