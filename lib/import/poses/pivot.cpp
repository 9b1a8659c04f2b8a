#include "import/poses/pivot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace strad {
namespace {

using Matrix3 = std::array<Vec3, 3>;  // rows

Matrix3 matrix_of(Quat q) {
  const Vec3 x = rotate(q, {1, 0, 0}), y = rotate(q, {0, 1, 0}), z = rotate(q, {0, 0, 1});
  return {Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}};
}

// The second difference of the path of rest point p is turn p + move.
struct Bend {
  Matrix3 turn;
  Vec3 move;
  Vec3 at(Vec3 p) const {
    return {dot(turn[0], p) + move.x, dot(turn[1], p) + move.y, dot(turn[2], p) + move.z};
  }
};

// Second differences over a stride of frames long enough that a turn shows in them, well above rounding and
// what files with few digits leave open; short enough that a stop or a start spoils only few of them.
size_t stride_of(std::span<const Pose> poses) {
  constexpr double kClearTurn = 0.2;  // rad
  constexpr size_t kPart = 16;        // of the animation
  const size_t most = std::max<size_t>(1, poses.size() / kPart);
  for (size_t stride = 1; stride < most; ++stride) {
    for (size_t i = stride; i < poses.size(); ++i) {
      const Quat q = conjugate(poses[i - stride].rotation) * poses[i].rotation;
      if (length(Vec3{q.x, q.y, q.z}) > std::sin(kClearTurn / 2)) return stride;
    }
  }
  return most;
}

std::vector<Bend> bends_of(std::span<const Pose> poses) {
  std::vector<Matrix3> turns;
  for (const Pose& pose : poses) turns.push_back(matrix_of(pose.rotation));
  const size_t stride = stride_of(poses);
  std::vector<Bend> bends;
  for (size_t i = stride; i + stride < poses.size(); ++i) {
    const size_t before = i - stride, after = i + stride;
    Bend bend;
    for (size_t r = 0; r < 3; ++r)
      bend.turn[r] = (turns[after][r] - turns[i][r]) - (turns[i][r] - turns[before][r]);
    bend.move = (poses[after].translation - poses[i].translation) -
                (poses[i].translation - poses[before].translation);
    bends.push_back(bend);
  }
  // Between two poses only, the first counts: a turn with fixed points has them where its difference is zero.
  if (poses.size() == 2) {
    Bend bend;
    for (size_t r = 0; r < 3; ++r) bend.turn[r] = turns[1][r] - turns[0][r];
    bend.move = poses[1].translation - poses[0].translation;
    bends.push_back(bend);
  }
  return bends;
}

// Scales bends so that each tells how far a point is from where it would vanish, in metres. A sharp bend,
// where a motion stops, must not outweigh the many where the body turns evenly. Those too weak to tell are
// left weak.
void scale_to_metres(std::vector<Bend>* bends) {
  constexpr double kWeak = 1e-4;  // of the strongest
  const auto strength = [](const Bend& bend) {
    return std::sqrt(length2(bend.turn[0]) + length2(bend.turn[1]) + length2(bend.turn[2]));
  };
  double strongest = 0;
  for (const Bend& bend : *bends) strongest = std::max(strongest, strength(bend));
  for (Bend& bend : *bends) {
    const double scale = 1 / std::max(strength(bend), kWeak * strongest + 1e-300);
    for (Vec3& row : bend.turn) row = scale * row;
    bend.move = scale * bend.move;
  }
}

// Solves (a + damping) x = b for a symmetric a that may be singular: along what it leaves open, x is 0.
Vec3 solve(Matrix3 a, Vec3 b, double damping) {
  for (int i = 0; i < 3; ++i) a[static_cast<size_t>(i)][i] += damping;
  const Vec3 x = cross(a[1], a[2]), y = cross(a[2], a[0]), z = cross(a[0], a[1]);
  const double determinant = dot(a[0], x);
  if (!(std::abs(determinant) > 0)) return {};
  return (b.x * x + b.y * y + b.z * z) / determinant;
}

}  // namespace

Vec3 pivot_of(std::span<const Pose> poses, Vec3 centre) {
  bool turns = false;
  for (const Pose& pose : poses) {
    const Vec3 v{pose.rotation.x, pose.rotation.y, pose.rotation.z};
    turns = turns || length2(v) > 1e-18;
  }
  std::vector<Bend> bends = bends_of(poses);
  scale_to_metres(&bends);
  if (!turns || bends.empty()) return {};
  // Least sum of lengths by least squares, reweighted (Weiszfeld 1937): a few sharp bends do not draw the
  // pivot from where all others vanish. Offsets from the centre are damped, which settles what the bends
  // leave open.
  constexpr int kRounds = 40;
  Vec3 offset;
  for (int round = 0; round < kRounds; ++round) {
    Matrix3 a{};
    Vec3 b;
    double trace = 0, largest = 0;
    for (const Bend& bend : bends) largest = std::max(largest, length(bend.at(centre)));
    for (const Bend& bend : bends) {
      const Vec3 at_centre = bend.at(centre);
      const double weight = 1 / std::max(length(bend.at(centre + offset)), 1e-12 * largest + 1e-300);
      for (size_t r = 0; r < 3; ++r) {
        const Vec3 row = bend.turn[r];
        const double rest = at_centre[static_cast<int>(r)];
        for (size_t i = 0; i < 3; ++i) a[i] += weight * row[static_cast<int>(i)] * row;
        b = b - weight * rest * row;
      }
    }
    for (int i = 0; i < 3; ++i) trace += a[static_cast<size_t>(i)][i];
    if (!(trace > 0)) return centre;
    offset = solve(a, b, 1e-13 * trace);
  }
  return centre + offset;
}

}  // namespace strad
