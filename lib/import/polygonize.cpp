// Polygons of any outline cut into planar convex pieces.
#include "import/polygonize.h"

#include <algorithm>
#include <array>
#include <map>

#include "import/ear_clipper.h"

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
