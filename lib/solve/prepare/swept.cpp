#include "solve/prepare/swept.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

// Distance from a box to the segment from a to b. It is a convex function along the segment, so ternary
// search finds its minimum.
double distance_to_box(const Box& box, Vec3 p) {
  Vec3 d;
  for (int i = 0; i < 3; ++i) d[i] = std::max({box.lower[i] - p[i], 0.0, p[i] - box.upper[i]});
  return length(d);
}

}  // namespace

SweptBounds::SweptBounds(const Scene& scene, const Tracer& tracer, const TimeGrid& grid)
    : scene_(scene), grid_(grid), moving_(strad::moving_bodies(scene)) {
  for (uint32_t b = 0; b < moving_.size(); ++b)
    if (moving_[b] && !tracer.body_box(b).empty()) moving_list_.push_back(b);
  const uint32_t cells = grid.cell_count();
  for (uint32_t c = 0; c < cells; ++c) {
    begin_poses_.push_back(poses({c, 0}, 0));
    end_poses_.push_back(poses({c, 0}, 1));
  }
  for (const uint32_t b : moving_list_) {
    const Box rest = tracer.body_box(b);
    std::vector<Box> boxes(cells);
    for (uint32_t c = 0; c < cells; ++c) {
      // The box over five instants of a cell, and a margin for the path of a turning body between them.
      double travel = 0;
      std::vector<Vec3> last;
      for (int k = 0; k <= 4; ++k) {
        const Pose pose = poses({c, 0}, k / 4.0)[b];
        std::vector<Vec3> now;
        for (int corner = 0; corner < 8; ++corner)
          now.push_back(pose * Vec3{corner & 1 ? rest.lower.x : rest.upper.x,
                                    corner & 2 ? rest.lower.y : rest.upper.y,
                                    corner & 4 ? rest.lower.z : rest.upper.z});
        for (size_t i = 0; i < now.size(); ++i) {
          boxes[c].add(now[i]);
          if (!last.empty()) travel = std::max(travel, length(now[i] - last[i]));
        }
        last = now;
      }
      const Vec3 margin = 0.25 * travel * Vec3{1, 1, 1};
      boxes[c] = {boxes[c].lower - margin, boxes[c].upper + margin};
    }
    all_time_boxes_.emplace_back();
    for (const Box& box : boxes) all_time_boxes_.back().add(box);
    boxes_.push_back(std::move(boxes));
  }
}

std::vector<Pose> SweptBounds::poses(Interval interval, double s) const {
  const double begin = interval_begin(grid_, interval), end = interval_end(grid_, interval);
  // 1e-9 of the interval inside, so that at a step the values are those of this side.
  return poses_at(scene_, begin + std::clamp(s, 1e-9, 1 - 1e-9) * (end - begin));
}

Box SweptBounds::box(uint32_t body, Interval interval) const {
  const auto index =
      static_cast<size_t>(std::find(moving_list_.begin(), moving_list_.end(), body) - moving_list_.begin());
  Box box;
  for (uint32_t c = 0; c < interval.cell_count(); ++c) box.add(boxes_[index][interval.cell + c]);
  return box;
}

bool SweptBounds::may_meet(Vec3 from, Vec3 direction, double reach) const {
  return std::any_of(all_time_boxes_.begin(), all_time_boxes_.end(),
                     [&](const Box& box) { return box.meets(from, direction, reach); });
}

bool SweptBounds::may_meet_in(uint32_t cell, Vec3 from, Vec3 direction, double reach) const {
  for (size_t i = 0; i < boxes_.size(); ++i)
    if (boxes_[i][cell].meets(from, direction, reach)) return true;
  return false;
}

bool SweptBounds::may_block(Vec3 centre_a, double radius_a, Vec3 centre_b, double radius_b,
                            Interval interval) const {
  for (const uint32_t body : moving_list_) {
    const Box swept = box(body, interval);
    const auto clearance = [&](double s) {
      return distance_to_box(swept, lerp(centre_a, centre_b, s)) - (radius_a + s * (radius_b - radius_a));
    };
    double low = 0, high = 1;
    double least = std::min(clearance(0), clearance(1));
    for (int i = 0; i < 16 && least > 0; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      const double ca = clearance(a), cb = clearance(b);
      least = std::min({least, ca, cb});
      (ca < cb ? high : low) = ca < cb ? b : a;
    }
    if (!(least > 0)) return true;
  }
  return false;
}

}  // namespace strad
