// POV-Ray's light sources as spotlights and emitting panels of the same light.
//
// A surface in POV-Ray has the radiance pigment * diffuse * colour * cos, in strad reflectance / pi * I cos /
// r^2. So I = pi r^2 colour, where `colour` is that of the light as faded at distance r.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/poses/few_scene_keys.h"
#include "import/pov/build.h"
#include "import/pov/shapes.h"

namespace strad {
namespace {

constexpr double kFullCone = 179.99 * kDegree;  // a cone must be narrower than a sphere

// Names of the lights that strad-frame --pov writes for emitting surfaces. The surfaces come back as
// emitters, so with these lights their light would count twice.
constexpr std::string_view kOwnLamps = "strad_lamp_";

}  // namespace

// The intensity on the light's axis, W / sr.
Rgb PovBuilder::intensity_of(const PovLight& light) {
  if (std::min({light.colour.r, light.colour.g, light.colour.b}) < 0)
    fail_at(light.place.file, light.place.line, "the colour of a light is negative");
  if (is_black(light.colour)) return {};
  if (light.spotlight && !(length(light.point_at - light.location) > 0))
    fail_at(light.place.file, light.place.line, "a spotlight points at itself");
  const double d = light.fade_distance;
  // The fading 2 / (1 + (r / d)^2) is 2 d^2 / r^2 for r far above d.
  if (d > 0 && light.fade_power == 2) return static_cast<float>(2 * kPi * d * d) * light.colour;
  const Vec3 target = light.spotlight ? light.point_at : placed(box_of(scene_).centre());
  const double r = length(target - light.location);
  const bool fades = d > 0 && light.fade_power > 0;
  const double faded = fades ? 2 / (1 + std::pow(r / d, light.fade_power)) : 1;
  report_->add(
      "light that does not fade with the square of the distance is made to: its strength is that at " +
          std::string(light.spotlight ? "point_at" : "the middle of the scene"),
      light.place.file, light.place.line);
  return static_cast<float>(kPi * r * r * faded) * light.colour;
}

void PovBuilder::add_light(const PovPlaced& placed, size_t index, size_t number) {
  const PovLight& light = placed.object.lights[number];
  for (const PovProblem& problem : light.problems) refuse(problem, options_, report_);
  if (std::min({light.colour.r, light.colour.g, light.colour.b}) < 0)
    return refuse({"a light of negative colour", light.place}, options_, report_);
  if (light.name.starts_with(kOwnLamps)) return;
  Light found{light, {}, {}};
  if (followed_) found.history = followed_->light_history(index, number);
  // The light of an object that is kept as it is in the first frame.
  if (followed_ && found.history.size() < followed_->frame_count()) found.history.clear();
  if (found.history.empty()) found.intensities = {intensity_of(light)};
  for (const PovLight& now : found.history) found.intensities.push_back(intensity_of(now));
  if (std::all_of(found.intensities.begin(), found.intensities.end(), is_black)) return;
  // A spotlight as wide as a hemisphere that falls with the cosine is POV-Ray's way to write a diffuse
  // emitter.
  const bool is_lambertian = light.tightness == 1 && std::abs(light.radius) >= 90 && light.falloff >= 90;
  const Vec3 across = cross(light.axis1, light.axis2);
  if (has_panel(light) && (!light.spotlight || is_lambertian)) {
    const uint32_t body = followed_ ? body_of_piece(followed_->piece_of_panel(index, number)) : 0;
    const double side = light.spotlight && dot(across, light.point_at - light.location) < 0 ? -1 : 1;
    add_panel(found, body, side * normalized(across), light.spotlight);
    if (!light.spotlight) add_panel(found, body, -normalized(across), false);
    return;
  }
  if (has_panel(light))
    report_->add("area_light of a spotlight is taken as a point", light.place.file, light.place.line);
  add_spot(found);
}

void PovBuilder::add_spot(const Light& light) {
  const PovLight& first = light.at_first;
  Spot spot;
  spot.name = spot_names_.unique(first.name.empty() ? "light_source" : first.name);
  spot.inner = spot.outer = kFullCone;
  if (first.spotlight) {
    spot.outer = std::min(first.falloff * kDegree, kFullCone);
    spot.inner = std::clamp(first.radius * kDegree, 0.0, spot.outer);
    if (!(spot.outer > 0))
      fail_at(first.place.file, first.place.line, "the falloff of a spotlight is not above 0");
    if (first.tightness != 0)
      report_->add("tightness of a spotlight is ignored", first.place.file, first.place.line);
  }
  spot.body = carrier_of(light);
  spot.keys = spot_keys(light, spot.body);
  scene_.spots.push_back(std::move(spot));
}

// A Lambertian panel of radiance Le and area A has the intensity Le A on its axis and the power pi Le A; a
// point light sends 2 pi I to each side. The panel is moved to its front by a thousandth of its size, because
// many lie in the plane of a ceiling.
void PovBuilder::add_panel(const Light& source, uint32_t body, Vec3 front, bool is_lambertian) {
  const PovLight& light = source.at_first;
  const double area = length(cross(light.axis1, light.axis2));
  const auto emission_of_intensity = [&](Rgb intensity) {
    return static_cast<float>((is_lambertian ? 1 : 2) / area) * intensity;
  };
  auto surface = std::make_shared<PovSurface>();
  surface->name = light.name;
  surface->place = light.place;
  std::vector<Rgb> emissions;
  for (const Rgb intensity : source.intensities) emissions.push_back(emission_of_intensity(intensity));
  surface->emission = emissions[0];
  const bool flipped = dot(cross(light.axis1, light.axis2), front) < 0;
  const Vec3 u = flipped ? light.axis2 : light.axis1, v = flipped ? light.axis1 : light.axis2;
  const Vec3 corner = light.location - 0.5 * (u + v) + 1e-3 * std::sqrt(area) * front;
  PovObject panel;
  panel.place = light.place;
  panel.points = {corner, corner + u, corner + u + v, corner + v};
  panel.facets.emplace_back();
  panel.facets[0].corners = {0, 1, 2, 3};
  panel.facets[0].surface = surface;
  panels_.push_back(surface);  // kept alive: materials are looked up by the address of their surface
  panel_emissions_[surface.get()] = varying(emissions, light.place);
  Parts parts{object_names_.unique(light.name.empty() ? "light_source" : light.name), {}, {body}};
  add_surfaces(panel, &parts);
}

}  // namespace strad
