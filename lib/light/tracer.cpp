#include "light/tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <deque>
#include <span>

#include "base/error.h"
#include "scene/polygon_geometry.h"
#include "scene/texture.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

struct LocalRay {
  Vec3 from, direction;
};

// Bodies that never move share one structure, in world coordinates; each moving body has its own, at rest.
struct Group {
  const Scene* of = nullptr;
  RTCScene scene = nullptr;
  uint32_t body = 0;
  bool moves = false;
  Vec3 middle;  // the origin of Embree's coordinates, which are floats
  std::vector<uint32_t> polygon_of_triangle;
  std::vector<bool> second_of_quad;  // [triangle]: corners 0, 2, 3 of its polygon, not 0, 1, 2
  uint32_t first_with_holes = 0;     // triangles from here on may have holes
};

// Embree's numbers of the geometries of a group.
constexpr uint32_t kWhole = 0, kWithHoles = 1;

// The nearest hit so far, as the ray tracer tells it.
struct Nearest {
  const Group* group = nullptr;
  uint32_t triangle = 0;
  float u = 0, v = 0;  // weights of the triangle's second and third corner
  double distance = 0;
  bool front = true;
  LocalRay ray;
};

// A quad on whose triangles parametric coordinates are sums of their weights.
bool is_parallelogram(const Scene& scene, const Polygon& polygon) {
  const auto at = [&](int i) { return scene.vertices[polygon.corners[i]]; };
  return length(at(0) + at(2) - at(1) - at(3)) < 1e-6 * length(at(2) - at(0));
}

RTCRay embree_ray(const LocalRay& local, double reach) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(local.from.x);
  ray.org_y = static_cast<float>(local.from.y);
  ray.org_z = static_cast<float>(local.from.z);
  ray.dir_x = static_cast<float>(local.direction.x);
  ray.dir_y = static_cast<float>(local.direction.y);
  ray.dir_z = static_cast<float>(local.direction.z);
  ray.tfar = static_cast<float>(reach);
  ray.mask = 0xffffffffu;
  return ray;
}

// Floats tell apart 1e-7 of what they hold, and rays are lifted off surfaces by 1e-5 of the scene's diagonal.
// So that this is not lost, coordinates that are further from the origin than a few diagonals are taken from
// their middle.
Vec3 middle_of(const std::vector<Vec3>& corners, double scene_diagonal) {
  constexpr double kNear = 4;  // diagonals
  Box box;
  for (const Vec3& corner : corners) box.add(corner);
  return length(box.centre()) > kNear * scene_diagonal ? box.centre() : Vec3{};
}

// Called by Embree for hits of the geometry with holes: those in a hole do not count.
void pass_holes(const RTCFilterFunctionNArguments* args) {
  const Group& group = *static_cast<const Group*>(args->geometryUserPtr);
  const uint32_t triangle = group.first_with_holes + RTCHitN_primID(args->hit, args->N, 0);
  const Polygon& polygon = group.of->polygons[group.polygon_of_triangle[triangle]];
  const double u = RTCHitN_u(args->hit, args->N, 0), v = RTCHitN_v(args->hit, args->N, 0);
  const int second = group.second_of_quad[triangle] ? 2 : 1;
  const auto uv = [&](int corner) { return group.of->uvs[polygon.uvs[corner]]; };
  const Vec2 a = uv(0), b = uv(second), c = uv(second + 1);
  const Vec2 at{(1 - u - v) * a.x + u * b.x + v * c.x, (1 - u - v) * a.y + u * b.y + v * c.y};
  if (is_hole(group.of->textures[group.of->materials[polygon.material].texture], at)) args->valid[0] = 0;
}

LocalRay into(const Group& group, const std::vector<Pose>& world_from_body, Vec3 from, Vec3 direction) {
  if (!group.moves) return {from - group.middle, direction};
  const Pose& pose = world_from_body[group.body];
  const Quat back = conjugate(pose.rotation);
  return {rotate(back, from - pose.translation) - group.middle, rotate(back, direction)};
}

}  // namespace

struct Tracer::State {
  RTCDevice device = nullptr;
  std::deque<Group> groups;  // Embree keeps pointers to them
  std::vector<Box> body_boxes;
  Box scene_box;
  const Scene* scene = nullptr;
  std::vector<Pose> static_poses;
  std::vector<bool> parallelogram;  // [polygon]

  ~State() {
    for (const Group& group : groups) rtcReleaseScene(group.scene);
    if (device) rtcReleaseDevice(device);
  }

  void add_group(uint32_t body, bool moves, std::vector<uint32_t> polygons) {
    const auto with_holes = std::stable_partition(polygons.begin(), polygons.end(), [&](uint32_t p) {
      return !may_have_holes(*scene, scene->polygons[p]);
    });
    if (polygons.empty()) return;
    Group& group = groups.emplace_back();
    group.of = scene;
    group.body = body;
    group.moves = moves;
    std::vector<Vec3> positions;
    const auto add = [&](uint32_t p) {
      const Polygon& polygon = scene->polygons[p];
      const uint32_t owner = body_of(*scene, polygon);
      const auto push = [&](int corner) {
        const Vec3 rest = scene->vertices[polygon.corners[corner]];
        positions.push_back(moves ? rest : static_poses[owner] * rest);
      };
      for (int t = 0; t + 2 < polygon.corner_count(); ++t) {
        push(0), push(t + 1), push(t + 2);
        group.polygon_of_triangle.push_back(p);
        group.second_of_quad.push_back(t == 1);
      }
    };
    std::for_each(polygons.begin(), with_holes, add);
    group.first_with_holes = static_cast<uint32_t>(positions.size() / 3);
    std::for_each(with_holes, polygons.end(), add);
    group.middle = middle_of(positions, scene_box.diagonal());
    group.scene = rtcNewScene(device);
    rtcSetSceneFlags(group.scene, RTC_SCENE_FLAG_ROBUST);
    const auto middle = positions.begin() + 3 * static_cast<ptrdiff_t>(group.first_with_holes);
    attach(&group, kWhole, {positions.begin(), middle});
    attach(&group, kWithHoles, {middle, positions.end()});
    rtcCommitScene(group.scene);
  }

  void attach(Group* group, uint32_t number, std::span<const Vec3> positions) {
    if (positions.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
    auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), positions.size() / 3));
    if (!vertices || !indices) throw IoError("out of memory for the ray tracer");
    for (size_t i = 0; i < positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis)
        vertices[3 * i + static_cast<size_t>(axis)] =
            static_cast<float>(positions[i][axis] - group->middle[axis]);
      indices[i] = static_cast<uint32_t>(i);
    }
    if (number == kWithHoles) {
      rtcSetGeometryUserData(geometry, group);
      rtcSetGeometryIntersectFilterFunction(geometry, pass_holes);
      rtcSetGeometryOccludedFilterFunction(geometry, pass_holes);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(group->scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }

  bool occluded(const Group& group, const std::vector<Pose>& poses, Vec3 from, Vec3 direction) const {
    const LocalRay local = into(group, poses, from, direction);
    if (group.moves && !body_boxes[group.body].meets(local.from + group.middle, local.direction, 1))
      return false;
    RTCRay ray = embree_ray(local, 1.0);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(group.scene, &context, &ray);
    return ray.tfar < 0;
  }

  void closest(const Group& group, const std::vector<Pose>& poses, Vec3 from, Vec3 direction, double reach,
               Nearest* best) const {
    const LocalRay local = into(group, poses, from, direction);
    if (best->group) reach = best->distance;
    if (group.moves && !body_boxes[group.body].meets(local.from + group.middle, local.direction, reach))
      return;
    RTCRayHit query{};
    query.ray = embree_ray(local, reach);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(group.scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    const bool front = query.hit.Ng_x * query.ray.dir_x + query.hit.Ng_y * query.ray.dir_y +
                           query.hit.Ng_z * query.ray.dir_z <
                       0;
    const uint32_t first = query.hit.geomID == kWithHoles ? group.first_with_holes : 0;
    *best = {&group, first + query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar, front, local};
  }

  SurfaceHit hit_of(const Nearest& nearest) const {
    SurfaceHit hit;
    if (!nearest.group) return hit;
    hit.polygon = nearest.group->polygon_of_triangle[nearest.triangle];
    hit.front = nearest.front;
    hit.distance = nearest.distance;
    const Vec3 at = nearest.ray.from + nearest.group->middle + nearest.distance * nearest.ray.direction;
    const Polygon& polygon = scene->polygons[hit.polygon];
    const uint32_t body = body_of(*scene, polygon);
    hit.rest_point = nearest.group->moves || body == 0 ? at : inverse(static_poses[body]) * at;
    hit.uv = uv_of(nearest, polygon, hit);
    return hit;
  }

  Vec2 uv_of(const Nearest& nearest, const Polygon& polygon, const SurfaceHit& hit) const {
    const double u = std::clamp(nearest.u, 0.0f, 1.0f), v = std::clamp(nearest.v, 0.0f, 1.0f);
    if (polygon.corner_count() == 3) return {u, v};
    if (!parallelogram[hit.polygon]) return parametric_of(*scene, polygon, hit.rest_point);
    const double both = std::min(u + v, 1.0);
    return nearest.group->second_of_quad[nearest.triangle] ? Vec2{u, both} : Vec2{both, v};
  }
};

Tracer::Tracer(const Scene& scene) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.scene = &scene;
  s.static_poses = poses_at(scene, scene.start);
  for (const Polygon& polygon : scene.polygons)
    s.parallelogram.push_back(polygon.corner_count() == 4 && is_parallelogram(scene, polygon));
  s.body_boxes.resize(scene.bodies.size());
  for (const Polygon& polygon : scene.polygons)
    for (int c = 0; c < polygon.corner_count(); ++c) {
      const Vec3 at = scene.vertices[polygon.corners[c]];
      s.body_boxes[body_of(scene, polygon)].add(at);
      s.scene_box.add(at);
    }
  s.device = rtcNewDevice("set_affinity=0");
  if (!s.device) throw IoError("the ray tracer could not be started");
  const std::vector<bool> moving = moving_bodies(scene);
  std::vector<std::vector<uint32_t>> polygons_of(moving.size());  // all that are still at 0
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const uint32_t body = body_of(scene, scene.polygons[p]);
    polygons_of[moving[body] ? body : 0].push_back(p);
  }
  s.add_group(0, false, polygons_of[0]);
  for (uint32_t b = 1; b < moving.size(); ++b)
    if (moving[b]) s.add_group(b, true, polygons_of[b]);
}

Tracer::~Tracer() = default;

bool Tracer::occluded(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 to) const {
  for (const Group& group : state_->groups)
    if (state_->occluded(group, world_from_body, from, to - from)) return true;
  return false;
}

bool Tracer::occluded_by(const std::vector<Pose>& world_from_body, const std::vector<bool>& mask, Vec3 from,
                         Vec3 to) const {
  for (const Group& group : state_->groups)
    if (mask[group.body] && state_->occluded(group, world_from_body, from, to - from)) return true;
  return false;
}

SurfaceHit Tracer::closest(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 direction,
                           double reach) const {
  Nearest best;
  for (const Group& group : state_->groups)
    state_->closest(group, world_from_body, from, direction, reach, &best);
  return state_->hit_of(best);
}

SurfaceHit Tracer::closest_of(const std::vector<Pose>& world_from_body, const std::vector<bool>& mask,
                              Vec3 from, Vec3 direction, double reach) const {
  Nearest best;
  for (const Group& group : state_->groups)
    if (mask[group.body]) state_->closest(group, world_from_body, from, direction, reach, &best);
  return state_->hit_of(best);
}

double Tracer::offset() const { return 1e-5 * state_->scene_box.diagonal(); }
const Box& Tracer::body_box(uint32_t body) const { return state_->body_boxes[body]; }
const Box& Tracer::scene_box() const { return state_->scene_box; }

}  // namespace strad
