#include "frame/probe.h"

#include <cmath>

#include "base/parallel.h"
#include "solution/mesh.h"

namespace strad {
namespace {

// Nearest point of a triangle (Ericson 2004, "Real-Time Collision Detection", 5.1.5).
Vec3 nearest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = dot(ab, p - a), d2 = dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = dot(ab, p - b), d4 = dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return a + (d1 / (d1 - d3)) * ab;
  const double d5 = dot(ab, p - c), d6 = dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6 && d4 - d3 + d5 - d6 > 0)
    return b + ((d4 - d3) / (d4 - d3 + d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return sum > 0 ? a + (vb / sum) * ab + (vc / sum) * ac : a;
}

Vec3 nearest_on_polygon(const Scene& scene, const Polygon& polygon, Vec3 p) {
  const auto corner = [&](int i) { return scene.vertices[polygon.corners[i]]; };
  const Vec3 near = nearest_on_triangle(p, corner(0), corner(1), corner(2));
  if (polygon.corner_count() == 3) return near;
  const Vec3 other = nearest_on_triangle(p, corner(0), corner(2), corner(3));
  return length2(other - p) < length2(near - p) ? other : near;
}

double scene_size(const Scene& scene) {
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  return box.diagonal();
}

}  // namespace

ProbePoint nearest_point(const Scene& scene, const ProbeQuery& query) {
  const double tie = 1e-6 * scene_size(scene);  // vertices are floats
  double nearest = std::numeric_limits<double>::infinity(), facing = 0;
  ProbePoint best;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon& polygon = scene.polygons[p];
    const Vec3 on = nearest_on_polygon(scene, polygon, query.position);
    const double distance = length(on - query.position);
    const double turned = query.normal ? dot(polygon_normal(scene, polygon), *query.normal) : 1;
    const bool equally_near = std::abs(distance - nearest) <= tie;
    const bool better = equally_near ? std::abs(turned) > std::abs(facing) : distance < nearest;
    if (!better) continue;
    nearest = std::min(nearest, distance);
    facing = turned;
    best = {p, turned >= 0, on};
  }
  return best;
}

Probe::Probe(const Scene& scene, std::vector<ProbePoint> points, const ProbeOptions& options)
    : scene_(scene),
      points_(std::move(points)),
      options_(options),
      tracer_(scene),
      surfaces_(scene, tracer_),
      groups_(emitter_groups(scene)) {}
Probe::~Probe() = default;

void Probe::follow(std::vector<ProbePoint> points) {
  points_ = std::move(points);
  prepared_ = nullptr;
}

void Probe::prepare(const Slab& slab) {
  if (prepared_ == &slab && prepared_begin_ == slab_begin(slab)) return;
  const Reconstruction reconstruction(slab.mesh);
  sources_.assign(points_.size(), {});
  for (size_t i = 0; i < points_.size(); ++i) {
    const ProbePoint& point = points_[i];
    const uint32_t face = slab.mesh.face_of_side[2 * size_t{point.polygon} + (point.front ? 0 : 1)];
    if (face == kNone) continue;
    const Vec2 at = parametric_of(scene_, scene_.polygons[point.polygon], point.rest_point);
    sources_[i] =
        options_.flat ? reconstruction.flat_sources(face, at) : reconstruction.smooth_sources(face, at);
  }
  prepared_ = &slab;
  prepared_begin_ = slab_begin(slab);
}

Rgb Probe::solved(const Slab& slab, size_t i, double time) const {
  Rgb sum;
  for (const VertexWeight& source : sources_[i]) {
    MeshPoint vertex;
    vertex.vertices[0] = source.vertex;
    vertex.weights[0] = source.weight;
    sum += indirect_at(slab, vertex, time, !options_.flat);
    if (options_.direct == ProbeDirect::kMesh) sum += direct_at(slab, vertex, time, !options_.flat);
  }
  return sum;
}

Rgb Probe::direct(const LightsAtInstant& lights, const SurfacePoint& point) const {
  SpotRays spot_rays;
  Rgb sum = spots_irradiance(tracer_, lights.cones, lights.instant, point, &spot_rays);
  GroupSight seen;
  for (const LitGroup& group : lights.groups) {
    if (is_black(group.radiance)) continue;
    see_group(group, point, &seen);
    const double irradiance = unoccluded_irradiance(group, point, seen);
    ShadowRays shadow;
    add_shadow_rays(tracer_, lights.instant, group, point, irradiance, {0, options_.shadow_rays, 0}, &seen,
                    &shadow);
    sum += static_cast<float>(irradiance) * free_colour(shadow) * group.radiance;
  }
  return sum;
}

ProbeValue Probe::at(const Slab& slab, size_t i, const LightsAtInstant& lights) const {
  const ProbePoint& point = points_[i];
  const Sight sight = surfaces_.at(lights.instant, point.polygon, point.front, point.rest_point);
  ProbeValue value;
  value.irradiance = solved(slab, i, lights.instant.time);
  if (options_.direct == ProbeDirect::kPoint) value.irradiance += direct(lights, sight.point);
  value.radiance = sight.emission + static_cast<float>(1 / kPi) * sight.reflectance * value.irradiance;
  return value;
}

std::vector<ProbeValue> Probe::at(const Slab& slab, double time) {
  prepare(slab);
  const LightsAtInstant lights = lights_at(time);
  std::vector<ProbeValue> values(points_.size());
  parallel_for(values.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) values[i] = at(slab, i, lights);
  });
  return values;
}

}  // namespace strad
