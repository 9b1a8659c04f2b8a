#include "solve/prepare/reach.h"

#include <algorithm>

#include "base/none.h"
#include "base/parallel.h"
#include "base/rng.h"
#include "light/emitter.h"
#include "scene/polygon_geometry.h"
#include "solve/prepare/connected_surfaces.h"
#include "solve/prepare/light_walks.h"

namespace strad {
namespace {

constexpr uint32_t kTimes = 64;
// So many hits cannot all have slipped through the cracks between polygons that should touch.
constexpr uint32_t kEnoughHits = 64;
constexpr uint64_t kCoverRays = 4096;  // of a side: if all meet dark surfaces, something stands on it
// Walks back, until one finds light. A surface that is less than kSmall of all area takes a further round
// only if so many walks have found a way out. Others are hollow things that stand on something: what they may
// get through cracks that fine does not show, and there may be thousands of them.
struct Round {
  uint32_t walks;
  int ways_out;  // of the walks before
};
constexpr Round kRounds[] = {{64, 0}, {512, 1}, {4096, 8}};
constexpr double kSmall = 1e-3;
constexpr double kSlack = 0.01;  // of the diagonal of a surface's box, by which it is grown to tell ways out

std::vector<Instant> instants_over(const Scene& scene, const TimeGrid& grid) {
  std::vector<Instant> instants;
  const uint32_t times = std::min(kTimes, grid.sample_count());
  for (uint32_t d = 0; d < times; ++d)
    instants.push_back(
        instant_at(scene, sample_time(grid, static_cast<uint32_t>((d + 0.5) * grid.sample_count() / times))));
  return instants;
}

bool meet(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i)
    if (!(a.lower[i] <= b.upper[i] && b.lower[i] <= a.upper[i])) return false;
  return true;
}

// Of sides of polygons, rest.
Box box_of(const Scene& scene, const uint32_t* begin, const uint32_t* end) {
  Box box;
  for (const uint32_t* side = begin; side != end; ++side) {
    const Polygon& polygon = scene.polygons[*side / 2];
    for (int c = 0; c < polygon.corner_count(); ++c) box.add(scene.vertices[polygon.corners[c]]);
  }
  return box;
}

// Around a box that has been moved.
Box moved(const Box& box, const Pose& pose) {
  Box around;
  for (int corner = 0; corner < 8; ++corner)
    around.add(pose * Vec3{(corner & 1 ? box.upper : box.lower).x, (corner & 2 ? box.upper : box.lower).y,
                           (corner & 4 ? box.upper : box.lower).z});
  return around;
}

// Boxes of all lamps at an instant, ascending by their lower x.
std::vector<Box> lamp_boxes(const Scene& scene, const Instant& instant) {
  std::vector<Box> boxes;
  for (const SpotState& spot : instant.spots) {
    boxes.emplace_back();
    boxes.back().add(spot.position);
  }
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    if (!emits(scene, scene.polygons[p])) continue;
    const uint32_t side = 2 * p;
    const Pose& pose = instant.world_from_body[body_of(scene, scene.polygons[p])];
    boxes.push_back(moved(box_of(scene, &side, &side + 1), pose));
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.lower.x < b.lower.x; });
  return boxes;
}

// Glass that reflects nothing diffusely: all that it receives goes on, or is lost.
bool only_passes(const Scene& scene, const Tracer& tracer, uint32_t polygon) {
  return tracer.glass_kind(polygon) != GlassKind::kNone &&
         is_black(scene.materials[scene.polygons[polygon].material].reflectance);
}

// By surface: does it enclose its space, with no lamp in its box at any of the instants?
std::vector<char> surely_dark(const Scene& scene, const Tracer& tracer, const ConnectedSurfaces& surfaces,
                              const std::vector<Instant>& instants) {
  std::vector<char> dark(surfaces.count());
  std::vector<Box> boxes(surfaces.count());
  for (uint32_t s = 0; s < surfaces.count(); ++s) {
    dark[s] = surfaces.encloses(s) && std::none_of(surfaces.begin(s), surfaces.end(s), [&](uint32_t side) {
                return tracer.glass_kind(side / 2) != GlassKind::kNone;
              });
    if (dark[s]) boxes[s] = box_of(scene, surfaces.begin(s), surfaces.end(s));
  }
  for (const Instant& instant : instants) {
    const std::vector<Box> lamps = lamp_boxes(scene, instant);
    parallel_for(dark.size(), 64, [&](size_t begin, size_t end) {
      for (size_t s = begin; s < end; ++s) {
        if (!dark[s]) continue;
        const Polygon& any = scene.polygons[*surfaces.begin(static_cast<uint32_t>(s)) / 2];
        const Box box = moved(boxes[s], instant.world_from_body[body_of(scene, any)]);
        for (const Box& lamp : lamps) {
          if (lamp.lower.x > box.upper.x) break;
          if (meet(lamp, box)) dark[s] = false;
        }
      }
    });
  }
  return dark;
}

Box grown(Box box) {
  const double by = kSlack * box.diagonal();
  return {box.lower - Vec3{by, by, by}, box.upper + Vec3{by, by, by}};
}

// Do walks back from points spread over a surface by area find light? `lit`: the sides of which that is
// known; `all_area`: m^2, of all sides.
bool finds_light(const Scene& scene, const ConnectedSurfaces& surfaces, uint32_t surface,
                 const LightWalks& walks, const std::vector<bool>& lit, double all_area) {
  std::vector<double> up_to;
  double area = 0;
  const uint32_t *begin = surfaces.begin(surface), *end = surfaces.end(surface);
  for (const uint32_t* side = begin; side != end; ++side)
    up_to.push_back(area += polygon_area(scene, scene.polygons[*side / 2]));
  const Box home = grown(box_of(scene, begin, end));
  int ways_out = 0;
  uint32_t key = 0;
  for (const auto& [round, needed] : kRounds) {
    if (area < kSmall * all_area && ways_out < needed) return false;
    for (uint32_t i = 0; i < round; ++i, ++key) {
      // Strata of the area: each round covers all of the surface.
      const double target = area * (i + unit_from(hash_of(surface, key, 17))) / round;
      const auto chosen = std::upper_bound(up_to.begin(), up_to.end() - 1, target);
      const LightWalks::Found found = walks.find_light(begin[chosen - up_to.begin()], home, lit, key);
      if (found == LightWalks::Found::kLight) return true;
      ways_out += found == LightWalks::Found::kWayOut;
    }
  }
  return false;
}

}  // namespace

std::vector<bool> reached_sides(const Scene& scene, const Tracer& tracer, const TimeGrid& grid,
                                const std::vector<bool>& known_dark) {
  const ConnectedSurfaces surfaces(scene);
  const std::vector<Instant> instants = instants_over(scene, grid);
  const LightWalks walks(scene, tracer, instants);
  const std::vector<char> dark = surely_dark(scene, tracer, surfaces, instants);
  const auto is_known_dark = [&](uint32_t side) { return !known_dark.empty() && known_dark[side]; };
  double all_area = 0;
  for (const Polygon& polygon : scene.polygons) all_area += 2 * polygon_area(scene, polygon);
  std::vector<uint64_t> hits(surfaces.count());
  for (uint32_t side = 0; side < walks.hits().size(); ++side)
    hits[surfaces.surface_of(side)] += walks.hits()[side];
  std::vector<bool> lit(2 * scene.polygons.size());
  for (uint32_t side = 0; side < lit.size(); ++side) {
    const uint32_t s = surfaces.surface_of(side);
    lit[side] = !dark[s] && hits[s] >= kEnoughHits;
  }
  std::vector<char> is_reached(surfaces.count(), 0);
  parallel_for(surfaces.count(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto s = static_cast<uint32_t>(i);
      if (dark[s] || !walks.has_lights()) continue;
      if (std::all_of(surfaces.begin(s), surfaces.end(s), is_known_dark)) continue;
      is_reached[s] = hits[s] >= kEnoughHits || finds_light(scene, surfaces, s, walks, lit, all_area);
    }
  });
  const auto on_reached = [&](uint32_t side) { return is_reached[surfaces.surface_of(side)] != 0; };
  std::vector<char> covered(2 * scene.polygons.size(), 0);
  parallel_for(covered.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto side = static_cast<uint32_t>(i);
      if (!on_reached(side) || is_known_dark(side)) continue;
      covered[side] = true;
      for (uint64_t key = 0; covered[side] && key < kCoverRays; ++key) {
        const uint32_t seen = walks.side_seen_from(side, key);
        covered[side] = seen != kNone && !on_reached(seen);
      }
    }
  });
  std::vector<bool> reached(2 * scene.polygons.size());
  for (uint32_t side = 0; side < reached.size(); ++side)
    reached[side] =
        on_reached(side) && !covered[side] && !is_known_dark(side) && !only_passes(scene, tracer, side / 2);
  return reached;
}

}  // namespace strad
