#include "export/pov/lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "export/mesh.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

// POV-Ray's light fades by 2 / (1 + (r / d)^2) with the distance r. For r > 1000 d this is 2 d^2 / r^2 within
// 1e-6, an inverse square law. The gain makes up for the factor. d is in metres.
constexpr double kFadeDistance = 1e-4;
constexpr float kFadeGain = static_cast<float>(1 / (2 * kFadeDistance * kFadeDistance));
// POV-Ray reflects pigment * cosine * light, without the 1 / pi of a diffuse surface. So its lights have
// that.
constexpr float kLightGain = kFadeGain / static_cast<float>(kPi);
constexpr const char* kFading = " fade_distance 1e-4 fade_power 2";

constexpr double kParallel = 1e-5;  // of a diagonal: how far opposite sides of a parallelogram may differ

// An emitting polygon, or two emitting triangles that were joined to a parallelogram.
struct Panel {
  uint32_t polygon = 0;
  std::array<Vec3, 4> corners;
  int corner_count = 4;
  double area = 0;
};

bool is_parallelogram(const Panel& panel) {
  const auto& c = panel.corners;
  if (panel.corner_count == 3) return false;
  return length((c[1] - c[0]) - (c[2] - c[3])) <= kParallel * length(c[2] - c[0]);
}

Panel panel_of(const Scene& scene, uint32_t polygon) {
  Panel panel;
  panel.polygon = polygon;
  panel.corner_count = scene.polygons[polygon].corner_count();
  for (int i = 0; i < panel.corner_count; ++i) {
    panel.corners[i] = scene.vertices[scene.polygons[polygon].corners[i]];
  }
  return panel;
}

// The parallelogram of the triangle `a` and a triangle `b` that shares its edge from corner `i`; nothing if
// they do not make one.
std::optional<Panel> joined(const Panel& a, int i, const Panel& b) {
  const Vec3 from = a.corners[i], to = a.corners[(i + 1) % 3], opposite = a.corners[(i + 2) % 3];
  for (const Vec3 other : {b.corners[0], b.corners[1], b.corners[2]}) {
    const Panel panel{.polygon = a.polygon, .corners = {opposite, from, other, to}};
    if (!(other == from) && !(other == to) && is_parallelogram(panel)) return panel;
  }
  return std::nullopt;
}

// An edge, as a key: object and material of its triangle, and its two ends.
using Edge = std::tuple<uint32_t, uint32_t, std::array<double, 6>>;
Edge edge_of(const Scene& scene, const Panel& panel, Vec3 from, Vec3 to) {
  const Polygon& polygon = scene.polygons[panel.polygon];
  return {polygon.object, polygon.material, {from.x, from.y, from.z, to.x, to.y, to.z}};
}

// Adds a panel, joined with a triangle already there if the two make a parallelogram.
void add_panel(const Scene& scene, const Panel& panel, std::map<Edge, size_t>* open,
               std::vector<Panel>* panels) {
  if (panel.corner_count == 4) return panels->push_back(panel);
  for (int i = 0; i < 3; ++i) {
    const auto other = open->find(edge_of(scene, panel, panel.corners[(i + 1) % 3], panel.corners[i]));
    if (other == open->end() || (*panels)[other->second].corner_count == 4) continue;
    const auto both = joined(panel, i, (*panels)[other->second]);
    if (!both) continue;
    (*panels)[other->second] = *both;
    return;
  }
  for (int i = 0; i < 3; ++i) {
    (*open)[edge_of(scene, panel, panel.corners[i], panel.corners[(i + 1) % 3])] = panels->size();
  }
  panels->push_back(panel);
}

int power_of_two_near(double x) { return x > 1 ? 1 << std::lround(std::log2(x)) : 1; }

// Cuts panels into lamps.
class LampCutter {
 public:
  explicit LampCutter(const Scene& scene) : scene_(scene), lift_(export_lift(scene)) {}

  void cut(const Panel& panel, int samples) {
    polygon_ = &scene_.polygons[panel.polygon];
    const auto& c = panel.corners;
    normal_ = normalized(cross(c[1] - c[0], c[2] - c[0]));
    if (is_parallelogram(panel)) return cut_parallelogram(c[0], c[1] - c[0], c[3] - c[0], samples);
    cut_triangle(c[0], c[1], c[2], samples);
    if (panel.corner_count == 4) cut_triangle(c[0], c[2], c[3], samples);
  }

  std::vector<PovLamp> take() {
    std::stable_sort(lamps_.begin(), lamps_.end(),
                     [](const PovLamp& a, const PovLamp& b) { return a.material < b.material; });
    return std::move(lamps_);
  }

 private:
  // POV-Ray applies the mean shadow of an area_light to each of its lights, and counts those behind the
  // horizon. Four quarters have a fourth of this error (in a Cornell box 0.3 % instead of 0.9 %), and take
  // less time than one adaptive area_light.
  void cut_parallelogram(Vec3 corner, Vec3 u, Vec3 v, int samples) {
    if (samples < 4) return add(corner + 0.5 * (u + v), u, v, length(cross(u, v)), samples);
    for (const double s : {0.25, 0.75}) {
      for (const double t : {0.25, 0.75}) {
        add(corner + s * u + t * v, 0.5 * u, 0.5 * v, 0.25 * length(cross(u, v)), samples / 2);
      }
    }
  }

  // Half of a triangle's area is cut off as a parallelogram. Two triangles of half its size are left.
  void cut_triangle(Vec3 a, Vec3 b, Vec3 c, int samples) {
    const Vec3 corners[3] = {a, b, c};
    if (samples == 1) return add((a + b + c) / 3, {}, {}, area_of(corners, 3), 1);
    const Vec3 ab = lerp(a, b, 0.5), bc = lerp(b, c, 0.5), ca = lerp(c, a, 0.5);
    cut_parallelogram(a, ab - a, ca - a, samples / 2);
    cut_triangle(ab, b, bc, samples / 2);
    cut_triangle(ca, bc, c, samples / 2);
  }

  void add(Vec3 centre, Vec3 u, Vec3 v, double area, int samples) {
    lamps_.push_back(
        {.material = polygon_->material,
         .body = body_of(scene_, *polygon_),
         .centre = centre + lift_ * normal_,  // in front of the polygon, which could shadow it otherwise
         .u = u,
         .v = v,
         .normal = normal_,
         .area = area,
         .samples = samples});
  }

  const Scene& scene_;
  const double lift_;
  const Polygon* polygon_ = nullptr;
  Vec3 normal_;
  std::vector<PovLamp> lamps_;
};

void write_lamp(const PovLamp& lamp, Rgb radiance, const Pose& world_from_body, PovText* out) {
  const Vec3 centre = world_from_body * lamp.centre;
  *out << "  light_source { ";
  out->exact(centre) << " rgb strad_exposure*" << kLightGain * static_cast<float>(lamp.area) * radiance
                     << kFading << "\n    spotlight point_at ";
  out->exact(centre + rotate(world_from_body, lamp.normal)) << " tightness 1 radius 90 falloff 90";
  if (lamp.samples > 1) {
    const double inset = 1 - 1.0 / lamp.samples;  // POV-Ray places the outer lights on the border of the area
    *out << "\n    area_light ";
    out->exact(rotate(world_from_body, inset * lamp.u)) << ", ";
    out->exact(rotate(world_from_body, inset * lamp.v))
        << ", " << lamp.samples << ", " << lamp.samples << " adaptive 0 area_illumination on";
  }
  *out << " }\n";
}

// A spotlight of POV-Ray. Its falloff is a smoothstep in the cosine, as strad's, but it is dark beyond 90
// degrees.
void write_cone(const SpotState& state, double sign, Vec3 direction, double inner, double outer,
                PovText* out) {
  constexpr double kDegrees = 180 / kPi;
  *out << "  light_source { ";
  out->exact(state.position) << " rgb strad_exposure*"
                             << static_cast<float>(sign) * kLightGain * state.intensity << kFading
                             << "\n    spotlight point_at ";
  out->exact(state.position + direction)
      << " tightness 0 radius " << inner * kDegrees << " falloff " << outer * kDegrees << " }\n";
}

void open_object(const std::string& name, bool several, PovText* out) {
  *out << "#declare " << name << " = " << (several ? "union {\n" : "object {\n");
}

}  // namespace

std::vector<PovLamp> pov_lamps(const Scene& scene, int samples) {
  std::vector<Panel> panels;
  std::map<Edge, size_t> open;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    if (emits(scene, scene.polygons[p])) add_panel(scene, panel_of(scene, p), &open, &panels);
  }
  std::map<std::pair<uint32_t, uint32_t>, double> area_of_lamp;  // by object and material
  const auto lamp_area = [&](const Panel& panel) -> double& {
    return area_of_lamp[{scene.polygons[panel.polygon].object, scene.polygons[panel.polygon].material}];
  };
  for (Panel& panel : panels)
    lamp_area(panel) += panel.area = area_of(panel.corners.data(), panel.corner_count);
  LampCutter cutter(scene);
  for (const Panel& panel : panels) {
    if (!(panel.area > 0)) continue;
    cutter.cut(panel, power_of_two_near(samples * std::sqrt(panel.area / lamp_area(panel))));
  }
  return cutter.take();
}

void write_spot(const Spot& spot, const SpotState& state, const std::string& name, PovText* out) {
  const bool behind = spot.outer > kPi / 2;
  open_object(name, behind, out);
  write_cone(state, 1, state.direction, spot.inner, spot.outer, out);
  if (behind) {
    // What shines backwards is all light of the half-space behind, less that of a cone about the reverse
    // direction, whose falloff is 1 - smoothstep.
    write_cone(state, 1, -state.direction, kPi / 2, kPi / 2, out);
    write_cone(state, -1, -state.direction, kPi - spot.outer, kPi - spot.inner, out);
  }
  *out << "}\n";
}

void write_lamps(const PovLamp* first, const PovLamp* last, Rgb radiance,
                 const std::vector<Pose>& world_from_body, const std::string& name, PovText* out) {
  open_object(name, last - first > 1, out);
  for (const PovLamp* lamp = first; lamp < last; ++lamp) {
    write_lamp(*lamp, radiance, world_from_body[lamp->body], out);
  }
  *out << "}\n";
}

}  // namespace strad
