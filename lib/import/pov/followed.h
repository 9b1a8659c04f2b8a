// A POV-Ray scene followed through the frames of an animation: what moves, turns, dims, and how.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/import.h"
#include "import/poses/follow.h"
#include "import/pov/scene_values.h"

namespace strad {

// All that a frame describes.
struct PovFrame {
  std::vector<PovPlaced> placed;
  std::optional<PovCamera> camera;
};

// The sides of an area light, by which its place and turn are known.
bool has_panel(const PovLight& light);

class PovFollowed {
 public:
  // `first` must outlive this. `mirror`: z becomes -z in the scene, and in what is told here.
  PovFollowed(const PovFrame& first, bool mirror, const ImportOptions& options, ImportReport* report);

  // Objects are the same as in the first frame if they come from the same statement, at the same place in the
  // file, the same time around. Throws BadInput, which names the object, its line and the frame, for one that
  // changes its shape or colour, appears or vanishes; with options.skip_unknown one that appears is left out,
  // and the others stay as they are in the first frame, which is reported. `frame`: its name in messages.
  void add_frame(const PovFrame& now, const std::string& frame);

  size_t frame_count() const { return follower_->frame_count(); }
  const std::vector<PoseFollower::Group>& groups() const { return follower_->groups(); }
  // Of the shapes of a placed object, and of its panels.
  uint32_t piece_of_shape(size_t placed, size_t shape) const {
    return first_shape_[placed] + static_cast<uint32_t>(shape);
  }
  uint32_t piece_of_panel(size_t placed, size_t light) const { return panels_.at({placed, light}); }
  const PoseFollower& follower() const { return *follower_; }

  // What changes; one item a frame, or none for what never changes.
  const std::vector<PovLight>& light_history(size_t placed, size_t light) const;
  const std::vector<PovCamera>& camera_history() const { return cameras_; }
  // Emitted radiance of the surfaces that vary. The keys are surfaces of the first frame.
  const std::map<const PovSurface*, std::vector<Rgb>>& emission_histories() const { return emissions_; }

 private:
  struct FrameSurfaces;
  void refuse_change(const std::string& what, const PovPlaced& placed, const std::string& frame,
                     const std::string& instead);
  void freeze_object(size_t placed);
  bool same_form(const PovObject& rest, const PovObject& now) const;
  void match(const PovFrame& now, const std::string& frame, std::vector<const PovPlaced*>* matched);
  void see_surfaces(const PovObject& rest, const PovObject& now, FrameSurfaces* seen);
  void see_lights(size_t placed, const PovPlaced& now, const std::string& frame);
  std::vector<Vec3> placed_points(const std::vector<Vec3>& points) const;
  std::vector<Vec3> panel_points(const PovLight& light) const;

  const PovFrame& first_;
  bool mirror_;
  const ImportOptions& options_;
  ImportReport* report_;
  std::map<std::tuple<std::string, uint32_t, std::string, int>, size_t>
      place_of_;                                                   // of objects in the first frame
  std::set<std::tuple<std::string, std::string, uint32_t>> told_;  // what has been reported, and of what
  std::vector<bool> frozen_;                                       // objects
  std::vector<std::vector<Vec3>> points_;  // of objects at rest, in the scene, then those of panels
  std::vector<std::span<const Vec3>> pieces_;
  std::vector<uint32_t> first_shape_;  // piece of each object's first shape
  std::map<std::pair<size_t, size_t>, uint32_t> panels_;
  std::unique_ptr<PoseFollower> follower_;
  std::map<std::pair<size_t, size_t>, std::vector<PovLight>> lights_;
  std::vector<PovCamera> cameras_;
  std::map<const PovSurface*, std::vector<Rgb>> emissions_;
};

}  // namespace strad
