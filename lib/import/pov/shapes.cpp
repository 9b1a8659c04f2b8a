// POV-Ray's round objects, boxes and planes as flat facets.
#include "import/pov/shapes.h"

#include <algorithm>
#include <cmath>

#include "import/pov/solids.h"

namespace strad {
namespace {

void add_facet(PovObject* object, std::vector<uint32_t> corners) {
  PovFacet facet;
  facet.corners = std::move(corners);
  object->facets.push_back(std::move(facet));
}

// Adds the corners of a regular polygon, counter-clockwise seen against the frame's normal. Returns the index
// of the first.
uint32_t add_ring(PovObject* object, Vec3 centre, const Frame& frame, double radius, int sides) {
  const auto first = static_cast<uint32_t>(object->points.size());
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    object->points.push_back(centre +
                             radius * (std::cos(angle) * frame.tangent + std::sin(angle) * frame.bitangent));
  }
  return first;
}

// Adds the facets between two rings: quads, or triangles if one ring is a single point. They face outwards if
// `upper` lies along the normal.
void add_band(PovObject* object, uint32_t lower, bool lower_point, uint32_t upper, bool upper_point,
              int sides) {
  for (int i = 0; i < sides; ++i) {
    const uint32_t a = static_cast<uint32_t>(i), b = static_cast<uint32_t>((i + 1) % sides);
    if (lower_point) {
      add_facet(object, {lower, upper + b, upper + a});
    } else if (upper_point) {
      add_facet(object, {lower + a, lower + b, upper});
    } else {
      add_facet(object, {lower + a, lower + b, upper + b, upper + a});
    }
  }
}

void add_lid(PovObject* object, uint32_t ring, int sides, bool upwards) {
  std::vector<uint32_t> corners;
  for (int i = 0; i < sides; ++i)
    corners.push_back(ring + static_cast<uint32_t>(upwards ? i : sides - 1 - i));
  add_facet(object, std::move(corners));
}

PovObject with_inside(PovObject object) {
  object.solid = solid_of_facets(object);
  return object;
}

}  // namespace

PovObject pov_box(Vec3 corner, Vec3 opposite) {
  Box box;
  box.add(corner);
  box.add(opposite);
  PovObject object;
  for (uint32_t i = 0; i < 8; ++i) {
    object.points.push_back({i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                             i & 4 ? box.upper.z : box.lower.z});
  }
  for (const auto& corners : {std::vector<uint32_t>{0, 4, 6, 2},
                              {1, 3, 7, 5},
                              {0, 1, 5, 4},
                              {2, 6, 7, 3},
                              {0, 2, 3, 1},
                              {4, 5, 7, 6}})
    add_facet(&object, corners);
  return with_inside(std::move(object));
}

PovObject pov_sphere(Vec3 centre, double radius, int sides) {
  PovObject object;
  const int bands = std::max(2, sides / 2);
  const Frame frame{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
  radius = std::abs(radius);
  object.points = {centre - radius * frame.normal};
  uint32_t last = 0;
  for (int band = 1; band <= bands; ++band) {
    const double angle = kPi * band / bands - kPi / 2;
    const Vec3 middle = centre + radius * std::sin(angle) * frame.normal;
    const bool top = band == bands;
    const uint32_t ring = top ? static_cast<uint32_t>(object.points.size())
                              : add_ring(&object, middle, frame, radius * std::cos(angle), sides);
    if (top) object.points.push_back(centre + radius * frame.normal);
    add_band(&object, last, band == 1, ring, top, sides);
    last = ring;
  }
  for (PovFacet& facet : object.facets)
    for (const uint32_t corner : facet.corners) facet.normals.push_back(object.points[corner] - centre);
  return with_inside(std::move(object));
}

namespace {

// Normals of the sides of a cone: across its slope. At its tip that of the middle of each side.
void smooth_sides(PovObject* object, Vec3 base, Vec3 cap, double narrowing) {
  const Vec3 axis = normalized(cap - base);
  const auto outwards = [&](uint32_t corner) {
    const Vec3 from_base = object->points[corner] - base;
    return from_base - dot(from_base, axis) * axis;
  };
  for (PovFacet& facet : object->facets) {
    Vec3 middle;
    for (const uint32_t corner : facet.corners) middle = middle + outwards(corner);
    for (const uint32_t corner : facet.corners) {
      const Vec3 out = outwards(corner);
      const bool tip = !(length(out) > 1e-9 * length(middle));
      facet.normals.push_back(length(cap - base) * normalized(tip ? middle : out) + narrowing * axis);
    }
  }
}

}  // namespace

PovObject pov_cone(Vec3 base, double base_radius, Vec3 cap, double cap_radius, int sides, bool open) {
  PovObject object;
  const Frame frame = frame_about(normalized(cap - base));
  base_radius = std::abs(base_radius);
  cap_radius = std::abs(cap_radius);
  const auto ring = [&](Vec3 centre, double radius) {
    if (radius > 0) return add_ring(&object, centre, frame, radius, sides);
    object.points.push_back(centre);
    return static_cast<uint32_t>(object.points.size() - 1);
  };
  const uint32_t lower = ring(base, base_radius), upper = ring(cap, cap_radius);
  if (base_radius > 0 || cap_radius > 0) {
    add_band(&object, lower, !(base_radius > 0), upper, !(cap_radius > 0), sides);
    smooth_sides(&object, base, cap, base_radius - cap_radius);
  }
  const size_t walls = object.facets.size();
  if (base_radius > 0) add_lid(&object, lower, sides, false);
  if (cap_radius > 0) add_lid(&object, upper, sides, true);
  object = with_inside(std::move(object));  // of an open one, too
  if (open) object.facets.resize(walls);
  return object;
}

PovObject pov_disc(Vec3 centre, Vec3 normal, double radius, double hole_radius, int sides) {
  PovObject object;
  const Frame frame = frame_about(normalized(normal));
  const uint32_t rim = add_ring(&object, centre, frame, std::abs(radius), sides);
  if (!(hole_radius > 0)) {
    add_lid(&object, rim, sides, true);
  } else {
    const uint32_t hole = add_ring(&object, centre, frame, hole_radius, sides);
    add_band(&object, rim, false, hole, false, sides);
  }
  return object;
}

PovObject pov_plane(const PovPlane& plane) {
  PovObject object;
  const Frame frame = frame_about(plane.normal);
  const Vec3 foot = plane.distance * plane.normal;
  for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    object.points.push_back(foot + kEndless * (u * frame.tangent + v * frame.bitangent));
  add_lid(&object, 0, 4, true);
  object.solid = solid_behind(plane);
  object.endless = true;
  return object;
}

PovTransform inverse_of(const PovTransform& of) {
  const auto& r = of.rows;
  const double determinant = dot(cross(r[0], r[1]), r[2]);
  const Vec3 x = cross(r[1], r[2]) / determinant, y = cross(r[2], r[0]) / determinant,
             z = cross(r[0], r[1]) / determinant;
  PovTransform result;
  result.rows[0] = {x.x, y.x, z.x};
  result.rows[1] = {x.y, y.y, z.y};
  result.rows[2] = {x.z, y.z, z.z};
  result.rows[3] = -result.direction(r[3]);
  return result;
}

void move_object(PovObject* object, const PovTransform& by) {
  if (object->endless && object->solid.kind == PovSolid::kBehindPlane && object->points.size() == 4) {
    // A plane is a square of the same size, however it is scaled.
    const PovPlane plane = moved_plane(object->solid.plane, by);
    object->points = pov_plane(plane).points;
    object->solid.plane = plane;
    return;
  }
  move_solid(&object->solid, by);
  if (object->pending) object->pending->placed.append(by);
  for (Vec3& point : object->points) point = by.point(point);
  for (PovFacet& facet : object->facets)
    for (Vec3& normal : facet.normals) normal = by.normal(normal);
  for (PovLight& light : object->lights) {
    light.location = by.point(light.location);
    light.point_at = by.point(light.point_at);
    light.axis1 = by.direction(light.axis1);
    light.axis2 = by.direction(light.axis2);
  }
  if (!by.mirrors()) return;
  for (PovFacet& facet : object->facets) {
    std::reverse(facet.corners.begin(), facet.corners.end());
    std::reverse(facet.uvs.begin(), facet.uvs.end());
    std::reverse(facet.normals.begin(), facet.normals.end());
  }
}

}  // namespace strad
