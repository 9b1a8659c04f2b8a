// Where bodies can be during an interval, and poses at its time samples.
#pragma once

#include <vector>

#include "light/tracer.h"
#include "scene/scene.h"
#include "scene/trajectory.h"
#include "time/time_grid.h"

namespace strad {

class SweptBounds {
 public:
  SweptBounds(const Scene& scene, const Tracer& tracer, const TimeGrid& grid);

  bool moves(uint32_t body) const { return moving_[body]; }

  // World box of a moving body with surfaces over an interval.
  Box box(uint32_t body, Interval interval) const;

  // Can a moving body come between two spheres (world) during the interval?
  bool may_block(Vec3 centre_a, double radius_a, Vec3 centre_b, double radius_b, Interval interval) const;

  // May the segment from `from` to from + reach * direction meet a moving body, ever or during a cell?
  bool may_meet(Vec3 from, Vec3 direction, double reach) const;
  bool may_meet_in(uint32_t cell, Vec3 from, Vec3 direction, double reach) const;

  // Poses at a fraction `s` (0 to 1) of an interval. At a step at either end the values inside the interval
  // hold.
  std::vector<Pose> poses(Interval interval, double s) const;
  const std::vector<Pose>& cell_begin_poses(uint32_t cell) const { return begin_poses_[cell]; }
  const std::vector<Pose>& cell_end_poses(uint32_t cell) const { return end_poses_[cell]; }

 private:
  const Scene& scene_;
  const TimeGrid& grid_;
  std::vector<bool> moving_;
  std::vector<uint32_t> moving_list_;                       // moving bodies that have surfaces
  std::vector<std::vector<Pose>> begin_poses_, end_poses_;  // [cell]
  std::vector<std::vector<Box>> boxes_;                     // [index in moving_list_][cell]
  std::vector<Box> all_time_boxes_;                         // [index in moving_list_]
};

}  // namespace strad
