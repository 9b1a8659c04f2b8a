// POV-Ray's simple objects and transformations, read.
#include <cmath>

#include "base/error.h"
#include "base/pose.h"
#include "base/text.h"
#include "import/pov/scene.h"
#include "import/pov/shapes.h"

namespace strad {
namespace {

PovTransform turn_about(Vec3 axis, double degrees) {
  const Quat turn = rotation_about(axis, degrees * kPi / 180);
  PovTransform transform;
  for (Vec3& row : transform.rows) row = rotate(turn, row);
  return transform;
}

PovTransform scaling(Vec3 factors) {
  PovTransform transform;
  transform.rows[0] = {factors.x, 0, 0};
  transform.rows[1] = {0, factors.y, 0};
  transform.rows[2] = {0, 0, factors.z};
  return transform;
}

// REQUIRES: it has an inverse.
PovTransform inverse(const PovTransform& of) {
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

bool is_flat(const PovTransform& transform) {
  const auto& r = transform.rows;
  return !(std::abs(dot(cross(r[0], r[1]), r[2])) > 0);
}

}  // namespace

bool PovSceneReader::transformation(PovTransform* transform) {
  const PovPlace at = place();
  PovTransform next;
  if (take_if("translate")) {
    next.rows[3] = vector();
  } else if (take_if("rotate")) {
    const Vec3 degrees = vector();
    next = turn_about({1, 0, 0}, degrees.x);
    next.append(turn_about({0, 1, 0}, degrees.y));
    next.append(turn_about({0, 0, 1}, degrees.z));
  } else if (take_if("scale")) {
    next = scaling(vector());
  } else if (take_if("matrix")) {
    next = matrix();
  } else if (take_if("transform")) {
    next = transform_block();
  } else if (const auto known = named<PovTransform>()) {
    next = *known;
  } else {
    return false;
  }
  if (is_flat(next)) fail_at(at.file, at.line, "the transformation makes things flat");
  transform->append(next);
  return true;
}

// matrix <12 numbers>
PovTransform PovSceneReader::matrix() {
  PovTransform transform;
  expect("<");
  for (Vec3& row : transform.rows) {
    for (int i = 0; i < 3; ++i) {
      row[i] = number();
      skip_comma();
    }
  }
  expect(">");
  return transform;
}

// What follows `transform`: a name, or names and transformations in braces.
PovTransform PovSceneReader::transform_block() {
  const Deeper deeper(this);
  PovTransform transform;
  if (const auto known = named<PovTransform>()) return *known;
  expect("{");
  while (!take_if("}")) {
    if (take_if("inverse")) {
      transform = inverse(transform);
    } else if (!transformation(&transform)) {
      fail_expected("a transformation or }");
    }
  }
  return transform;
}

PovObject PovSceneReader::sphere_shape() {
  const Vec3 centre = vector();
  skip_comma();
  return pov_sphere(centre, number(), options_.tessellate);
}

PovObject PovSceneReader::cone_shape(bool is_cylinder) {
  const PovPlace at = place();
  const Vec3 base = vector();
  skip_comma();
  double base_radius = is_cylinder ? 0 : number();
  skip_comma();
  const Vec3 cap = vector();
  skip_comma();
  const double cap_radius = number();
  if (is_cylinder) base_radius = cap_radius;
  if (!(length(cap - base) > 0)) fail_at(at.file, at.line, "the two ends of a cylinder or cone are one");
  return pov_cone(base, base_radius, cap, cap_radius, options_.tessellate, take_if("open"));
}

PovObject PovSceneReader::disc_shape() {
  const PovPlace at = place();
  const Vec3 centre = vector();
  skip_comma();
  const Vec3 normal = vector();
  skip_comma();
  const double radius = number();
  const double hole = take_if(",") || expression_is_next() ? number() : 0;
  if (!(length(normal) > 0)) fail_at(at.file, at.line, "the normal of a disc has no length");
  return pov_disc(centre, normal, radius, hole, options_.tessellate);
}

PovObject PovSceneReader::plane_shape() {
  const PovPlace at = place();
  const Vec3 normal = vector();
  skip_comma();
  const double distance = number();
  if (!(length(normal) > 0)) fail_at(at.file, at.line, "the normal of a plane has no length");
  PovObject made;
  made.plane = PovPlane{normalized(normal), distance};
  return made;
}

}  // namespace strad
