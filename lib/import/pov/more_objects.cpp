// Reads POV-Ray's objects that are turned, drawn or cut: torus, lathe, sor, prism, superellipsoid, text, and
// constructive solid geometry.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/csg.h"
#include "import/pov/implicit.h"
#include "import/pov/scene_reader.h"
#include "import/pov/shapes.h"
#include "import/pov/solids.h"
#include "import/pov/text_outline.h"
#include "import/pov/turned.h"

namespace strad {
namespace {

bool is_curve(std::string_view word) {
  return is_one_of(word, {"linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline"});
}

// The controls of a prism as rings. Each ends where it comes back to its first point on the curve; controls
// that only give slopes come before that, and in a cubic spline after it.
std::vector<std::vector<Vec2>> rings_of_controls(const std::string& kind, const std::vector<Vec2>& controls) {
  std::vector<std::vector<Vec2>> rings;
  const size_t lead = kind == "quadratic_spline" || kind == "cubic_spline" ? 1 : 0;
  const size_t tail = kind == "cubic_spline" ? 1 : 0;
  const auto same = [](Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y) < 1e-9; };
  for (size_t first = 0; first + lead < controls.size();) {
    size_t end = first + lead + 1;
    if (kind == "bezier_spline") {
      while (end + 3 < controls.size() && (end - first) % 4 != 0) ++end;
      end = first + 3;
      while (end < controls.size() && !same(controls[end], controls[first])) end += 4;
    } else {
      while (end < controls.size() && !same(controls[end], controls[first + lead])) ++end;
    }
    end = std::min(end + tail, controls.size() - 1);
    rings.emplace_back(controls.begin() + static_cast<std::ptrdiff_t>(first),
                       controls.begin() + static_cast<std::ptrdiff_t>(end) + 1);
    first = end + 1;
  }
  return rings;
}

// The box of what objects have in common of which none is finite by itself, such as planes that cut off a
// quadric.
std::optional<Box> common_box(const std::vector<PovObject>& objects) {
  std::vector<PovField> fields;
  for (const PovObject& object : objects) {
    const double sign = object.solid.inverse ? -1 : 1;
    if (object.pending) {
      fields.push_back([sign, field = object.pending->field, back = inverse_of(object.pending->placed)](
                           Vec3 p) { return sign * field(back.point(p)); });
    } else if (object.solid.kind != PovSolid::kNothing) {
      fields.push_back([solid = settled(object.solid)](Vec3 p) { return is_inside(solid, p) ? -1.0 : 1.0; });
    }
  }
  const PovField all = [&fields](Vec3 p) {
    double most = -std::numeric_limits<double>::infinity();
    for (const PovField& field : fields) most = std::max(most, field(p));
    return most;
  };
  for (const double reach : {4.0, 40.0, 400.0})
    if (const auto box = box_of_field(all, reach)) return box;
  return {};
}

}  // namespace

PovObject PovSceneReader::torus_shape() {
  const double major = in_.number();
  in_.skip_comma();
  return pov_torus(std::abs(major), std::abs(in_.number()), options_.tessellate);
}

// A curve's word, if one is next, and its controls: their number, then points.
std::vector<Vec2> PovSceneReader::controls() {
  const int count = in_.integer();
  in_.skip_comma();
  std::vector<Vec2> found;
  for (int i = 0; i < count; ++i) {
    found.push_back(in_.vector2());
    in_.skip_comma();
  }
  return found;
}

PovObject PovSceneReader::lathe_shape() {
  const PovPlace at = in_.place();
  std::string kind = "linear_spline";
  if (in_.peek().kind == PovKind::kWord && is_curve(in_.peek().text)) kind = in_.take().text;
  in_.skip_comma();
  const std::vector<Vec2> profile = pov_curve(kind, controls(), std::max(2, options_.tessellate / 4));
  if (profile.size() < 2) fail_at(at.file, at.line, "a lathe has too few points");
  return pov_turned(profile, options_.tessellate);
}

PovObject PovSceneReader::sor_shape() {
  const PovPlace at = in_.place();
  const std::vector<Vec2> points = controls();
  if (points.size() < 4) fail_at(at.file, at.line, "a sor has fewer than 4 points");
  for (size_t i = 1; i + 1 < points.size(); ++i)  // the last point only gives a slope
    if (points[i + 1].y == points[i - 1].y || (i + 2 < points.size() && points[i + 1].y == points[i].y)) {
      PovObject none;
      in_.take_if("open");
      none.problems.push_back({"sor with two points at one height", at});
      return none;
    }
  return pov_sor(points, options_.tessellate, in_.take_if("open"));
}

PovObject PovSceneReader::prism_shape() {
  const PovPlace at = in_.place();
  std::string kind = "linear_spline";
  bool conic = false;
  while (in_.peek().kind == PovKind::kWord && !in_.expression_is_next()) {
    const std::string word(in_.take().text);
    if (is_curve(word))
      kind = word;
    else if (word == "conic_sweep")
      conic = true;
    else if (word != "linear_sweep")
      fail_at(at.file, at.line, "found " + in_quotes(word) + ", expected the heights of a prism");
  }
  double low = in_.number();
  in_.skip_comma();
  double high = in_.number();
  in_.skip_comma();
  if (low > high) std::swap(low, high);
  std::vector<std::vector<Vec3>> from, to;
  for (const std::vector<Vec2>& ring : rings_of_controls(kind, controls())) {
    std::vector<Vec2> curve = pov_curve(kind, ring, std::max(2, options_.tessellate / 4));
    while (curve.size() > 1 &&
           std::hypot(curve.back().x - curve.front().x, curve.back().y - curve.front().y) < 1e-9)
      curve.pop_back();
    if (curve.size() < 3) continue;
    // A cone's point, where all would be one, is left a little open.
    const auto widened = [](double y) { return std::abs(y) < 1e-6 ? 1e-6 : y; };
    const double at_low = conic ? widened(low) : 1, at_high = conic ? widened(high) : 1;
    from.emplace_back(), to.emplace_back();
    for (const Vec2 p : curve) {
      from.back().push_back({at_low * p.x, low, at_low * p.y});
      to.back().push_back({at_high * p.x, high, at_high * p.y});
    }
  }
  if (from.empty() || !(high > low)) fail_at(at.file, at.line, "a prism has no closed outline or no height");
  return pov_drawn(from, to, in_.take_if("open"));
}

PovObject PovSceneReader::superellipsoid_shape() {
  const PovPlace at = in_.place();
  const Vec2 exponents = in_.vector2();
  if (!(exponents.x > 0 && exponents.y > 0))
    fail_at(at.file, at.line, "an exponent of a superellipsoid is not above 0");
  // Below this the corners of a cube are rounded less than by the numbers of a file.
  constexpr double kLeast = 0.01;
  return pov_superellipsoid(std::max(kLeast, exponents.x), std::max(kLeast, exponents.y),
                            options_.tessellate);
}

// text { ttf "font" "text" thickness, offset }
PovObject PovSceneReader::text_shape() {
  const PovPlace at = in_.place();
  std::string font;
  if (in_.take_if("internal")) {
    const std::array<const char*, 4> own{"timrom.ttf", "cyrvetic.ttf", "crystal.ttf", "povlogo.ttf"};
    font = own[static_cast<size_t>(std::clamp(in_.integer(), 1, 4) - 1)];
  } else {
    if (!in_.take_if("ttf")) in_.fail_expected("ttf");
    font = in_.string();
    if (font.find('.') == font.npos) font += ".ttf";
  }
  in_.skip_comma();
  const std::string text = in_.string();
  in_.skip_comma();
  const double thickness = in_.number();
  in_.skip_comma();
  const Vec2 advance = in_.expression_is_next() ? in_.vector2() : Vec2{};
  PovObject made;
  made.compound = true;
  const std::string path = in_.found_include(font);
  if (path.empty()) {
    made.problems.push_back({"text in the font " + in_quotes(font) + ", which is missing,", at});
    return made;
  }
  // A hundredth of an em with the 16 sides of a round object; chords are off by the square of their length.
  const double tolerance = 0.01 * 256 / (options_.tessellate * options_.tessellate);
  std::vector<PovSolid> solids;
  for (const auto& glyph : text_outlines(path, text, advance, tolerance)) {
    std::vector<std::vector<Vec3>> from, to;
    for (const auto& ring : glyph) {
      from.emplace_back(), to.emplace_back();
      for (const Vec2 p : ring)
        from.back().push_back({p.x, p.y, 0}), to.back().push_back({p.x, p.y, thickness});
    }
    const PovObject letter = pov_drawn(from, to, false);
    const auto first = static_cast<uint32_t>(made.points.size());
    made.points.insert(made.points.end(), letter.points.begin(), letter.points.end());
    for (PovFacet facet : letter.facets) {
      for (uint32_t& corner : facet.corners) corner += first;
      made.facets.push_back(std::move(facet));
    }
    solids.push_back(letter.solid);
  }
  made.solid = solid_of(PovSolid::kUnion, std::move(solids));
  made.compound = false;
  return made;
}

// The objects that are next.
std::vector<PovObject> PovSceneReader::children(PovObject* carrier) {
  std::vector<PovObject> found;
  while (in_.peek().kind == PovKind::kWord) {
    if (in_.take_if("light_source"))
      carrier->lights.push_back(light_block());
    else if (object_is_next())
      found.push_back(object());
    else
      break;
  }
  return found;
}

PovObject PovSceneReader::intersection_shape(bool difference) {
  const PovPlace at = in_.place();
  PovObject carrier;
  std::vector<PovObject> objects = children(&carrier);
  if (difference)
    for (size_t i = 1; i < objects.size(); ++i) objects[i] = pov_inverse(std::move(objects[i]));
  Box wanted;  // what all finite ones that are not taken away have in common
  bool first = true;
  for (size_t i = 0; i < objects.size(); ++i) {
    const Box box = box_of_hulls(settled(objects[i].solid));
    if (box.empty() || (difference && i > 0)) continue;
    for (int axis = 0; axis < 3 && !first; ++axis) {
      wanted.lower[axis] = std::max(wanted.lower[axis], box.lower[axis]);
      wanted.upper[axis] = std::min(wanted.upper[axis], box.upper[axis]);
    }
    if (first) wanted = box;
    first = false;
  }
  const bool any_pending = std::any_of(objects.begin(), objects.end(),
                                       [](const PovObject& object) { return object.pending.has_value(); });
  if (wanted.empty() && any_pending) wanted = common_box(objects).value_or(Box{});
  for (PovObject& object : objects) {
    if (!object.pending) continue;
    const Vec3 margin = 0.05 * (wanted.upper - wanted.lower);
    Box wider = wanted;
    if (!wanted.empty()) wider.add(wanted.lower - margin), wider.add(wanted.upper + margin);
    const bool inverse = object.solid.inverse;
    pov_make_pending(&object, wider.empty() ? std::optional<Box>{} : wider, cells());
    if (inverse) object = pov_inverse(std::move(object));
  }
  // What cannot be made is left out, not cut away: its surface is missing, and so is its inside.
  PovObject made = pov_intersection(std::move(objects), cuts_);
  made.lights.insert(made.lights.end(), carrier.lights.begin(), carrier.lights.end());
  if (made.facets.empty() && made.problems.empty())
    made.notes.push_back(
        {std::string(difference ? "difference" : "intersection") + " of which nothing is left", at});
  return made;
}

}  // namespace strad
