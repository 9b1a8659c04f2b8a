#include "frame/surfaces.h"

#include "scene/polygon_geometry.h"
#include "scene/texture.h"
#include "solution/mesh.h"

namespace strad {

Surfaces::Surfaces(const Scene& scene, const Tracer& tracer) : scene_(scene), tracer_(tracer) {
  planes_.reserve(scene.polygons.size());
  for (const Polygon& polygon : scene.polygons) planes_.push_back(plane_of(scene, polygon));
  for (const Material& material : scene.materials)
    finishes_.push_back(is_plain(material.finish) ? nullptr : &material.finish);
}

Surfaces::Plane Surfaces::plane_of(const Scene& scene, const Polygon& polygon) {
  const auto corner = [&](int i) { return scene.vertices[polygon.corners[i]]; };
  const bool quad = polygon.corner_count() == 4;
  Plane plane;
  plane.origin = corner(0);
  plane.normal = polygon_normal(scene, polygon);
  const Vec3 e = corner(1) - corner(0), f = corner(quad ? 3 : 2) - corner(0);
  // Columns of the inverse of (e f n): cross products over the determinant.
  const double determinant = dot(cross(e, f), plane.normal);
  plane.to_u = cross(f, plane.normal) / determinant;
  plane.to_v = cross(plane.normal, e) / determinant;
  const bool parallelogram = !quad || length(corner(2) - corner(1) - f) <= 1e-9 * (length(e) + length(f));
  plane.affine = parallelogram && is_finite(plane.to_u) && is_finite(plane.to_v);
  return plane;
}

// Where shadow rays of a facet start decides where its shadows end. From the facet itself, facets around it
// that are turned away from a light would hide it in part, in steps, where the smooth surface still faces it
// ("shadow terminator"). So rays start from where the planes of tangents at the corners say that the surface
// is (Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, 2021, chapter 4).
SurfacePoint Surfaces::smooth_point(const Polygon& polygon, const Sight& sight, const Pose& pose,
                                    Vec3 rest_point) const {
  const CornerWeights weights = corner_weights(polygon, sight.at);
  Vec3 normal, lifted = rest_point;
  for (int c = 0; c < polygon.corner_count(); ++c) {
    const Vec3 at_corner =
        sight.front ? scene_.normals[polygon.normals[c]] : -scene_.normals[polygon.normals[c]];
    normal = normal + weights.of[c] * at_corner;
    const double below = dot(rest_point - scene_.vertices[polygon.corners[c]], at_corner);
    if (below < 0) lifted = lifted - weights.of[c] * below * at_corner;
  }
  if (!(length(normal) > 1e-6)) return sight.point;
  return {pose * lifted, rotate(pose, normalized(normal)), sight.point.polygon};
}

Sight Surfaces::at(const Instant& instant, uint32_t p, bool front, Vec3 rest_point, Vec3 direction) const {
  const Polygon& polygon = scene_.polygons[p];
  const Material& material = scene_.materials[polygon.material];
  const Plane& plane = planes_[p];
  const Pose& pose = instant.world_from_body[body_of(scene_, polygon)];
  Sight sight;
  sight.front = front;
  sight.point = {pose * rest_point, rotate(pose, front ? plane.normal : -plane.normal), p};
  const Vec3 from_origin = rest_point - plane.origin;
  sight.at = plane.affine ? Vec2{dot(from_origin, plane.to_u), dot(from_origin, plane.to_v)}
                          : parametric_of(scene_, polygon, rest_point);
  sight.smooth = polygon.is_smooth() ? smooth_point(polygon, sight, pose, rest_point) : sight.point;
  sight.reflectance = material.reflectance;
  sight.finish = finishes_[polygon.material];
  sight.direction = direction;
  sight.textured = has_texture(scene_, polygon);
  if (sight.textured) {
    const Vec2 uv = texture_uv(scene_, polygon, sight.at);
    sight.reflectance = sight.reflectance * texture_colour(scene_.textures[material.texture], uv);
  }
  if (front) sight.emission = instant.glow[polygon.material] * material.emission;
  return sight;
}

Sight Surfaces::seen(const Instant& instant, const SurfaceHit& hit, Vec3 direction) const {
  return hit.polygon == kNone ? Sight{} : at(instant, hit.polygon, hit.front, hit.rest_point, direction);
}

Sight Surfaces::look(const Instant& instant, Vec3 from, Vec3 direction) const {
  return seen(instant, tracer_.closest(instant.world_from_body, from, direction), direction);
}

Sight Surfaces::look_through(const Instant& instant, Vec3 from, Vec3 direction, Rgb* passed) const {
  return seen(instant, tracer_.closest_through(instant.world_from_body, from, direction, passed), direction);
}

Sight Surfaces::look(const PosedTracer& tracer, const Instant& instant, Vec3 from, Vec3 direction) const {
  return seen(instant, tracer.closest(from, direction), direction);
}

}  // namespace strad
