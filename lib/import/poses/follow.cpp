#include "import/poses/follow.h"

#include <algorithm>
#include <numeric>

#include "import/poses/rigid_fit.h"

namespace strad {

PoseFollower::PoseFollower(std::vector<std::span<const Vec3>> rest, double precision)
    : rest_(std::move(rest)), precision_(precision) {
  for (const auto& points : rest_) {
    Box box;
    for (const Vec3 p : points) box.add(p);
    sizes_.push_back(box.empty() ? 0 : box.diagonal());
    centres_.push_back(box.empty() ? Vec3{} : box.centre());
  }
  groups_.emplace_back();
  frozen_.resize(rest_.size());
  groups_[0].pieces.resize(rest_.size());
  std::iota(groups_[0].pieces.begin(), groups_[0].pieces.end(), 0u);
}

// How far a point of `piece` may be from where the pose of `fitted` puts it. Coordinates with few digits
// leave the turn of a piece open by their precision over its size, and so what is far from it.
double PoseFollower::tolerance(uint32_t piece, uint32_t fitted) const {
  const double reach = length(centres_[piece] - centres_[fitted]) + sizes_[piece];
  const double leverage = sizes_[fitted] > 0 ? 1 + reach / sizes_[fitted] : 1;
  return kAlike * sizes_[piece] + 3 * precision_ * leverage;
}

bool PoseFollower::fits(const Pose& pose, uint32_t piece, uint32_t fitted, const PointsOf& points) const {
  const double limit = tolerance(piece, fitted), limit2 = limit * limit;
  const std::span<const Vec3> rest = rest_[piece], seen = points(piece);
  for (size_t i = 0; i < rest.size(); ++i)
    if (!(length2(pose * rest[i] - seen[i]) <= limit2)) return false;
  return true;
}

Pose PoseFollower::pose_of(const std::vector<uint32_t>& pieces, const PointsOf& points) const {
  RigidFit fit;
  for (const uint32_t piece : pieces) fit.add(rest_[piece], points(piece));
  return fit.pose();
}

// Finds where the pieces of a group are. Those that went other ways leave it, into groups of their own.
void PoseFollower::split(size_t group, const PointsOf& points, std::vector<uint32_t>* bent) {
  std::vector<uint32_t> left = std::move(groups_[group].pieces);
  const std::vector<Pose> before = groups_[group].poses;
  groups_[group].pieces.clear();
  if (group == 0) {
    std::erase_if(left, [&](uint32_t piece) {
      const bool stays = frozen_[piece] || fits({}, piece, piece, points);
      if (stays) groups_[0].pieces.push_back(piece);
      return stays;
    });
  }
  // The largest piece fixes the turn best.
  std::stable_sort(left.begin(), left.end(), [&](uint32_t a, uint32_t b) { return sizes_[a] > sizes_[b]; });
  bool first = group != 0;
  while (!left.empty()) {
    const uint32_t leader = left.front();
    const Pose pose = fit_rigid(rest_[leader], points(leader));
    if (!fits(pose, leader, leader, points)) {
      bent->push_back(leader);
      left.erase(left.begin());
      continue;
    }
    Group moved;
    std::vector<uint32_t> others;
    for (const uint32_t piece : left)
      (fits(pose, piece, leader, points) ? moved.pieces : others).push_back(piece);
    moved.poses = before;
    if (moved.poses.empty()) moved.poses.resize(frames_);
    moved.poses.push_back(precision_ > 0 ? pose_of(moved.pieces, points) : pose);
    std::sort(moved.pieces.begin(), moved.pieces.end());
    left = std::move(others);
    if (first) {
      groups_[group] = std::move(moved);
      first = false;
    } else {
      groups_.push_back(std::move(moved));
    }
  }
  // None is left where all of them bent.
  if (first) groups_[group].poses.push_back(before.back());
}

void PoseFollower::freeze(uint32_t piece) {
  for (Group& group : groups_) std::erase(group.pieces, piece);
  frozen_[piece] = true;
  groups_[0].pieces.push_back(piece);
  std::sort(groups_[0].pieces.begin(), groups_[0].pieces.end());
}

std::vector<uint32_t> PoseFollower::add_frame(const PointsOf& points) {
  std::vector<uint32_t> bent;
  const size_t count = groups_.size();
  for (size_t group = 0; group < count; ++group) split(group, points, &bent);
  ++frames_;
  std::sort(bent.begin(), bent.end());
  for (const uint32_t piece : bent) freeze(piece);
  return bent;
}

}  // namespace strad
