// The rigid motion that takes points to where they are seen.
#pragma once

#include <span>

#include "base/pose.h"

namespace strad {

// Sums over pairs of points, enough to find the motion between them: several groups of points may be added.
class RigidFit {
 public:
  // `weight` of each pair. REQUIRES: as many points in both.
  void add(std::span<const Vec3> rest, std::span<const Vec3> seen);
  // The pose with the least squared distances |pose * rest - seen|: the unit quaternion of Horn 1987. Exact
  // to rounding where the points moved rigidly. Points on one line leave the turn about it open; it is then
  // none.
  Pose pose() const;

 private:
  double count_ = 0;
  Vec3 origin_rest_, origin_seen_;  // sums are of differences from these, so that they keep their digits
  Vec3 rest_, seen_;
  double products_[3][3] = {};  // of rest and seen coordinates
};

// The pose of one group of points.
Pose fit_rigid(std::span<const Vec3> rest, std::span<const Vec3> seen);

// The largest distance |pose * rest - seen|.
double fit_error(const Pose& pose, std::span<const Vec3> rest, std::span<const Vec3> seen);

}  // namespace strad
