#include "import/pov/solids.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace strad {
namespace {

bool apart(const Box& a, const Box& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.lower[axis] > b.upper[axis] || b.lower[axis] > a.upper[axis]) return true;
  return false;
}

// Heights of a hull's points over a sheet. A point that touches the sheet counts as beyond it, as seen from
// the side that is asked for: so none is ever on it.
std::vector<double> heights_of(const std::vector<Vec3>& points, const PovSheet& sheet, PovSide side) {
  std::vector<double> heights;
  heights.reserve(points.size());
  const double beyond = side == PovSide::kAbove ? -1e-300 : 1e-300;
  for (const Vec3 p : points) {
    const double height = dot(p - sheet.origin, sheet.frame.normal);
    heights.push_back(std::abs(height) <= sheet.touch ? beyond : height);
  }
  return heights;
}

// The rings in which a hull meets a sheet, with the inside on their left.
RingSet section(const PovHull& hull, const PovSheet& sheet, PovSide side) {
  const std::vector<double> heights = heights_of(hull.points, sheet, side);
  using Edge = std::pair<uint32_t, uint32_t>;
  const auto edge = [](uint32_t a, uint32_t b) { return a < b ? Edge{a, b} : Edge{b, a}; };
  // From one edge that crosses the sheet to the next, over a triangle. An edge of more than two triangles is
  // in it more than once: whichever way rings go on there, they wind around the same points.
  std::multimap<Edge, Edge> next;
  for (const auto& corners : hull.triangles) {
    Edge down, up;
    bool crosses = false;
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = corners[k], b = corners[(k + 1) % 3];
      if ((heights[a] > 0) == (heights[b] > 0)) continue;
      (heights[a] > 0 ? down : up) = edge(a, b);
      crosses = true;
    }
    if (crosses) next.emplace(down, up);
  }
  RingSet rings;
  while (!next.empty()) {
    Ring ring;
    Edge at = next.begin()->first;
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
      const auto [a, b] = at;
      ring.push_back(
          sheet.grid(lerp(hull.points[a], hull.points[b], heights[a] / (heights[a] - heights[b]))));
      at = found->second;
      next.erase(found);
    }
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

RingSet part_behind(const RingSet& region, const PovPlane& plane, const PovSheet& sheet, PovSide side) {
  const Frame& frame = sheet.frame;
  const double over = dot(plane.normal, sheet.origin) - plane.distance;
  const double a = dot(plane.normal, frame.tangent), b = dot(plane.normal, frame.bitangent);
  const double tilt = std::hypot(a, b);
  if (tilt < 1e-9) {  // parallel
    if (std::abs(over) > sheet.touch) return over < 0 ? region : RingSet{};
    return (dot(plane.normal, frame.normal) > 0) == (side == PovSide::kBelow) ? region : RingSet{};
  }
  const double reach = 2 * kSheetSteps * sheet.step, away = -over / tilt;
  if (std::abs(away) > reach) return away > 0 ? region : RingSet{};
  const Vec3 out = (a * frame.tangent + b * frame.bitangent) / tilt;
  const Vec3 along = cross(frame.normal, out), foot = sheet.origin + away * out;
  // Counter-clockwise, with the inside on the left: along the line, then round behind it.
  const Ring half{sheet.grid(foot - reach * along), sheet.grid(foot + reach * along),
                  sheet.grid(foot + reach * along - 2 * reach * out),
                  sheet.grid(foot - reach * along - 2 * reach * out)};
  return combined(RingOperation::kBoth, region, {half});
}

bool reaches(const PovHull& hull, const Box& box) {
  bool found = false;
  hull.tree->visit([&box](const Box& other) { return !apart(box, other); },
                   [&](uint32_t triangle) {
                     Box own;
                     for (const uint32_t corner : hull.triangles[triangle]) own.add(hull.points[corner]);
                     return found = !apart(box, own);
                   });
  return found;
}

// How often the hull winds around a point: the triangles that a ray along x crosses on its way out, less
// those on its way in. A ray through an edge or a corner is as one that begins a little beside the point, by
// much less in z than in y (simulation of simplicity, Edelsbrunner & Muecke 1990): it crosses one of the
// triangles that meet there, or as many out as in.
int winding(const PovHull& hull, Vec3 p) {
  int count = 0;
  const auto side_of = [&](uint32_t from, uint32_t to) {  // of the point, seen along x
    const bool turned = from > to;
    const Vec3 a = hull.points[turned ? to : from] - p, b = hull.points[turned ? from : to] - p;
    const double area = a.y * b.z - a.z * b.y;
    const double tie = a.z != b.z ? a.z - b.z : b.y - a.y;
    return ((area != 0 ? area : tie) > 0) != turned;
  };
  const auto ahead = [p](const Box& box) {
    return box.upper.x >= p.x && box.lower.y <= p.y && p.y <= box.upper.y && box.lower.z <= p.z &&
           p.z <= box.upper.z;
  };
  hull.tree->visit(ahead, [&](uint32_t triangle) {
    const auto [i, j, k] = hull.triangles[triangle];
    const bool side = side_of(i, j);
    if (side_of(j, k) != side || side_of(k, i) != side) return false;
    const Vec3 a = hull.points[i];
    const Vec3 normal = cross(hull.points[j] - a, hull.points[k] - a);
    // The way along x to its plane; a triangle along x counts as it lies.
    const bool before = normal.x != 0 ? dot(a - p, normal) / normal.x > 0 : a.x > p.x;
    if (before) count += side ? 1 : -1;
    return false;
  });
  return count;
}

}  // namespace

PovSolid solid_of_facets(const PovObject& object) {
  auto hull = std::make_shared<PovHull>();
  hull->points = object.points;
  for (const Vec3 p : hull->points) hull->box.add(p);
  // Fans, also of outlines that are not convex: parts that are covered twice, there and back, do not count.
  for (const PovFacet& facet : object.facets)
    for (size_t k = 2; k < facet.corners.size(); ++k)
      hull->triangles.push_back({facet.corners[0], facet.corners[k - 1], facet.corners[k]});
  PovSolid solid;
  solid.kind = PovSolid::kHull;
  solid.hull = std::move(hull);
  return solid;
}

PovSolid solid_behind(const PovPlane& plane) {
  PovSolid solid;
  solid.kind = PovSolid::kBehindPlane;
  solid.plane = plane;
  return solid;
}

PovSolid solid_of(PovSolid::Kind kind, std::vector<PovSolid> parts) {
  PovSolid solid;
  solid.kind = kind;
  solid.parts = std::move(parts);
  return solid;
}

PovPlane moved_plane(const PovPlane& plane, const PovTransform& by) {
  const Frame frame = frame_about(plane.normal);
  const Vec3 across = cross(by.direction(frame.tangent), by.direction(frame.bitangent));
  const Vec3 normal = (by.mirrors() ? -1 : 1) * normalized(across);
  return {normal, dot(normal, by.point(plane.distance * plane.normal))};
}

void move_solid(PovSolid* solid, const PovTransform& by) {
  for (PovSolid& part : solid->parts) move_solid(&part, by);
  if (solid->kind == PovSolid::kBehindPlane) solid->plane = moved_plane(solid->plane, by);
  if (solid->kind == PovSolid::kHull) solid->placed.append(by);
}

PovSolid settled(const PovSolid& solid) {
  PovSolid made = solid;
  for (PovSolid& part : made.parts) part = settled(part);
  if (solid.kind != PovSolid::kHull) return made;
  auto hull = std::make_shared<PovHull>(*solid.hull);
  hull->box = {};
  for (Vec3& p : hull->points) p = solid.placed.point(p), hull->box.add(p);
  if (solid.placed.mirrors())
    for (auto& corners : hull->triangles) std::swap(corners[1], corners[2]);
  std::vector<Box> boxes;
  for (const auto& corners : hull->triangles) {
    Box& box = boxes.emplace_back();
    for (const uint32_t corner : corners) box.add(hull->points[corner]);
  }
  hull->tree = std::make_shared<const BoxTree>(boxes);
  made.hull = std::move(hull);
  made.placed = {};
  return made;
}

Box box_of_hulls(const PovSolid& solid) {
  Box box;
  if (solid.hull) box = solid.hull->box;
  for (const PovSolid& part : solid.parts) box.add(box_of_hulls(part));
  return box;
}

bool is_inside(const PovSolid& solid, Vec3 p) {
  const auto in = [p](const PovSolid& part) { return is_inside(part, p); };
  bool inside = false;
  switch (solid.kind) {
    case PovSolid::kNothing:
      break;
    case PovSolid::kHull:
      inside = winding(*solid.hull, p) > 0;
      break;
    case PovSolid::kBehindPlane:
      inside = dot(p, solid.plane.normal) < solid.plane.distance;
      break;
    case PovSolid::kUnion:
      inside = std::any_of(solid.parts.begin(), solid.parts.end(), in);
      break;
    case PovSolid::kIntersection:
      inside = std::all_of(solid.parts.begin(), solid.parts.end(), in);
      break;
  }
  return inside != solid.inverse;
}

RingPoint PovSheet::grid(Vec3 p) const {
  const Vec3 from = p - origin;
  return {std::llround(dot(from, frame.tangent) / step), std::llround(dot(from, frame.bitangent) / step)};
}

Vec3 PovSheet::point(RingPoint at) const {
  return origin +
         step * (static_cast<double>(at[0]) * frame.tangent + static_cast<double>(at[1]) * frame.bitangent);
}

RingSet part_inside(const RingSet& region, const PovSolid& solid, const PovSheet& sheet, PovSide side,
                    const Box& around) {
  if (region.empty()) return region;
  RingSet inside;
  switch (solid.kind) {
    case PovSolid::kNothing:
      break;
    case PovSolid::kHull: {
      if (apart(solid.hull->box, around)) break;
      if (!reaches(*solid.hull, around)) {  // all inside, or nothing
        if (winding(*solid.hull, around.centre()) > 0) inside = region;
        break;
      }
      const RingSet rings = section(*solid.hull, sheet, side);
      if (!rings.empty()) inside = combined(RingOperation::kBoth, region, rings);
      break;
    }
    case PovSolid::kBehindPlane:
      inside = part_behind(region, solid.plane, sheet, side);
      break;
    case PovSolid::kUnion:
      for (const PovSolid& part : solid.parts) {
        const RingSet of_part = part_inside(region, part, sheet, side, around);
        if (inside.empty())
          inside = of_part;
        else if (!of_part.empty())
          inside = combined(RingOperation::kEither, inside, of_part);
      }
      break;
    case PovSolid::kIntersection:
      inside = region;
      for (const PovSolid& part : solid.parts) inside = part_inside(inside, part, sheet, side, around);
      break;
  }
  if (!solid.inverse) return inside;
  return inside.empty() ? region : combined(RingOperation::kFirstAlone, region, inside);
}

}  // namespace strad
