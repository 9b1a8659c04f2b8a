#include "import/ear_clipper.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

double length2d(Vec2 a) { return std::hypot(a.x, a.y); }

}  // namespace

double EarClipper::turn(size_t i) const {
  const Vec2 a = point(before(i)), b = point(at(i)), c = point(at(i + 1));
  const double base = std::max({length2d(c - a), length2d(b - a), length2d(c - b)});
  const double height = base > 0 ? cross2(b - a, c - a) / base : 0;
  return std::abs(height) > tolerance_ ? height : 0;
}

bool EarClipper::same(Vec2 a, Vec2 b) const { return length2d(a - b) <= tolerance_; }

// Drops corners that repeat their neighbour, lie on a straight edge or are the tip of a spike of no area.
void EarClipper::drop_idle_corners() {
  for (size_t i = 0, kept = 0; kept < ring_.size() && ring_.size() >= 3;) {
    i = wrapped(i);
    if (turn(i) != 0) {
      ++i, ++kept;
      continue;
    }
    drop(i);
    i = i > 0 ? i - 1 : ring_.size() - 1;
    kept = kept > 2 ? kept - 2 : 0;  // the corners on both sides must be looked at again
  }
  if (ring_.size() < 3) ring_.clear();
}

void EarClipper::drop(size_t i) {
  state_[static_cast<size_t>(before(i))] = state_[static_cast<size_t>(at(i + 1))] = kUnknown;
  ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
}

// Whether the corner `other` of the ring, or an edge from it, reaches into the triangle.
bool EarClipper::blocks(size_t other, Vec2 a, Vec2 b, Vec2 c, Test test) const {
  const Vec2 p = point(at(other));
  const std::array<Vec2, 3> triangle{a, b, c};
  for (size_t k = 0; k < 3; ++k) {
    if (!same(p, triangle[k])) continue;
    // `other` is at a corner of the triangle, where a bridge passes. Its edges must not lead into the
    // triangle.
    const Vec2 to_next = triangle[(k + 1) % 3] - triangle[k], to_last = triangle[(k + 2) % 3] - triangle[k];
    for (const int neighbour : {before(other), at(other + 1)}) {
      const Vec2 along = point(neighbour) - p;
      const double slack = tolerance_ * length2d(along);
      if (cross2(to_next, along) > slack && cross2(along, to_last) > slack) return true;
    }
    return false;
  }
  const double rim = test == Test::kClosed ? -tolerance_ : tolerance_;
  for (size_t k = 0; k < 3; ++k) {
    const Vec2 edge = triangle[(k + 1) % 3] - triangle[k];
    if (!(cross2(edge, p - triangle[k]) > rim * length2d(edge))) return false;
  }
  return true;
}

bool EarClipper::is_ear(size_t i, Test test) const {
  if (!(turn(i) > 0)) return false;
  const Vec2 a = point(before(i)), b = point(at(i)), c = point(at(i + 1));
  const size_t previous = i == 0 ? ring_.size() - 1 : i - 1, next = wrapped(i + 1);
  for (size_t j = 0; j < ring_.size(); ++j) {
    if (j == i || j == previous || j == next || turn(j) > 0)
      continue;  // if any corner is inside, a reflex corner is
    if (blocks(j, a, b, c, test)) return false;
  }
  return true;
}

// Sine of the ear's smallest angle: long thin triangles come last.
double EarClipper::quality(size_t i) const {
  const Vec2 a = point(before(i)), b = point(at(i)), c = point(at(i + 1));
  const double doubled = cross2(b - a, c - a);
  const double ab = length2d(b - a), bc = length2d(c - b), ca = length2d(a - c);
  return doubled / std::max({ab * bc, bc * ca, ca * ab});
}

size_t EarClipper::best_ear(Test test) {
  size_t best = ring_.size();
  double best_quality = kNoEar;
  for (size_t i = 0; i < ring_.size(); ++i) {
    double& state = state_[static_cast<size_t>(ring_[i])];
    if (state == kUnknown) state = is_ear(i, test) ? quality(i) : kNoEar;
    if (state > best_quality) best_quality = state, best = i;
  }
  return best;
}

bool EarClipper::clip(std::vector<std::array<int, 3>>* triangles) {
  while (ring_.size() > 3) {
    size_t ear = best_ear(Test::kClosed);
    if (ear == ring_.size()) forget_states(), ear = best_ear(Test::kClosed);
    if (ear == ring_.size()) forget_states(), ear = best_ear(Test::kOpen);
    if (ear == ring_.size()) return false;
    triangles->push_back({before(ear), ring_[ear], at(ear + 1)});
    drop(ear);
    drop_idle_around(ear);
  }
  if (ring_.size() == 3 && convex()) triangles->push_back({ring_[0], ring_[1], ring_[2]});
  return ring_.empty() || convex();
}

// After a cut the two corners beside it may have become needless, then their neighbours.
void EarClipper::drop_idle_around(size_t i) {
  while (ring_.size() >= 3) {
    const size_t next = wrapped(i), last = next == 0 ? ring_.size() - 1 : next - 1;
    if (turn(next) == 0) {
      drop(next);
    } else if (turn(last) == 0) {
      drop(last);
      i = last;
    } else {
      return;
    }
  }
  ring_.clear();
}

}  // namespace strad
