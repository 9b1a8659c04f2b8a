// Reads POV-Ray's simple objects and transformations.
#include <cmath>

#include "base/error.h"
#include "base/pose.h"
#include "base/text.h"
#include "import/pov/scene_reader.h"
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

bool is_flat(const PovTransform& transform) {
  const auto& r = transform.rows;
  return !(std::abs(dot(cross(r[0], r[1]), r[2])) > 0);
}

}  // namespace

bool PovSceneReader::transformation(PovTransform* transform) {
  const PovPlace at = in_.place();
  PovTransform next;
  if (in_.take_if("translate")) {
    next.rows[3] = in_.vector();
  } else if (in_.take_if("rotate")) {
    const Vec3 degrees = in_.vector();
    next = turn_about({1, 0, 0}, degrees.x);
    next.append(turn_about({0, 1, 0}, degrees.y));
    next.append(turn_about({0, 0, 1}, degrees.z));
  } else if (in_.take_if("scale")) {
    next = scaling(in_.vector());
  } else if (in_.take_if("matrix")) {
    next = matrix();
  } else if (in_.take_if("transform")) {
    next = transform_block();
  } else if (const auto known = in_.named<PovTransform>()) {
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
  in_.expect("<");
  for (Vec3& row : transform.rows) {
    for (int i = 0; i < 3; ++i) {
      row[i] = in_.number();
      in_.skip_comma();
    }
  }
  in_.expect(">");
  return transform;
}

// The rest of a `transform`: a name, or names and transformations in braces.
PovTransform PovSceneReader::transform_block() {
  const PovInterpreter::Deeper deeper(&in_);
  PovTransform transform;
  if (const auto known = in_.named<PovTransform>()) return *known;
  in_.expect("{");
  while (!in_.take_if("}")) {
    if (in_.take_if("inverse")) {
      transform = inverse_of(transform);
    } else if (!transformation(&transform)) {
      in_.fail_expected("a transformation or }");
    }
  }
  return transform;
}

PovObject PovSceneReader::sphere_shape() {
  const Vec3 centre = in_.vector();
  in_.skip_comma();
  return pov_sphere(centre, in_.number(), options_.tessellate);
}

PovObject PovSceneReader::cone_shape(bool is_cylinder) {
  const PovPlace at = in_.place();
  const Vec3 base = in_.vector();
  in_.skip_comma();
  double base_radius = is_cylinder ? 0 : in_.number();
  in_.skip_comma();
  const Vec3 cap = in_.vector();
  in_.skip_comma();
  const double cap_radius = in_.number();
  if (is_cylinder) base_radius = cap_radius;
  if (!(length(cap - base) > 0)) fail_at(at.file, at.line, "the two ends of a cylinder or cone are one");
  return pov_cone(base, base_radius, cap, cap_radius, options_.tessellate, in_.take_if("open"));
}

PovObject PovSceneReader::disc_shape() {
  const PovPlace at = in_.place();
  const Vec3 centre = in_.vector();
  in_.skip_comma();
  const Vec3 normal = in_.vector();
  in_.skip_comma();
  const double radius = in_.number();
  const double hole = in_.take_if(",") || in_.expression_is_next() ? in_.number() : 0;
  if (!(length(normal) > 0)) fail_at(at.file, at.line, "the normal of a disc has no length");
  return pov_disc(centre, normal, radius, hole, options_.tessellate);
}

PovObject PovSceneReader::plane_shape() {
  const PovPlace at = in_.place();
  const Vec3 normal = in_.vector();
  in_.skip_comma();
  const double distance = in_.number();
  if (!(length(normal) > 0)) fail_at(at.file, at.line, "the normal of a plane has no length");
  return pov_plane({normalized(normal), distance});
}

}  // namespace strad
