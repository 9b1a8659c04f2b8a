#include "scene/glass.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/disjoint_sets.h"
#include "scene/polygon_geometry.h"
#include "scene/texture.h"

namespace strad {
namespace {

bool is_glass(const Scene& scene, const Polygon& polygon) {
  return !is_black(scene.materials[polygon.material].finish.transmission) && !emits(scene, polygon) &&
         !may_have_holes(scene, polygon);
}

// The glass of a scene in parts that hang together.
class GlassParts {
 public:
  explicit GlassParts(const Scene& scene) : scene_(scene), parts_(scene.polygons.size()) {
    for (uint32_t p = 0; p < scene.polygons.size(); ++p)
      if (is_glass(scene, scene.polygons[p])) add(p);
  }
  bool none() const { return glass_.empty(); }
  std::vector<GlassKind> kinds();

 private:
  // By place, so that polygons which do not share vertices hang together too.
  using Corner = std::tuple<double, double, double>;
  struct Edge {
    int forward = 0, backward = 0;
    uint32_t polygon = kNone;
  };
  void add(uint32_t p);

  const Scene& scene_;
  std::vector<uint32_t> glass_;
  DisjointSets parts_;
  std::map<std::tuple<uint32_t, uint32_t, Corner, Corner>, Edge> edges_;  // of an object and a material
};

void GlassParts::add(uint32_t p) {
  const Polygon& polygon = scene_.polygons[p];
  glass_.push_back(p);
  const int count = polygon.corner_count();
  for (int c = 0; c < count; ++c) {
    const Vec3 a = scene_.vertices[polygon.corners[c]], b = scene_.vertices[polygon.corners[(c + 1) % count]];
    const Corner from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
    if (from == to) continue;
    Edge& edge = edges_[{polygon.object, polygon.material, std::min(from, to), std::max(from, to)}];
    ++(from < to ? edge.forward : edge.backward);
    if (edge.polygon != kNone) parts_.join(p, edge.polygon);
    edge.polygon = p;
  }
}

std::vector<GlassKind> GlassParts::kinds() {
  std::vector<char> open(scene_.polygons.size());
  std::vector<double> volumes(scene_.polygons.size());
  for (const auto& [key, edge] : edges_)
    if (edge.forward != edge.backward) open[parts_.find(edge.polygon)] = true;
  const Vec3 origin = scene_.vertices[scene_.polygons[glass_.front()].corners[0]];
  for (const uint32_t p : glass_) volumes[parts_.find(p)] += six_volumes(scene_, scene_.polygons[p], origin);
  std::vector<GlassKind> kinds(scene_.polygons.size(), GlassKind::kNone);
  for (const uint32_t p : glass_) {
    const uint32_t part = parts_.find(p);
    const bool solid = !open[part] && volumes[part] != 0;
    kinds[p] = !solid ? GlassKind::kSheet : volumes[part] > 0 ? GlassKind::kSolid : GlassKind::kInverted;
  }
  return kinds;
}

Rgb white_minus(Rgb share) { return Rgb{1, 1, 1} - share; }

}  // namespace

std::vector<GlassKind> glass_kinds(const Scene& scene) {
  GlassParts parts(scene);
  return parts.none() ? std::vector<GlassKind>{} : parts.kinds();
}

double fresnel_reflectance(double cosine, double ior) {
  const double c = std::clamp(cosine, 0.0, 1.0), behind2 = 1 - (1 - c * c) / (ior * ior);
  if (!(behind2 > 0)) return 1;
  const double b = std::sqrt(behind2);
  const double parallel = (ior * c - b) / (ior * c + b), across = (c - ior * b) / (c + ior * b);
  return 0.5 * (parallel * parallel + across * across);
}

Rgb mirrored_share(const Finish& finish, double cosine, double ior) {
  Rgb share = finish.specular;
  if (finish.metallic) {  // Schlick 1994
    const auto grazing = static_cast<float>(std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5));
    share += grazing * white_minus(share);
  } else if (finish.fresnel) {
    share = static_cast<float>(fresnel_reflectance(cosine, ior)) * share;
  }
  return share;
}

// The sum over all ways to and fro between the two sides: R + (1 - R)^2 R (1 + R^2 + ...) = 2 R / (1 + R).
Rgb mirrored_by_pane(const Finish& finish, double cosine) {
  Rgb share = mirrored_share(finish, cosine, finish.ior);
  for (int c = 0; c < 3; ++c) share[c] = 2 * share[c] / (1 + share[c]);
  return share;
}

Rgb straight_share(const Finish& finish, GlassKind kind, double cosine) {
  const Rgb mirrored = kind == GlassKind::kSheet ? mirrored_by_pane(finish, cosine)
                                                 : mirrored_share(finish, cosine, finish.ior);
  return white_minus(mirrored) * finish.transmission;
}

}  // namespace strad
