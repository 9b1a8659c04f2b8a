// What POV-Ray files ask of objects, what is around them, and where endless ones are cut.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/polygonize.h"
#include "import/pov/csg.h"
#include "import/pov/scene_reader.h"
#include "import/pov/solids.h"

namespace strad {
namespace {

PovNumbers numbers_of(Vec3 v) {
  PovNumbers numbers;
  numbers.size = 3;
  numbers.parts = {v.x, v.y, v.z};
  return numbers;
}

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 normal;
};

// Where a ray first meets a facet, whose outline may be any.
void meet(const PovObject& object, const PovFacet& facet, Vec3 from, Vec3 direction, Hit* hit) {
  std::vector<Vec3> outline;
  for (const uint32_t corner : facet.corners) outline.push_back(object.points[corner]);
  const Vec3 normal = normalized(doubled_area(outline));
  const double slope = dot(normal, direction);
  if (slope == 0) return;
  const double distance = dot(normal, outline[0] - from) / slope;
  if (!(distance > 1e-9 && distance < hit->distance)) return;
  const Vec3 at = from + distance * direction;
  const Frame frame = frame_about(normal);
  bool inside = false;
  for (size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vec3 p = outline[i] - at, q = outline[j] - at;
    const double px = dot(p, frame.tangent), py = dot(p, frame.bitangent), qx = dot(q, frame.tangent),
                 qy = dot(q, frame.bitangent);
    if ((py > 0) != (qy > 0) && px + (qx - px) * py / (py - qy) > 0) inside = !inside;
  }
  if (inside) *hit = {distance, normal};
}

Hit first_hit(const PovObject& object, const BoxTree& facets, Vec3 from, Vec3 direction) {
  Hit hit;
  const auto reaches = [&](const Box& box) {
    double near = 0, far = hit.distance;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.lower[axis] - from[axis]) / direction[axis],
                   b = (box.upper[axis] - from[axis]) / direction[axis];
      if (direction[axis] == 0) {
        if (from[axis] < box.lower[axis] || from[axis] > box.upper[axis]) return false;
        continue;
      }
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    return near <= far * (1 + 1e-9) + 1e-12;
  };
  facets.visit(reaches, [&](uint32_t facet) {
    meet(object, object.facets[facet], from, direction, &hit);
    return false;
  });
  return hit;
}

}  // namespace

// Files ask for many rays and points of one object.
void PovSceneReader::prepare_rays(const std::shared_ptr<const PovObject>& object) {
  if (asked_.object == object) return;
  std::vector<Box> boxes;
  for (const PovFacet& facet : object->facets) {
    Box& box = boxes.emplace_back();
    for (const uint32_t corner : facet.corners) box.add(object->points[corner]);
  }
  asked_ = {object, settled(object->solid), std::make_shared<const BoxTree>(boxes)};
}

// min_extent(object), max_extent(object), inside(object, point), trace(object, from, direction [, normal]).
PovNumbers PovSceneReader::measured(const std::string& name) {
  in_.expect("(");
  std::shared_ptr<const PovObject> asked;
  if (const auto known = in_.named<std::shared_ptr<const PovObject>>()) {
    asked = *known;
  } else {
    if (!object_is_next()) in_.fail_expected("an object");
    asked = std::make_shared<const PovObject>(object());
  }
  if (name == "inside" || name == "trace") prepare_rays(asked);
  const PovObject& object = *asked;
  PovNumbers result;
  if (name == "min_extent" || name == "max_extent") {
    Box box;
    for (const PovFacet& facet : object.facets)
      for (const uint32_t corner : facet.corners) box.add(object.points[corner]);
    if (box.empty()) box.add(Vec3{});
    result = numbers_of(name == "min_extent" ? box.lower : box.upper);
  } else {
    in_.expect(",");
    const Vec3 point = in_.vector();
    if (name == "inside") {
      result = number_of(is_inside(asked_.solid, point));
    } else {
      in_.expect(",");
      const Vec3 direction = normalized(in_.vector());
      const Hit hit = first_hit(object, *asked_.facets, point, direction);
      const bool met = std::isfinite(hit.distance);
      if (in_.take_if(",")) {
        const std::string normal(in_.take().text);
        in_.set(normal, numbers_of(!met                             ? Vec3{}
                                   : dot(hit.normal, direction) > 0 ? -hit.normal
                                                                    : hit.normal));
      }
      result = numbers_of(met ? point + hit.distance * direction : Vec3{});
    }
  }
  in_.expect(")");
  return result;
}

std::optional<Vec3> PovSceneReader::transformed(const std::any& thing, Vec3 vector) {
  const auto* transform = std::any_cast<PovTransform>(&thing);
  if (!transform) return {};
  return transform->point(vector);
}

void PovSceneReader::global_settings() {
  in_.expect("{");
  for (int depth = 1; depth > 0;) {
    const PovToken token = in_.take();
    if (token.kind == PovKind::kEnd) in_.fail_expected("}");
    if (token.kind == PovKind::kWord && token.text == "radiosity") radiosity_ = true;
    if (token.kind == PovKind::kSymbol) depth += token.text == "{" ? 1 : token.text == "}" ? -1 : 0;
  }
}

// What is around the objects. False if `word` is none of it.
bool PovSceneReader::statement_of_air(const std::string& word, const PovPlace& at) {
  if (in_.take_if("global_settings")) {
    global_settings();
  } else if (in_.take_if("background")) {
    in_.expect("{");
    if (max_channel(plain_colour()) > 0) sky_.push_back({"background light", at});
    in_.expect("}");
  } else if (word == "sky_sphere") {
    sky_.push_back({word, at});
    in_.skip_item();
  } else if (word == "fog" || word == "rainbow") {
    report_->add(word + " is left out: it changes what is seen, not what is lit", at.file, at.line);
    in_.skip_item();
  } else if (word == "media" || word == "photons") {
    refuse({word, at}, options_, report_);
    in_.skip_item();
  } else {
    return false;
  }
  return true;
}

Rgb PovSceneReader::plain_colour() {
  const PovNumbers found = promoted(in_.numbers(), 3);
  return {static_cast<float>(found[0]), static_cast<float>(found[1]), static_cast<float>(found[2])};
}

// Without radiosity POV-Ray's sky is seen but lights nothing.
void PovSceneReader::judge_sky() {
  for (PovProblem& sky : sky_) {
    if (radiosity_) {
      sky.what += " with radiosity, which lights the scene,";
      refuse(sky, options_, report_);
    } else {
      report_->add(sky.what + " is left out: without radiosity it lights nothing", sky.place.file,
                   sky.place.line);
    }
  }
}

void PovSceneReader::cut_endless(std::optional<Extent>* extent) {
  constexpr double kReach = 10;
  if (std::none_of(placed_.begin(), placed_.end(), [](const Placed& p) { return p.object.endless; })) return;
  if (!*extent) {
    Box box;
    for (const Placed& placed : placed_)
      for (const Vec3 p : placed.object.points)
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < kEndless / 4) box.add(p);
    if (camera_) box.add(camera_->location);
    if (box.empty()) box.add(Vec3{});
    *extent = Extent{box.centre(), box.diagonal() > 0 ? box.diagonal() : 1};
  }
  for (Placed& placed : placed_) {
    if (!placed.object.endless) continue;
    pov_cut_endless(&placed.object, (*extent)->centre, (*extent)->size, kReach);
    const PovPlace& at = placed.object.place;
    report_->add("plane without end is cut at 10 times the size of the scene", at.file, at.line);
  }
}

}  // namespace strad
