#include "solve/prepare/reach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/rng.h"
#include "light/direct.h"
#include "solution/mesh.h"

namespace strad {
namespace {

constexpr uint32_t kWalks = 16384;
constexpr int kBounces = 8;
constexpr uint32_t kTimes = 64;
// A surface with fewer hits than one in a hundred of those expected is dark; it takes 20 expected ones to
// tell.
constexpr double kDarkShare = 0.01, kEnough = 20;

// Connected surfaces: the sides of polygons, joined across the edges they share.
class Surfaces {
 public:
  explicit Surfaces(const Scene& scene) : sets_(2 * scene.polygons.size()) {
    const auto order = [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::vector<Edge> edges;
    for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
      const int n = scene.polygons[p].corner_count();
      for (int i = 0; i < n; ++i) {
        const Vec3 a = scene.vertices[scene.polygons[p].corners[i]];
        const Vec3 b = scene.vertices[scene.polygons[p].corners[(i + 1) % n]];
        const bool forward = order(a, b);
        edges.push_back({forward ? a : b, forward ? b : a, p});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.low.x, a.low.y, a.low.z, a.high.x, a.high.y, a.high.z, a.polygon) <
             std::tie(b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z, b.polygon);
    });
    std::vector<bool> open(scene.polygons.size(), false);
    for (size_t i = 0; i < edges.size();) {
      size_t end = i + 1;
      while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
      if (end - i == 1)
        open[edges[i].polygon] = true;
      else
        join_around(scene, edges[i].low, edges[i].high,
                    {edges.begin() + static_cast<std::ptrdiff_t>(i),
                     edges.begin() + static_cast<std::ptrdiff_t>(end)});
      i = end;
    }
    volume_.assign(sets_.size(), 0.0);
    open_.assign(sets_.size(), false);
    for (uint32_t side = 0; side < sets_.size(); ++side) {
      const Polygon& polygon = scene.polygons[side / 2];
      if (open[side / 2]) open_[find(side)] = true;
      const auto at = [&](int i) { return scene.vertices[polygon.corners[i]]; };
      for (int i = 2; i < polygon.corner_count(); ++i)
        volume_[find(side)] += (side % 2 ? -1 : 1) * dot(at(0), cross(at(i - 1), at(i)));
    }
  }
  // Is this the inner side of a surface that bounds a solid?
  bool is_inside(uint32_t side) {
    const uint32_t surface = find(side);
    return !open_[surface] && volume_[surface] < 0;
  }
  uint32_t find(uint32_t side) { return sets_.find(side); }

 private:
  struct Edge {
    Vec3 low, high;
    uint32_t polygon;
  };
  // Polygons about an edge part space into wedges; the two sides that bound one go on into each other.
  void join_around(const Scene& scene, Vec3 low, Vec3 high, const std::vector<Edge>& edges) {
    struct Leaf {
      double angle;
      uint32_t polygon, ahead;  // the side that faces growing angles
    };
    const Frame frame = frame_about(normalized(high - low));
    std::vector<Leaf> leaves;
    for (const Edge& edge : edges) {
      const Polygon& polygon = scene.polygons[edge.polygon];
      Vec3 centre;
      for (int c = 0; c < polygon.corner_count(); ++c)
        centre += scene.vertices[polygon.corners[c]] / polygon.corner_count();
      const Vec3 into = centre - low;
      const double x = dot(into, frame.tangent), y = dot(into, frame.bitangent);
      const Vec3 turning = x * frame.bitangent - y * frame.tangent;
      const uint32_t back = dot(polygon_normal(scene, polygon), turning) < 0;
      leaves.push_back({std::atan2(y, x), edge.polygon, 2 * edge.polygon + back});
    }
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
      return std::tie(a.angle, a.polygon) < std::tie(b.angle, b.polygon);
    });
    for (size_t i = 0; i < leaves.size(); ++i)
      sets_.join(leaves[i].ahead, leaves[(i + 1) % leaves.size()].ahead ^ 1u);
  }

  DisjointSets sets_;
  std::vector<double> volume_;  // six times that which the surface bounds, negative seen from within
  std::vector<bool> open_;
};

struct Start {
  Vec3 position, direction;
};

Vec3 cosine_about(Vec3 normal, uint64_t seed) {
  const double u = unit_from(mix64(seed)), phi = 2 * kPi * unit_from(mix64(seed + 1));
  const Frame frame = frame_about(normal);
  return std::sqrt(u) * std::cos(phi) * frame.tangent + std::sqrt(u) * std::sin(phi) * frame.bitangent +
         std::sqrt(1 - u) * normal;
}

// Where walk `w` leaves the lights: spots and emitting polygons in turn.
std::optional<Start> start_of(const Scene& scene, const Tracer& tracer, const Instant& instant,
                              const std::vector<uint32_t>& emitters, uint32_t w) {
  const uint64_t seed = hash_of(w, 11);
  const size_t lights = scene.spots.size() + emitters.size();
  if (lights == 0) return std::nullopt;
  const size_t light = static_cast<size_t>(unit_from(seed) * static_cast<double>(lights));
  if (light < scene.spots.size()) {
    const SpotState& spot = instant.spots[light];
    const double cosine = 1 - unit_from(mix64(seed + 1)) * (1 - std::cos(scene.spots[light].outer));
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
                 phi = 2 * kPi * unit_from(mix64(seed + 2));
    const Frame frame = frame_about(spot.direction);
    return Start{spot.position, sine * std::cos(phi) * frame.tangent +
                                    sine * std::sin(phi) * frame.bitangent + cosine * spot.direction};
  }
  const Polygon& polygon = scene.polygons[emitters[light - scene.spots.size()]];
  const Pose& pose = instant.world_from_body[body_of(scene, polygon)];
  double u = unit_from(mix64(seed + 1)), v = unit_from(mix64(seed + 2));
  if (polygon.corner_count() == 3 && u + v > 1) u = 1 - u, v = 1 - v;
  const Vec3 normal = polygon_normal(scene, polygon);
  const Vec3 at = point_of(scene, polygon, {u, v}) + tracer.offset() * normal;
  return Start{pose * at, rotate(pose, cosine_about(normal, seed + 3))};
}

}  // namespace

std::vector<bool> reached_sides(const Scene& scene, const Tracer& tracer, const TimeGrid& grid) {
  const size_t sides = 2 * scene.polygons.size();
  std::vector<uint32_t> emitters;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    if (emits(scene, scene.polygons[p])) emitters.push_back(p);
  std::vector<Instant> instants;
  const uint32_t times = std::min(kTimes, grid.sample_count());
  for (uint32_t d = 0; d < times; ++d)
    instants.push_back(
        instant_at(scene, sample_time(grid, static_cast<uint32_t>((d + 0.5) * grid.sample_count() / times))));

  std::vector<uint32_t> met(size_t{kWalks} * kBounces, kNone);  // side, of each bounce of each walk
  parallel_for(kWalks, 256, [&](size_t begin, size_t end) {
    for (size_t w = begin; w < end; ++w) {
      const Instant& instant = instants[w % times];
      const std::optional<Start> start = start_of(scene, tracer, instant, emitters, static_cast<uint32_t>(w));
      if (!start) return;
      Vec3 from = start->position, towards = start->direction;
      for (int b = 0; b < kBounces; ++b) {
        const SurfaceHit hit = tracer.closest(instant.world_from_body, from, towards);
        if (hit.polygon == kNone) break;
        met[w * kBounces + static_cast<size_t>(b)] = 2 * hit.polygon + (hit.front ? 0 : 1);
        const Polygon& polygon = scene.polygons[hit.polygon];
        const Pose& pose = instant.world_from_body[body_of(scene, polygon)];
        const Vec3 normal = (hit.front ? 1.0 : -1.0) * rotate(pose, polygon_normal(scene, polygon));
        from = pose * hit.rest_point + tracer.offset() * normal;
        towards = cosine_about(normal, hash_of(w, static_cast<uint64_t>(b), 5));
      }
    }
  });

  Surfaces surfaces(scene);
  std::vector<double> area(sides, 0.0), hits(sides, 0.0);
  double total_area = 0, total_hits = 0;
  for (uint32_t side = 0; side < sides; ++side) {
    const double a = polygon_area(scene, scene.polygons[side / 2]);
    area[surfaces.find(side)] += a;
    total_area += a;
  }
  for (const uint32_t side : met) {
    if (side == kNone) continue;
    hits[surfaces.find(side)] += 1;
    total_hits += 1;
  }
  std::vector<bool> reached(sides);
  for (uint32_t side = 0; side < sides; ++side) {
    const uint32_t surface = surfaces.find(side);
    const double expected = total_hits * area[surface] / total_area;
    const bool too_small = expected < kEnough && total_hits > 0;
    reached[side] = hits[surface] > kDarkShare * expected || (too_small && !surfaces.is_inside(side));
  }
  return reached;
}

}  // namespace strad
