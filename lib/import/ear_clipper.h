// Cuts an outline in its own plane into triangles, by ear clipping (Meisters 1975).
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace strad {

// Corners are identified by their positions in the outline.
class EarClipper {
 public:
  EarClipper(std::vector<Vec2> points, double tolerance) : points_(std::move(points)), tolerance_(tolerance) {
    ring_.resize(points_.size());
    for (size_t i = 0; i < ring_.size(); ++i) ring_[i] = static_cast<int>(i);
    forget_states();
    drop_idle_corners();
  }
  const std::vector<int>& ring() const { return ring_; }
  // Whether what is left is convex, each corner by more than the tolerance.
  bool convex() const {
    for (size_t i = 0; i < ring_.size(); ++i)
      if (!(turn(i) > 0)) return false;
    return true;
  }
  // Cuts all of the ring into triangles; false if it crosses itself.
  bool clip(std::vector<std::array<int, 3>>* triangles);

 private:
  enum class Test {
    kClosed,
    kOpen
  };  // with kClosed, a corner on an edge of a triangle keeps it from being an ear

  size_t wrapped(size_t i) const { return i >= ring_.size() ? i - ring_.size() : i; }
  int at(size_t i) const { return ring_[wrapped(i)]; }
  int before(size_t i) const { return ring_[i == 0 ? ring_.size() - 1 : i - 1]; }
  Vec2 point(int corner) const { return points_[static_cast<size_t>(corner)]; }

  // Height of corner i over the line between its neighbours, positive where convex; 0 within the tolerance.
  double turn(size_t i) const;
  bool same(Vec2 a, Vec2 b) const;
  void drop(size_t i);
  void drop_idle_corners();
  void drop_idle_around(size_t i);
  bool blocks(size_t other, Vec2 a, Vec2 b, Vec2 c, Test test) const;
  bool is_ear(size_t i, Test test) const;
  double quality(size_t i) const;
  size_t best_ear(Test test);
  void forget_states() { state_.assign(points_.size(), kUnknown); }

  static constexpr double kUnknown = -1, kNoEar = 0;
  std::vector<Vec2> points_;
  std::vector<int> ring_;
  std::vector<double> state_;  // of a corner: unknown, no ear, or the quality of its ear
  double tolerance_;
};

}  // namespace strad
