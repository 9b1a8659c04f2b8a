#include "light/tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <deque>
#include <span>

#include "base/error.h"
#include "base/rng.h"
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
  uint32_t first_of_glass = 0;       // and from here on are glass
  const std::vector<GlassKind>* kinds = nullptr;
};

// Embree's numbers of the geometries of a group.
constexpr uint32_t kWhole = 0, kWithHoles = 1, kGlass = 2;

// Glass that a ray has passed.
struct Crossing {
  double distance;
  Rgb share;  // of light that goes on
};

// What Embree's filters are told of a ray of light.
struct LightContext {
  RTCIntersectContext context;  // first: filters get its address
  bool is_light = false;        // else all glass is seen
  bool meets_diffuse = false;   // may it end on glass that reflects diffusely?
  std::vector<Crossing>* crossings = nullptr;
};

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

// The probability with which a ray of light is to meet the diffuse part of glass.
float diffuse_part(const Material& material) {
  const float reflects = mean_channel(material.reflectance),
              passes = mean_channel(material.finish.transmission);
  return reflects > 0 ? reflects / (reflects + passes) : 0;
}

// A number in [0, 1) of a ray and a triangle, the same for the same ray.
double chance_of(const RTCFilterFunctionNArguments* args, uint32_t triangle) {
  const auto bits = [](float x) { return uint64_t{std::bit_cast<uint32_t>(x)}; };
  RTCRayN* const ray = args->ray;
  const unsigned n = args->N;
  const uint64_t from =
      hash_of(bits(RTCRayN_org_x(ray, n, 0)), bits(RTCRayN_org_y(ray, n, 0)), bits(RTCRayN_org_z(ray, n, 0)));
  const uint64_t to =
      hash_of(bits(RTCRayN_dir_x(ray, n, 0)), bits(RTCRayN_dir_y(ray, n, 0)), bits(RTCRayN_dir_z(ray, n, 0)));
  return unit_from(hash_of(from, to, triangle));
}

// Called by Embree for hits of glass: light goes on, dimmed.
void pass_glass(const RTCFilterFunctionNArguments* args) {
  const auto& light = *reinterpret_cast<const LightContext*>(args->context);
  if (!light.is_light) return;
  const Group& group = *static_cast<const Group*>(args->geometryUserPtr);
  const uint32_t triangle = group.first_of_glass + RTCHitN_primID(args->hit, args->N, 0);
  const uint32_t p = group.polygon_of_triangle[triangle];
  const Material& material = group.of->materials[group.of->polygons[p].material];
  float goes_on = 1;
  if (light.meets_diffuse) {
    const float part = diffuse_part(material);
    if (chance_of(args, triangle) < double{part}) return;
    goes_on = 1 - part;
  }
  args->valid[0] = 0;
  if (!light.crossings) return;
  const Vec3 normal{RTCHitN_Ng_x(args->hit, args->N, 0), RTCHitN_Ng_y(args->hit, args->N, 0),
                    RTCHitN_Ng_z(args->hit, args->N, 0)};
  const Vec3 direction{RTCRayN_dir_x(args->ray, args->N, 0), RTCRayN_dir_y(args->ray, args->N, 0),
                       RTCRayN_dir_z(args->ray, args->N, 0)};
  const double cosine = std::abs(dot(normalized(normal), normalized(direction)));
  light.crossings->push_back({RTCRayN_tfar(args->ray, args->N, 0),
                              (1 / goes_on) * straight_share(material.finish, (*group.kinds)[p], cosine)});
}

// In order of distance, so that the product is the same in whatever order they were found.
Rgb product_of(std::vector<Crossing>* crossings, double reach) {
  std::sort(crossings->begin(), crossings->end(),
            [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
  Rgb product{1, 1, 1};
  for (const Crossing& crossing : *crossings)
    if (crossing.distance < reach) product = product * crossing.share;
  return product;
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
  std::vector<GlassKind> glass;  // [polygon]; empty: none
  std::vector<Pose> static_poses;
  std::vector<bool> parallelogram;  // [polygon]

  ~State() {
    for (const Group& group : groups) rtcReleaseScene(group.scene);
    if (device) rtcReleaseDevice(device);
  }

  void add_group(uint32_t body, bool moves, std::vector<uint32_t> polygons) {
    const auto with_holes = std::stable_partition(polygons.begin(), polygons.end(), [&](uint32_t p) {
      return !may_have_holes(*scene, scene->polygons[p]) && (glass.empty() || glass[p] == GlassKind::kNone);
    });
    const auto of_glass = std::stable_partition(with_holes, polygons.end(), [&](uint32_t p) {
      return glass.empty() || glass[p] == GlassKind::kNone;
    });
    if (polygons.empty()) return;
    Group& group = groups.emplace_back();
    group.of = scene;
    group.kinds = &glass;
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
    const auto triangles = [&] { return static_cast<uint32_t>(positions.size() / 3); };
    std::for_each(polygons.begin(), with_holes, add);
    group.first_with_holes = triangles();
    std::for_each(with_holes, of_glass, add);
    group.first_of_glass = triangles();
    std::for_each(of_glass, polygons.end(), add);
    group.middle = middle_of(positions, scene_box.diagonal());
    group.scene = rtcNewScene(device);
    rtcSetSceneFlags(group.scene, RTC_SCENE_FLAG_ROBUST);
    const auto middle = positions.begin() + 3 * static_cast<ptrdiff_t>(group.first_with_holes);
    attach(&group, kWhole, {positions.begin(), middle});
    const auto last = positions.begin() + 3 * static_cast<ptrdiff_t>(group.first_of_glass);
    attach(&group, kWithHoles, {middle, last});
    attach(&group, kGlass, {last, positions.end()});
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
    if (number != kWhole) {
      const auto filter = number == kGlass ? pass_glass : pass_holes;
      rtcSetGeometryUserData(geometry, group);
      rtcSetGeometryIntersectFilterFunction(geometry, filter);
      rtcSetGeometryOccludedFilterFunction(geometry, filter);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(group->scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }

  bool occluded(const Group& group, const std::vector<Pose>& poses, Vec3 from, Vec3 direction,
                std::vector<Crossing>* crossings) const {
    const LocalRay local = into(group, poses, from, direction);
    if (group.moves && !body_boxes[group.body].meets(local.from + group.middle, local.direction, 1))
      return false;
    RTCRay ray = embree_ray(local, 1.0);
    LightContext light;
    rtcInitIntersectContext(&light.context);
    light.is_light = true;
    light.crossings = crossings;
    rtcOccluded1(group.scene, &light.context, &ray);
    return ray.tfar < 0;
  }

  // `through`: see closest_through; its crossings are those of all that rays may meet in this group.
  void closest(const Group& group, const std::vector<Pose>& poses, Vec3 from, Vec3 direction, double reach,
               Nearest* best, bool through = false, std::vector<Crossing>* crossings = nullptr) const {
    const LocalRay local = into(group, poses, from, direction);
    if (best->group) reach = best->distance;
    if (group.moves && !body_boxes[group.body].meets(local.from + group.middle, local.direction, reach))
      return;
    RTCRayHit query{};
    query.ray = embree_ray(local, reach);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    LightContext light;
    rtcInitIntersectContext(&light.context);
    light.is_light = light.meets_diffuse = through;
    light.crossings = crossings;
    rtcIntersect1(group.scene, &light.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    const bool front = query.hit.Ng_x * query.ray.dir_x + query.hit.Ng_y * query.ray.dir_y +
                           query.hit.Ng_z * query.ray.dir_z <
                       0;
    const uint32_t first = query.hit.geomID == kWithHoles ? group.first_with_holes
                           : query.hit.geomID == kGlass   ? group.first_of_glass
                                                          : 0;
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
  s.glass = glass_kinds(scene);
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

bool Tracer::occluded(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 to, Rgb* passed) const {
  return occluded_by(world_from_body, {}, from, to, passed);
}

bool Tracer::occluded_by(const std::vector<Pose>& world_from_body, const std::vector<bool>& mask, Vec3 from,
                         Vec3 to, Rgb* passed) const {
  const auto any = [&](std::vector<Crossing>* crossings) {
    for (const Group& group : state_->groups)
      if ((mask.empty() || mask[group.body]) &&
          state_->occluded(group, world_from_body, from, to - from, crossings))
        return true;
    return false;
  };
  if (!passed || !has_glass()) return any(nullptr);
  thread_local std::vector<Crossing> crossings;
  crossings.clear();
  if (any(&crossings)) return true;
  *passed = *passed * product_of(&crossings, 1e30);
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

SurfaceHit Tracer::closest_through(const std::vector<Pose>& world_from_body, Vec3 from, Vec3 direction,
                                   Rgb* passed, const std::vector<bool>& mask) const {
  constexpr double kReach = 1e30;
  if (!has_glass() && mask.empty()) return closest(world_from_body, from, direction, kReach);
  thread_local std::vector<Crossing> crossings;
  crossings.clear();
  Nearest best;
  for (const Group& group : state_->groups)
    if (mask.empty() || mask[group.body])
      state_->closest(group, world_from_body, from, direction, kReach, &best, true, &crossings);
  const SurfaceHit hit = state_->hit_of(best);
  if (!passed) return hit;
  *passed = *passed * product_of(&crossings, best.group ? best.distance : kReach);
  if (hit.polygon != kNone && glass_kind(hit.polygon) != GlassKind::kNone)
    *passed =
        (1 / diffuse_part(state_->scene->materials[state_->scene->polygons[hit.polygon].material])) * *passed;
  return hit;
}

bool Tracer::has_glass() const { return !state_->glass.empty(); }
GlassKind Tracer::glass_kind(uint32_t polygon) const {
  return has_glass() ? state_->glass[polygon] : GlassKind::kNone;
}

double Tracer::offset() const { return 1e-5 * state_->scene_box.diagonal(); }
const Box& Tracer::body_box(uint32_t body) const { return state_->body_boxes[body]; }
const Box& Tracer::scene_box() const { return state_->scene_box; }

}  // namespace strad
