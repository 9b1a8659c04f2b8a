// Follows the pieces of a scene from frame to frame: which moved, how, and which moved alike.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/pose.h"

namespace strad {

// Of a piece's size: pieces that are moved by a pose to within this part of it moved by that pose.
constexpr double kAlike = 1e-6;

class PoseFollower {
 public:
  using PointsOf = std::function<std::span<const Vec3>(uint32_t piece)>;

  // The pieces as they are in the first frame, which must outlive the follower. `precision`: how far the
  // coordinates of a file may be from what was meant, for being written with few digits.
  explicit PoseFollower(std::vector<std::span<const Vec3>> rest, double precision = 0);

  // Adds a frame. `points`: of a piece, as many as at rest; not asked for frozen ones. Returns the pieces
  // that no rigid motion has brought where they are: they are frozen.
  std::vector<uint32_t> add_frame(const PointsOf& points);

  // The piece is where it was in the first frame, now and at all other times.
  void freeze(uint32_t piece);
  bool is_frozen(uint32_t piece) const { return frozen_[piece]; }

  // Pieces that moved alike in all frames.
  struct Group {
    std::vector<uint32_t> pieces;  // ascending
    std::vector<Pose> poses;       // scene from rest, one a frame, from the first on; none: never moved
  };
  const std::vector<Group>& groups() const { return groups_; }  // the first never moved; it may be empty
  size_t frame_count() const { return frames_; }
  // Of a piece: the diagonal of its bounds.
  double size_of(uint32_t piece) const { return sizes_[piece]; }
  std::span<const Vec3> rest_of(uint32_t piece) const { return rest_[piece]; }
  double precision() const { return precision_; }

 private:
  double tolerance(uint32_t piece, uint32_t fitted) const;
  Pose pose_of(const std::vector<uint32_t>& pieces, const PointsOf& points) const;
  bool fits(const Pose& pose, uint32_t piece, uint32_t fitted, const PointsOf& points) const;
  void split(size_t group, const PointsOf& points, std::vector<uint32_t>* bent);

  std::vector<std::span<const Vec3>> rest_;
  std::vector<Vec3> centres_;
  std::vector<double> sizes_;
  std::vector<bool> frozen_;
  double precision_;
  size_t frames_ = 1;
  std::vector<Group> groups_;
};

}  // namespace strad
