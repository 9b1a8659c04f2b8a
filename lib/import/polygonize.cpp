// Polygons of any outline cut into planar convex pieces.
#include "import/polygonize.h"

#include <array>
#include <map>

namespace strad {
namespace {

// Lengths that are lost to rounding, from the outline's extent and the precision of its floats.
struct Tolerance {
  double point = 0;  // points closer than this are one
  double plane =
      0;  // points closer than this to a plane lie in it; a tenth of the offset at which rays start
};

Tolerance tolerance_of(std::span<const Vec3> outline) {
  Box box;
  for (const Vec3 p : outline) box.add(p);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, std::abs(box.lower[axis]), std::abs(box.upper[axis])});
  const double rounding = 0x1p-23 * largest;
  return {1e-7 * box.diagonal() + rounding, 1e-6 * box.diagonal() + 2 * rounding};
}

double length2d(Vec2 a) { return std::hypot(a.x, a.y); }

// Cuts an outline in its own plane. Corners are identified by their positions in the outline.
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
  double turn(size_t i) const {
    const Vec2 a = point(before(i)), b = point(at(i)), c = point(at(i + 1));
    const double base = std::max({length2d(c - a), length2d(b - a), length2d(c - b)});
    const double height = base > 0 ? cross2(b - a, c - a) / base : 0;
    return std::abs(height) > tolerance_ ? height : 0;
  }
  bool same(Vec2 a, Vec2 b) const { return length2d(a - b) <= tolerance_; }
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

bool planar(std::span<const Vec3> corners, double tolerance) {
  const Vec3 normal = normalized(doubled_area(corners));
  Vec3 centre;
  for (const Vec3 p : corners) centre += p;
  centre = centre / static_cast<double>(corners.size());
  return std::all_of(corners.begin(), corners.end(),
                     [&](Vec3 p) { return std::abs(dot(p - centre, normal)) <= tolerance; });
}

// The quality of a quad made of two triangles: 0 unless it is planar and convex, else the sine of its
// sharpest corner.
double quad_quality(std::span<const Vec3> outline, const OutlinePiece& quad, double tolerance) {
  std::array<Vec3, 4> p;
  for (size_t k = 0; k < 4; ++k) p[k] = outline[static_cast<size_t>(quad.corners[k])];
  if (!planar(p, tolerance)) return 0;
  const Vec3 normal = normalized(doubled_area(p));
  double sharpest = 1;
  for (size_t k = 0; k < 4; ++k) {
    const Vec3 in = normalized(p[k] - p[(k + 3) % 4]), out = normalized(p[(k + 1) % 4] - p[k]);
    sharpest = std::min(sharpest, dot(cross(in, out), normal));
  }
  // A quad with a corner of less than a third of a degree, or one that is nearly straight, stays two
  // triangles.
  return sharpest > 0.005 ? sharpest : 0;
}

struct Join {
  double quality;
  size_t first, second;
  OutlinePiece quad;
};

// The quad of two triangles that share the edge from corner k of `first`; empty unless they do.
OutlinePiece joined_over(const std::array<int, 3>& first, size_t k, const std::array<int, 3>& second) {
  for (size_t m = 0; m < 3; ++m) {
    const int tip = second[m];
    if (second[(m + 1) % 3] == first[(k + 1) % 3] && second[(m + 2) % 3] == first[k])
      return {{first[(k + 2) % 3], first[k], tip, first[(k + 1) % 3]}};
  }
  return {};
}

// Joins the best pairs first. Equal ones keep their order, so that the result is always the same.
void join_triangles(std::span<const Vec3> outline, const std::vector<std::array<int, 3>>& triangles,
                    double tolerance, std::vector<OutlinePiece>* pieces) {
  std::map<std::pair<int, int>, size_t> owner_of_edge;
  for (size_t t = 0; t < triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k) owner_of_edge.insert({{triangles[t][k], triangles[t][(k + 1) % 3]}, t});
  std::vector<Join> joins;
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const auto other = owner_of_edge.find({triangles[t][(k + 1) % 3], triangles[t][k]});
      if (other == owner_of_edge.end() || other->second <= t) continue;
      const OutlinePiece quad = joined_over(triangles[t], k, triangles[other->second]);
      if (const double quality = quad_quality(outline, quad, tolerance); quality > 0)
        joins.push_back({quality, t, other->second, quad});
    }
  }
  std::stable_sort(joins.begin(), joins.end(),
                   [](const Join& a, const Join& b) { return a.quality > b.quality; });
  std::vector<bool> taken(triangles.size());
  for (const Join& join : joins) {
    if (taken[join.first] || taken[join.second]) continue;
    taken[join.first] = taken[join.second] = true;
    pieces->push_back(join.quad);
  }
  for (size_t t = 0; t < triangles.size(); ++t)
    if (!taken[t]) pieces->push_back({{triangles[t][0], triangles[t][1], triangles[t][2], -1}});
}

std::vector<Vec2> flattened(std::span<const Vec3> outline, Vec3 normal) {
  const Frame frame = frame_about(normal);
  std::vector<Vec2> points;
  points.reserve(outline.size());
  for (const Vec3 p : outline)
    points.push_back({dot(p - outline[0], frame.tangent), dot(p - outline[0], frame.bitangent)});
  return points;
}

}  // namespace

Vec3 doubled_area(std::span<const Vec3> outline) {
  Vec3 sum;
  for (size_t i = 1; i + 1 < outline.size(); ++i)
    sum += cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return sum;
}

Outline polygonize(std::span<const Vec3> outline, std::vector<OutlinePiece>* pieces) {
  const Tolerance tolerance = tolerance_of(outline);
  const Vec3 area = doubled_area(outline);
  if (!(length(area) > tolerance.point * tolerance.point)) return Outline::kDegenerate;
  EarClipper clipper(flattened(outline, normalized(area)), tolerance.point);
  const std::vector<int> ring = clipper.ring();
  if (ring.empty()) return Outline::kDegenerate;
  if (ring.size() == 3) {
    pieces->push_back({{ring[0], ring[1], ring[2], -1}});
    return Outline::kWhole;
  }
  if (ring.size() == 4 && clipper.convex()) {
    const OutlinePiece quad{{ring[0], ring[1], ring[2], ring[3]}};
    if (quad_quality(outline, quad, tolerance.plane) > 0) {
      pieces->push_back(quad);
      return Outline::kWhole;
    }
  }
  std::vector<std::array<int, 3>> triangles;
  const bool whole = clipper.clip(&triangles);
  join_triangles(outline, triangles, tolerance.plane, pieces);
  return whole ? Outline::kWhole : Outline::kCrossing;
}

}  // namespace strad
