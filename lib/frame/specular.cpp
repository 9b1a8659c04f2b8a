#include "frame/specular.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// A facet's normal about z among those that `view`, above the plane, sees of a GGX surface (Heitz 2018).
Vec3 visible_facet(Vec3 view, double alpha, Point2 at) {
  const Vec3 v = normalized({alpha * view.x, alpha * view.y, view.z});
  const double across = v.x * v.x + v.y * v.y;
  const Vec3 t = across > 0 ? Vec3{-v.y, v.x, 0} / std::sqrt(across) : Vec3{1, 0, 0}, b = cross(v, t);
  const double radius = std::sqrt(at.u), angle = 2 * kPi * at.v, x = radius * std::cos(angle);
  const double s = 0.5 * (1 + v.z);
  const double y = (1 - s) * std::sqrt(std::max(0.0, 1 - x * x)) + s * radius * std::sin(angle);
  const Vec3 n = x * t + y * b + std::sqrt(std::max(0.0, 1 - x * x - y * y)) * v;
  return normalized({alpha * n.x, alpha * n.y, std::max(1e-9, n.z)});
}

// Smith's Lambda of GGX, for a direction at that cosine.
double hidden(double cosine, double alpha) {
  const double c2 = std::max(1e-12, cosine * cosine);
  return 0.5 * (std::sqrt(1 + alpha * alpha * (1 - c2) / c2) - 1);
}

Vec3 mirrored(Vec3 direction, Vec3 normal) { return direction - 2 * dot(direction, normal) * normal; }

// The normal of the smooth surface where it faces the ray, else that of the facet.
Vec3 facing_normal(const Sight& sight) {
  return dot(sight.smooth.normal, sight.direction) < 0 ? sight.smooth.normal : sight.point.normal;
}

// A mirrored direction that leads below the facet of a smooth surface is laid onto it.
Vec3 above(Vec3 direction, Vec3 facet) {
  constexpr double kLeast = 1e-3;
  const double height = dot(direction, facet);
  return height >= kLeast ? direction : normalized(direction + (kLeast - height) * facet);
}

SpecularRay rough_ray(const Sight& sight, Vec3 normal, Point2 lobe) {
  const Finish& finish = *sight.finish;
  const Frame frame = frame_about(normal);
  const Vec3 back = -sight.direction;
  const Vec3 view{dot(back, frame.tangent), dot(back, frame.bitangent), std::max(1e-6, dot(back, normal))};
  const double alpha = double{finish.roughness};
  const Vec3 facet = visible_facet(normalized(view), alpha, lobe);
  const Vec3 out = mirrored(-normalized(view), facet);
  if (!(out.z > 0)) return {};  // into other facets
  const double a = hidden(view.z, alpha), b = hidden(out.z, alpha);
  const auto free = static_cast<float>((1 + a) / (1 + a + b));
  return {{},
          out.x * frame.tangent + out.y * frame.bitangent + out.z * normal,
          free * mirrored_share(finish, dot(view, facet), finish.ior)};
}

}  // namespace

SpecularRays specular_rays(GlassKind kind, const Sight& sight, double offset, Point2 lobe) {
  const Finish& finish = *sight.finish;
  const Vec3 normal = facing_normal(sight), facet = sight.point.normal;
  const double cosine = std::clamp(-dot(sight.direction, normal), 1e-6, 1.0);
  const bool solid = kind == GlassKind::kSolid || kind == GlassKind::kInverted;
  const bool outside = sight.front == (kind != GlassKind::kInverted);
  const double ior = solid && !outside ? 1 / double{finish.ior} : double{finish.ior};
  SpecularRays rays;
  if (kind == GlassKind::kNone && finish.roughness > 0) {
    rays.mirrored = rough_ray(sight, normal, lobe);
  } else {
    rays.mirrored.direction = mirrored(sight.direction, normal);
    rays.mirrored.share =
        kind == GlassKind::kSheet ? mirrored_by_pane(finish, cosine) : mirrored_share(finish, cosine, ior);
  }
  rays.mirrored.direction = above(rays.mirrored.direction, facet);
  rays.mirrored.from = sight.point.position + offset * facet;
  if (kind == GlassKind::kNone) return rays;
  rays.passed = {sight.point.position - offset * facet, sight.direction,
                 (Rgb{1, 1, 1} - rays.mirrored.share) * finish.transmission};
  if (!solid) return rays;
  const double behind2 = 1 - (1 - cosine * cosine) / (ior * ior);
  if (!(behind2 > 0)) {
    rays.mirrored.share = finish.fresnel ? finish.specular : Rgb{1, 1, 1};
    rays.passed.share = {};
    return rays;
  }
  // Snell's law.
  const Vec3 along = sight.direction + cosine * normal;
  rays.passed.direction = -above(-normalized(along / ior - std::sqrt(behind2) * normal), facet);
  return rays;
}

}  // namespace strad
