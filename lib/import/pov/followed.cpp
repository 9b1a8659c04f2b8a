#include "import/pov/followed.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"

namespace strad {
namespace {

// Names an object by its statement: file, line, kind or name, and how often that has been met before.
class StatementKeys {
 public:
  std::tuple<std::string, uint32_t, std::string, int> next(const PovPlaced& placed) {
    const PovPlace& place = placed.object.place;
    const std::tuple<std::string, uint32_t, std::string> statement{place.file, place.line, placed.name};
    return {place.file, place.line, placed.name, ++times_[statement]};
  }

 private:
  std::map<std::tuple<std::string, uint32_t, std::string>, int> times_;
};

// Whether two frames' surfaces differ in their emission at most.
bool same_but_emission(const PovSurface& a, const PovSurface& b) {
  return a.name == b.name && a.reflectance == b.reflectance && !a.image == !b.image &&
         (!a.image || a.image->path == b.image->path);
}

bool same_light(const PovLight& a, const PovLight& b) {
  return a.location == b.location && a.colour == b.colour && a.point_at == b.point_at &&
         a.radius == b.radius && a.falloff == b.falloff && a.axis1 == b.axis1 && a.axis2 == b.axis2 &&
         a.fade_distance == b.fade_distance && a.fade_power == b.fade_power;
}

bool same_kind(const PovLight& a, const PovLight& b) {
  return a.spotlight == b.spotlight && a.area == b.area && a.radius == b.radius && a.falloff == b.falloff &&
         a.tightness == b.tightness;
}

bool same_camera(const PovCamera& a, const PovCamera& b) {
  return a.location == b.location && a.direction == b.direction && a.right == b.right && a.up == b.up &&
         a.sky == b.sky && a.look_at == b.look_at;
}

// Appends `now`, the item of the frame after `frames` others, which were all `first` if nothing is stored.
template <class Item, class Same>
void add_to_history(std::vector<Item>* history, const Item& first, const Item& now, size_t frames,
                    Same same) {
  if (history->empty() && same(first, now)) return;
  history->resize(frames, history->empty() ? first : history->back());
  history->push_back(now);
}

}  // namespace

// Surfaces of a frame, by those of the first.
struct PovFollowed::FrameSurfaces {
  std::map<const PovSurface*, const PovSurface*> now;
  const PovSurface* differs = nullptr;
};

bool has_panel(const PovLight& light) {
  return light.area &&
         length(cross(light.axis1, light.axis2)) > 1e-12 * (length2(light.axis1) + length2(light.axis2));
}

std::vector<Vec3> PovFollowed::placed_points(const std::vector<Vec3>& points) const {
  std::vector<Vec3> placed = points;
  if (mirror_)
    for (Vec3& p : placed) p.z = -p.z;
  return placed;
}

std::vector<Vec3> PovFollowed::panel_points(const PovLight& light) const {
  const Vec3 corner = light.location - 0.5 * (light.axis1 + light.axis2);
  return placed_points({corner, corner + light.axis1, corner + light.axis2});
}

PovFollowed::PovFollowed(const PovFrame& first, bool mirror, const ImportOptions& options,
                         ImportReport* report)
    : first_(first), mirror_(mirror), options_(options), report_(report) {
  StatementKeys keys;
  frozen_.resize(first.placed.size());
  for (size_t i = 0; i < first.placed.size(); ++i) {
    place_of_[keys.next(first.placed[i])] = i;
    points_.push_back(placed_points(first.placed[i].object.points));
  }
  for (const PovPlaced& placed : first.placed)
    for (const PovLight& light : placed.object.lights)
      if (has_panel(light)) points_.push_back(panel_points(light));
  size_t panel = first.placed.size();
  for (size_t i = 0; i < first.placed.size(); ++i) {
    const PovObject& object = first.placed[i].object;
    first_shape_.push_back(static_cast<uint32_t>(pieces_.size()));
    for (size_t s = 0; s < object.shapes.size(); ++s) {
      const size_t begin = object.shapes[s];
      const size_t end = s + 1 < object.shapes.size() ? object.shapes[s + 1] : object.points.size();
      pieces_.push_back(std::span<const Vec3>(points_[i]).subspan(begin, end - begin));
    }
    for (size_t l = 0; l < object.lights.size(); ++l) {
      if (!has_panel(object.lights[l])) continue;
      panels_[{i, l}] = static_cast<uint32_t>(pieces_.size());
      pieces_.push_back(points_[panel++]);
    }
  }
  follower_ = std::make_unique<PoseFollower>(pieces_);
}

const std::vector<PovLight>& PovFollowed::light_history(size_t placed, size_t light) const {
  static const std::vector<PovLight> kNone;
  const auto found = lights_.find({placed, light});
  return found == lights_.end() ? kNone : found->second;
}

// `instead`: what is done with --skip-unknown.
void PovFollowed::refuse_change(const std::string& what, const PovPlaced& placed, const std::string& frame,
                                const std::string& instead) {
  const PovPlace& place = placed.object.place;
  const std::string text = "the object " + placed.name + " " + what;
  if (!options_.skip_unknown) fail_at(place.file, place.line, text + " in " + frame);
  if (told_.insert({text, place.file, place.line}).second)
    report_->add(text + " in " + frame + ": " + instead, place.file, place.line);
}

void PovFollowed::freeze_object(size_t placed) {
  frozen_[placed] = true;
  const PovObject& object = first_.placed[placed].object;
  for (size_t s = 0; s < object.shapes.size(); ++s) follower_->freeze(piece_of_shape(placed, s));
  for (size_t l = 0; l < object.lights.size(); ++l)
    if (const auto panel = panels_.find({placed, l}); panel != panels_.end())
      follower_->freeze(panel->second);
}

bool PovFollowed::same_form(const PovObject& rest, const PovObject& now) const {
  if (rest.points.size() != now.points.size() || rest.shapes != now.shapes ||
      rest.facets.size() != now.facets.size() || rest.lights.size() != now.lights.size())
    return false;
  for (size_t i = 0; i < rest.facets.size(); ++i)
    if (rest.facets[i].corners != now.facets[i].corners || rest.facets[i].part != now.facets[i].part)
      return false;
  for (size_t i = 0; i < rest.lights.size(); ++i)
    if (has_panel(rest.lights[i]) != has_panel(now.lights[i])) return false;
  return true;
}

// Finds each object of the first frame in this one; null for frozen ones.
void PovFollowed::match(const PovFrame& now, const std::string& frame,
                        std::vector<const PovPlaced*>* matched) {
  const std::string stays = "kept as it is in the first frame";
  matched->assign(first_.placed.size(), nullptr);
  StatementKeys keys;
  for (const PovPlaced& placed : now.placed) {
    const auto known = place_of_.find(keys.next(placed));
    if (known == place_of_.end())
      refuse_change("appears", placed, frame, "left out");
    else
      (*matched)[known->second] = &placed;
  }
  for (size_t i = 0; i < matched->size(); ++i) {
    const PovPlaced& rest = first_.placed[i];
    if (frozen_[i]) {
      (*matched)[i] = nullptr;
    } else if (!(*matched)[i]) {
      refuse_change("vanishes", rest, frame, stays);
      freeze_object(i);
    } else if (!same_form(rest.object, (*matched)[i]->object)) {
      refuse_change("changes its shape", rest, frame, stays);
      freeze_object(i);
      (*matched)[i] = nullptr;
    }
  }
}

void PovFollowed::see_surfaces(const PovObject& rest, const PovObject& now, FrameSurfaces* seen) {
  const PovSurface *last_rest = nullptr, *last_now = nullptr;
  for (size_t i = 0; i < rest.facets.size(); ++i) {
    const PovSurface *a = rest.facets[i].surface.get(), *b = now.facets[i].surface.get();
    if (a == last_rest && b == last_now) continue;
    last_rest = a, last_now = b;
    const auto [known, is_new] = seen->now.insert({a, b});
    const bool same =
        is_new ? same_but_emission(*a, *b)
               : known->second == b || (same_but_emission(*a, *b) && known->second->emission == b->emission);
    if (!same) seen->differs = a;
  }
}

void PovFollowed::see_lights(size_t placed, const PovPlaced& now, const std::string& frame) {
  const std::vector<PovLight>& rest = first_.placed[placed].object.lights;
  for (size_t l = 0; l < rest.size(); ++l) {
    const PovLight& light = now.object.lights[l];
    if (!same_kind(rest[l], light)) {
      refuse_change("changes the cone of its light", first_.placed[placed], frame,
                    "its light is that of the first frame");
      continue;
    }
    std::vector<PovLight> none;
    const auto known = lights_.find({placed, l});
    std::vector<PovLight>* history = known == lights_.end() ? &none : &known->second;
    add_to_history(history, rest[l], light, frame_count(), same_light);
    if (known == lights_.end() && !none.empty()) lights_[{placed, l}] = std::move(none);
  }
}

void PovFollowed::add_frame(const PovFrame& now, const std::string& frame) {
  std::vector<const PovPlaced*> matched;
  match(now, frame, &matched);
  FrameSurfaces surfaces;
  std::vector<std::vector<Vec3>> points(matched.size());
  std::map<uint32_t, std::vector<Vec3>> panels;
  std::vector<std::pair<size_t, size_t>> owner_of_piece(pieces_.size());  // object and its point or light
  for (size_t i = 0; i < matched.size(); ++i) {
    const PovObject& rest = first_.placed[i].object;
    for (size_t s = 0; s < rest.shapes.size(); ++s)
      owner_of_piece[piece_of_shape(i, s)] = {i, rest.shapes[s]};
    for (size_t l = 0; l < rest.lights.size(); ++l) {
      const auto panel = panels_.find({i, l});
      if (panel == panels_.end()) continue;
      owner_of_piece[panel->second].first = i;
      if (matched[i]) panels[panel->second] = panel_points(matched[i]->object.lights[l]);
    }
    if (!matched[i]) continue;
    points[i] = placed_points(matched[i]->object.points);
    see_surfaces(rest, matched[i]->object, &surfaces);
    if (surfaces.differs) {
      refuse_change("changes its colour", first_.placed[i], frame, "its colour is that of the first frame");
      surfaces.differs = nullptr;
    }
    see_lights(i, *matched[i], frame);
  }
  for (const auto& [rest, seen] : surfaces.now)
    if (auto& history = emissions_[rest]; !history.empty() || !(seen->emission == rest->emission))
      add_to_history(&history, rest->emission, seen->emission, frame_count(),
                     [](Rgb a, Rgb b) { return a == b; });
  if (now.camera && first_.camera)
    add_to_history(&cameras_, *first_.camera, *now.camera, frame_count(), same_camera);
  const std::vector<uint32_t> bent = follower_->add_frame([&](uint32_t piece) -> std::span<const Vec3> {
    if (const auto panel = panels.find(piece); panel != panels.end()) return panel->second;
    const auto [object, begin] = owner_of_piece[piece];
    return std::span<const Vec3>(points[object]).subspan(begin, pieces_[piece].size());
  });
  std::set<size_t> objects;
  for (const uint32_t piece : bent) objects.insert(owner_of_piece[piece].first);
  for (const size_t object : objects) {
    refuse_change("changes its shape", first_.placed[object], frame, "kept as it is in the first frame");
    freeze_object(object);
  }
}

}  // namespace strad
