// What moves in a POV-Ray animation, as bodies, keys and glows.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/poses/body_keys.h"
#include "import/poses/few_scene_keys.h"
#include "import/pov/build.h"

namespace strad {
namespace {

bool is_parallel(Vec3 a, Vec3 b) {
  return length(cross(normalized(a), normalized(b))) < 1e-9 && dot(a, b) > 0;
}

}  // namespace

PovBuilder::PovBuilder(const ImportOptions& options, ImportReport* report, bool mirror,
                       const PovFollowed* followed, std::vector<double> times)
    : options_(options),
      report_(report),
      mirror_(mirror),
      followed_(followed),
      times_(std::move(times)),
      glows_(1) {
  if (!followed_) return;
  body_of_group_.resize(followed_->groups().size(), kNone);
  body_of_group_[0] = 0;
  for (uint32_t group = 0; group < followed_->groups().size(); ++group)
    for (const uint32_t piece : followed_->groups()[group].pieces) {
      group_of_piece_.resize(std::max<size_t>(group_of_piece_.size(), piece + 1), 0);
      group_of_piece_[piece] = group;
    }
}

uint32_t PovBuilder::body_of_piece(uint32_t piece) {
  const uint32_t group = group_of_piece_[piece];
  uint32_t& body = body_of_group_[group];
  if (body != kNone) return body;
  body = static_cast<uint32_t>(scene_.bodies.size());
  scene_.bodies.push_back(body_of_group(followed_->follower(), group, times_));
  return body;
}

// The body that a light rides on: one that takes it from its place in the first frame to all others. The
// world if there is none.
uint32_t PovBuilder::carrier_of(const Light& light) const {
  if (light.history.empty()) return 0;
  for (uint32_t group = 1; group < body_of_group_.size(); ++group) {
    if (body_of_group_[group] == kNone) continue;
    const std::vector<Pose>& poses = followed_->groups()[group].poses;
    const Vec3 at = placed(light.at_first.location), aim = placed(light.at_first.point_at);
    const double limit = kAlike * (light.at_first.spotlight ? length(aim - at) : box_of(scene_).diagonal());
    bool rides = true;
    for (size_t frame = 0; frame < poses.size() && rides; ++frame) {
      const PovLight& now = light.history[frame];
      rides = length(poses[frame] * at - placed(now.location)) <= limit &&
              (!now.spotlight || length(poses[frame] * aim - placed(now.point_at)) <= limit);
    }
    if (rides) return body_of_group_[group];
  }
  return 0;
}

std::vector<SpotKey> PovBuilder::spot_keys(const Light& light, uint32_t body) const {
  std::vector<SpotKey> keys;
  for (size_t frame = 0; frame < light.intensities.size(); ++frame) {
    // On a body, places are those at rest.
    const PovLight& now = light.history.empty() || body != 0 ? light.at_first : light.history[frame];
    const Vec3 aim = now.spotlight ? now.point_at : now.location - Vec3{0, 1, 0};
    keys.push_back(
        {frame == 0 ? 0 : times_[frame], placed(now.location), placed(aim), light.intensities[frame]});
  }
  return few_spot_keys(keys, box_of(scene_).diagonal());
}

// From where to where the file says, if that is what the camera's vectors show: then fewer keys tell its way.
CameraKey PovBuilder::camera_key(const PovCamera& camera, double time) const {
  const double height = length(camera.up), depth = length(camera.direction);
  if (!(height > 0) || !(depth > 0) || !(length(cross(camera.up, camera.direction)) > 0))
    fail_at(camera.place.file, camera.place.line, "the camera has no direction or no upward vector");
  CameraKey key;
  key.time = time;
  key.from = placed(camera.location);
  key.to = key.from + placed(normalized(camera.direction));
  key.up = placed(normalized(camera.up));
  key.fov = 2 * std::atan(height / 2 / depth);
  const Vec3 side = cross(camera.direction, camera.up);
  if (camera.look_at && is_parallel(*camera.look_at - camera.location, camera.direction))
    key.to = placed(*camera.look_at);
  if (is_parallel(cross(camera.direction, camera.sky), side)) key.up = placed(normalized(camera.sky));
  return key;
}

// A light of one colour that varies, as its brightest emission and a scale over time.
PovBuilder::Varying PovBuilder::varying(const std::vector<Rgb>& emissions, const PovPlace& place) const {
  Varying result{emissions[0], {}};
  for (const Rgb emission : emissions)
    if (max_channel(emission) > max_channel(result.emission)) result.emission = emission;
  if (emissions.size() == 1) return result;
  const Rgb full = result.emission;
  std::vector<GlowKey> keys;
  for (size_t frame = 0; frame < emissions.size(); ++frame) {
    const float value = max_channel(emissions[frame]) / max_channel(full);
    const Rgb rest = emissions[frame] - value * full;
    if (!(std::max({std::abs(rest.r), std::abs(rest.g), std::abs(rest.b)}) <= 1e-4f * max_channel(full)))
      refuse({"light that changes its colour (in frame " + std::to_string(frame + 1) + " of those taken)",
              place},
             options_, report_);
    keys.push_back({times_[frame], std::round(value * 1e6f) / 1e6f});
  }
  result.keys = few_glow_keys(keys);
  return result;
}

PovBuilder::Varying PovBuilder::emission_of(const PovSurface& surface) const {
  if (const auto panel = panel_emissions_.find(&surface); panel != panel_emissions_.end())
    return panel->second;
  if (!followed_) return {surface.emission, {}};
  const auto found = followed_->emission_histories().find(&surface);
  if (found == followed_->emission_histories().end() || found->second.size() < times_.size())
    return {surface.emission, {}};
  return varying(found->second, surface.place);
}

Scene PovBuilder::take() {
  name_bodies(&scene_);
  std::sort(scene_.glows.begin(), scene_.glows.end(),
            [](const Glow& a, const Glow& b) { return a.material < b.material; });
  return std::move(scene_);
}

}  // namespace strad
