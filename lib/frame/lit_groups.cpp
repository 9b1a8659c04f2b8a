#include "frame/lit_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rng.h"
#include "frame/sobol.h"
#include "frame/spherical_triangle.h"

namespace strad {
namespace {

// Where the edge from a to b crosses the horizon of the point, the plane of the surface there.
Vec3 on_horizon(Vec3 a, Vec3 b, double height_a, double height_b) {
  return lerp(a, b, height_a / (height_a - height_b));
}

// edge_irradiance() of the part of the edge above the horizon.
double clipped_edge(Vec3 a, Vec3 b, double height_a, double height_b, Vec3 normal) {
  if (height_a <= 0 && height_b <= 0) return 0;
  if (height_a <= 0) a = on_horizon(a, b, height_a, height_b);
  if (height_b <= 0) b = on_horizon(a, b, height_a, height_b);
  return edge_irradiance(a, b, normal);
}

// What closes a facet that the horizon cuts: the edge from where its outline sets to where it rises.
double horizon_edge(const LitGroup& group, size_t facet, const SurfacePoint& point, const GroupSight& sight) {
  const Emitter& emitter = group.facets[facet];
  const auto& corners = group.group->corners[facet];
  Vec3 sets, rises;
  bool cut = false;
  for (int i = 0; i < emitter.count; ++i) {
    const int next = (i + 1) % emitter.count;
    const double ha = sight.height[corners[static_cast<size_t>(i)]],
                 hb = sight.height[corners[static_cast<size_t>(next)]];
    if ((ha > 0) == (hb > 0)) continue;
    cut = true;
    (ha > 0 ? sets : rises) = on_horizon(emitter.corners[static_cast<size_t>(i)] - point.position,
                                         emitter.corners[static_cast<size_t>(next)] - point.position, ha, hb);
  }
  return cut ? edge_irradiance(sets, rises, point.normal) : 0;
}

// Mean height of a facet above the horizon, m; corners below it count as 0.
double height_above(const LitGroup& group, size_t facet, const GroupSight& sight) {
  const int count = group.facets[facet].count;
  double sum = 0;
  for (int c = 0; c < count; ++c)
    sum += std::max(0.0, sight.height[group.group->corners[facet][static_cast<size_t>(c)]]);
  return sum / count;
}

// Square of the distance from its centre within which its irradiance is computed exactly: 4 of its radii.
double near_distance2(const Emitter& facet) {
  double radius2 = 0;
  for (int c = 0; c < facet.count; ++c)
    radius2 = std::max(radius2, length2(facet.corners[static_cast<size_t>(c)] - facet.centre));
  return 16 * radius2;
}

bool is_near(const LitGroup& group, size_t facet, Vec3 point) {
  return length2(group.facets[facet].centre - point) < group.near2[facet];
}

// Estimates the irradiance from each facet, and sums it up. From afar: from its middle, with its mean height
// above the horizon, so that none is left out of which some is seen, and never more than a disc of its area
// would give. A facet close by may give much more than that, and too few rays would go to it: its irradiance
// is computed exactly.
void weigh_facets(const LitGroup& group, const SurfacePoint& point, GroupSight* sight) {
  const size_t count = group.facets.size();
  sight->up_to.resize(count);
  double* weight = sight->up_to.data();
  const double *x = group.centres.x.data(), *y = group.centres.y.data(), *z = group.centres.z.data();
  const double *area = group.areas.data(), *distance = sight->distance.data();
  const Vec3 p = point.position, n = point.normal;
  for (size_t f = 0; f < count; ++f) {
    const double tx = x[f] - p.x, ty = y[f] - p.y, tz = z[f] - p.z;
    const double distance2 = tx * tx + ty * ty + tz * tz + area[f] * (1 / kPi);
    const double height = tx * n.x + ty * n.y + tz * n.z;
    const double before = distance[f] > 0 ? distance[f] : 0;
    weight[f] = before * (sight->below_horizon ? 1 : height) * area[f] / (distance2 * distance2);
  }
  double total = 0;
  for (size_t f = 0; f < count; ++f) {
    if (distance[f] > 0) {
      const Emitter& facet = group.facets[f];
      if (is_near(group, f, p))
        weight[f] = unit_irradiance(p, n, facet.corners.data(), facet.count);
      else if (sight->below_horizon)
        weight[f] *= height_above(group, f, *sight);
    }
    weight[f] = total += weight[f];
  }
}

// A point of a facet, and the irradiance from the facet if all of it gave as much as that point.
struct FacetPoint {
  Vec3 position;
  double irradiance;
};

// Maps the unit square onto a convex part of a facet, evenly in solid angle about the point. Evenly in area,
// most points on a large facet close by would be far away and give little.
FacetPoint point_by_angle(const Emitter& facet, const Vec3* part, int count, const SurfacePoint& point,
                          Point2 at) {
  Vec3 towards[5];
  for (int c = 0; c < count; ++c) towards[c] = normalized(part[c] - point.position);
  double up_to[5] = {0, 0, 0, 0, 0};
  for (int t = 2; t < count; ++t)
    up_to[t] = up_to[t - 1] + solid_angle(towards[0], towards[t - 1], towards[t]);
  if (count < 3 || !(up_to[count - 1] > 0)) return {facet.centre, 0};
  const double target = at.u * up_to[count - 1];
  int t = 2;
  while (t + 1 < count && target >= up_to[t]) ++t;
  const double share = up_to[t] - up_to[t - 1];
  if (!(share > 0)) return {facet.centre, 0};
  const Vec3 direction =
      direction_in(towards[0], towards[t - 1], towards[t], share, (target - up_to[t - 1]) / share, at.v);
  const double along = dot(facet.normal, direction);
  if (!(along < 0)) return {facet.centre, 0};
  const double distance = dot(facet.normal, facet.corners[0] - point.position) / along;
  return {point.position + distance * direction,
          std::max(0.0, dot(direction, point.normal)) * up_to[count - 1]};
}

// Maps the unit square onto the part of the facet above the horizon.
FacetPoint facet_point(const LitGroup& group, size_t f, const GroupSight& sight, const SurfacePoint& point,
                       Point2 at) {
  const Emitter& facet = group.facets[f];
  const auto& corners = group.group->corners[f];
  const auto height = [&](int c) { return sight.height[corners[static_cast<size_t>(c % facet.count)]]; };
  bool cut = false;
  for (int c = 0; sight.below_horizon && c < facet.count; ++c) cut |= !(height(c) > 0);
  const bool by_angle = !sight.view && is_near(group, f, point.position);
  if (!cut && by_angle) return point_by_angle(facet, facet.corners.data(), facet.count, point, at);
  if (!cut) {
    const Vec3 position = point_on(facet, at.u, at.v);
    return {position, stretch_at(facet, at.u, at.v) * point_irradiance(facet, position, point)};
  }
  Vec3 kept[5];
  int count = 0;
  for (int c = 0; c < facet.count; ++c) {
    const Vec3 a = facet.corners[static_cast<size_t>(c)],
               b = facet.corners[static_cast<size_t>((c + 1) % facet.count)];
    if (height(c) > 0) kept[count++] = a;
    if ((height(c) > 0) != (height(c + 1) > 0)) kept[count++] = on_horizon(a, b, height(c), height(c + 1));
  }
  if (by_angle) return point_by_angle(facet, kept, count, point, at);
  double up_to[5] = {0, 0, 0, 0, 0};
  for (int t = 2; t < count; ++t)
    up_to[t] = up_to[t - 1] + length(cross(kept[t - 1] - kept[0], kept[t] - kept[0])) / 2;
  if (count < 3 || !(up_to[count - 1] > 0)) return {facet.centre, 0};
  const double target = at.u * up_to[count - 1];
  int t = 2;
  while (t + 1 < count && target >= up_to[t]) ++t;
  const double share = up_to[t] - up_to[t - 1];
  const double root = std::sqrt(share > 0 ? std::clamp((target - up_to[t - 1]) / share, 0.0, 1.0) : 0);
  const Vec3 position =
      (1 - root) * kept[0] + root * (1 - at.v) * kept[t - 1] + root * at.v * kept[t];  // Turk 1990
  return {position, up_to[count - 1] / facet.area * point_irradiance(facet, position, point)};
}

bool see_from_afar(const LitGroup& group, const SurfacePoint& point, GroupSight* sight) {
  const GroupViews& views = group.group->views;
  const Pose rest_from_world = inverse(group.world_from_rest);
  sight->position = rest_from_world * point.position;
  sight->view = views.from(sight->position);
  if (!sight->view) return false;
  sight->normal = rotate(rest_from_world, point.normal);
  sight->below_horizon = false;
  if (!(dot(views.centre() - sight->position, sight->normal) > views.radius())) {
    sight->view = nullptr;
    return false;
  }
  sight->before.assign({0, 1});
  for (const GroupView::Plane& plane : sight->view->doubtful)
    sight->before.push_back(dot(plane.normal, sight->position) > plane.level);
  return true;
}

double irradiance_from_afar(const LitGroup& group, const GroupSight& sight) {
  const std::vector<Vec3>& vertices = group.group->vertices;
  double sum = 0;
  for (const ViewEdge& edge : sight.view->edges) {
    const bool left = sight.before[edge.left];
    if (left == static_cast<bool>(sight.before[edge.right])) continue;
    const double along = edge_irradiance(vertices[edge.from] - sight.position,
                                         vertices[edge.to] - sight.position, sight.normal);
    sum += left ? along : -along;
  }
  return std::max(0.0, -0.5 * sum);
}

}  // namespace

LightsAtInstant lights_at(const Scene& scene, const std::vector<EmitterGroup>& groups, double time) {
  LightsAtInstant lights;
  lights.instant = instant_at(scene, time);
  lights.cones = cones_of(scene.spots);
  for (const EmitterGroup& group : groups) {
    LitGroup& at_time = lights.groups.emplace_back();
    at_time.group = &group;
    at_time.world_from_rest = lights.instant.world_from_body[group.body];
    at_time.radiance = lights.instant.glow[group.material] * scene.materials[group.material].emission;
    for (const uint32_t p : group.polygons) {
      const Emitter facet = emitter_at(scene, p, lights.instant.world_from_body);
      at_time.facets.push_back(facet);
      at_time.centres.add(facet.centre);
      at_time.normals.add(facet.normal);
      at_time.levels.push_back(dot(facet.normal, facet.corners[0]));
      at_time.areas.push_back(facet.area);
      at_time.near2.push_back(near_distance2(facet));
    }
    for (const Vec3 rest : group.vertices)
      at_time.vertices.add(lights.instant.world_from_body[group.body] * rest);
  }
  return lights;
}

void see_group(const LitGroup& group, const SurfacePoint& point, GroupSight* sight) {
  if (see_from_afar(group, point, sight)) return;
  const size_t facets = group.facets.size(), vertices = group.vertices.x.size();
  sight->distance.resize(facets + 1);
  sight->height.resize(vertices);
  double *distance = sight->distance.data(), *height = sight->height.data();
  const Vec3 p = point.position, n = point.normal;
  const double *nx = group.normals.x.data(), *ny = group.normals.y.data(), *nz = group.normals.z.data();
  const double* level = group.levels.data();
  for (size_t f = 0; f < facets; ++f) distance[f] = nx[f] * p.x + ny[f] * p.y + nz[f] * p.z - level[f];
  distance[facets] = -1;
  const uint32_t* polygon = group.group->polygons.data();
  for (size_t f = 0; f < facets; ++f) distance[f] = polygon[f] == point.polygon ? -1 : distance[f];
  const double *x = group.vertices.x.data(), *y = group.vertices.y.data(), *z = group.vertices.z.data();
  double lowest = std::numeric_limits<double>::infinity();
  for (size_t v = 0; v < vertices; ++v) {
    height[v] = (x[v] - p.x) * n.x + (y[v] - p.y) * n.y + (z[v] - p.z) * n.z;
    lowest = std::min(lowest, height[v]);
  }
  sight->below_horizon = !(lowest > 0);
}

double unoccluded_irradiance(const LitGroup& group, const SurfacePoint& point, const GroupSight& sight) {
  if (sight.view) return irradiance_from_afar(group, sight);
  double sum = 0;
  for (const GroupEdge& edge : group.group->edges) {
    const bool left = sight.distance[edge.left] > 0, right = sight.distance[edge.right] > 0;
    if (left == right) continue;
    const double along =
        clipped_edge(group.vertices[edge.from] - point.position, group.vertices[edge.to] - point.position,
                     sight.height[edge.from], sight.height[edge.to], point.normal);
    sum += left ? along : -along;
  }
  for (size_t f = 0; sight.below_horizon && f < group.facets.size(); ++f)
    if (sight.distance[f] > 0) sum += horizon_edge(group, f, point, sight);
  return std::max(0.0, -0.5 * sum);  // outlines run against the clock as seen from the point
}

namespace {

// occluded(from, to, passed): is anything between the two points? See Tracer::occluded.
template <typename Occluded>
void add_rays(const Occluded& occluded, double offset, const LitGroup& group, const SurfacePoint& point,
              double irradiance, ShadowPoints points, GroupSight* sight, ShadowRays* shadow) {
  if (!(irradiance > 0)) return;
  if (!sight->view) weigh_facets(group, point, sight);
  const std::vector<double>& up_to = sight->view ? sight->view->up_to : sight->up_to;
  if (up_to.empty() || !(up_to.back() > 0)) return;
  const Vec3 lifted = point.position + offset * point.normal;
  OwenSequence sequence(points.first, hash_of(points.scramble, group.group->polygons.front()));
  for (uint32_t i = 0; i < points.count; ++i) {
    const Point2 at = sequence.next();
    // Chooses a facet in proportion to its estimated irradiance. The number's position within its share is
    // uniform again.
    const double target = at.u * up_to.back();
    const auto chosen = std::upper_bound(up_to.begin(), up_to.end() - 1, target);
    const auto place = static_cast<size_t>(chosen - up_to.begin());
    const size_t f = sight->view ? sight->view->facets[place] : place;
    const Emitter& facet = group.facets[f];
    const double below = chosen == up_to.begin() ? 0 : *(chosen - 1);
    const double share = *chosen - below, u = std::clamp((target - below) / share, 0.0, 1.0);
    const FacetPoint target_point = facet_point(group, f, *sight, point, {u, at.v});
    const Vec3 on_facet = target_point.position;
    const double weight = target_point.irradiance * up_to.back() / (share * irradiance);
    if (!(weight > 0)) continue;
    ++shadow->rays;
    shadow->all += static_cast<float>(weight);
    Rgb passed{1, 1, 1};
    if (occluded(lifted, on_facet + offset * facet.normal, &passed)) continue;
    ++shadow->free;
    shadow->seen += static_cast<float>(weight);
    if (passed == Rgb{1, 1, 1}) continue;
    ++shadow->through_glass;
    shadow->dimmed += static_cast<float>(weight) * (Rgb{1, 1, 1} - passed);
  }
}

}  // namespace

void add_shadow_rays(const Tracer& tracer, const Instant& instant, const LitGroup& group,
                     const SurfacePoint& point, double irradiance, ShadowPoints points, GroupSight* sight,
                     ShadowRays* shadow) {
  const auto occluded = [&](Vec3 from, Vec3 to, Rgb* passed) {
    return tracer.occluded(instant.world_from_body, from, to, passed);
  };
  add_rays(occluded, tracer.offset(), group, point, irradiance, points, sight, shadow);
}

void add_shadow_rays(const PosedTracer& tracer, const LitGroup& group, const SurfacePoint& point,
                     double irradiance, ShadowPoints points, GroupSight* sight, ShadowRays* shadow) {
  const auto occluded = [&](Vec3 from, Vec3 to, Rgb* passed) { return tracer.occluded(from, to, passed); };
  add_rays(occluded, tracer.offset(), group, point, irradiance, points, sight, shadow);
}

}  // namespace strad
