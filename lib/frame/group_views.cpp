#include "frame/group_views.h"

#include <algorithm>
#include <cmath>

namespace strad {
namespace {

constexpr size_t kManyFacets = 16;
constexpr int kSide = 8;    // views along the side of a face of the cube: half angles of up to 10 degrees
constexpr double kFar = 3;  // radii: how far points must be
constexpr double kLeastCosine = 0.05;  // with which doubtful facets are sampled at least

// Where a direction goes through the cube: the face, and the place on it in [-1, 1]^2.
struct CubePoint {
  int face;
  double u, v;
};
CubePoint cube_point(Vec3 d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const double along = d[axis];
  return {2 * axis + (along > 0 ? 0 : 1), d[(axis + 1) % 3] / std::abs(along),
          d[(axis + 2) % 3] / std::abs(along)};
}
Vec3 direction_of(CubePoint at) {
  const int axis = at.face / 2;
  double d[3];
  d[axis] = at.face % 2 ? -1 : 1, d[(axis + 1) % 3] = at.u, d[(axis + 2) % 3] = at.v;
  return normalized(Vec3{d[0], d[1], d[2]});
}

struct FacetShape {
  Vec3 normal;
  double level, area;
};
FacetShape shape_of(const FacetMesh& group, size_t f) {
  const auto& c = group.corners[f];
  const auto at = [&](size_t i) { return group.vertices[c[i]]; };
  const Vec3 doubled =
      c[3] == kNone ? cross(at(1) - at(0), at(2) - at(0)) : cross(at(2) - at(0), at(3) - at(1));
  const Vec3 normal = normalized(doubled);
  return {normal, dot(normal, at(0)), length(doubled) / 2};
}

}  // namespace

GroupViews::GroupViews(const FacetMesh& group) {
  Box box;
  for (const Vec3 vertex : group.vertices) box.add(vertex);
  centre_ = box.centre();
  for (const Vec3 vertex : group.vertices) radius_ = std::max(radius_, length(vertex - centre_));
  if (group.corners.size() < kManyFacets) return;
  for (int face = 0; face < 6; ++face) {
    for (int v = 0; v < kSide; ++v) {
      for (int u = 0; u < kSide; ++u) {
        const auto place = [&](double i, double j) {
          return direction_of({face, 2 * (u + i) / kSide - 1, 2 * (v + j) / kSide - 1});
        };
        const Vec3 middle = place(0.5, 0.5);
        double half_angle = 0;
        for (int k = 0; k < 4; ++k)
          half_angle = std::max(half_angle, std::acos(std::min(1.0, dot(middle, place(k & 1, k >> 1)))));
        add_view(group, middle, half_angle);
      }
    }
  }
}

// The height of a point before a facet's plane is normal . (centre + r d) - level for a direction d of the
// cone and r of kFar radii or more: what the sign is at the ends of the cone and the least r holds beyond.
void GroupViews::add_view(const FacetMesh& group, Vec3 towards, double half_angle) {
  GroupView& view = views_.emplace_back();
  const size_t count = group.corners.size();
  std::vector<uint32_t> state(count + 1, ViewEdge::kBehind);
  const double margin = 1e-9 * radius_, nearest = kFar * radius_;
  double total = 0;
  for (uint32_t f = 0; f < count; ++f) {
    const FacetShape shape = shape_of(group, f);
    const double cosine = dot(shape.normal, towards), angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double from_centre = dot(shape.normal, centre_) - shape.level;
    const double least = std::cos(std::min(kPi, angle + half_angle)),
                 most = std::cos(std::max(0.0, angle - half_angle));
    if (most < 0 && nearest * most + from_centre < -margin) continue;
    if (least > 0 && nearest * least + from_centre > margin) {
      state[f] = ViewEdge::kBefore;
    } else {
      state[f] = static_cast<uint32_t>(view.doubtful.size()) + ViewEdge::kDoubtful;
      view.doubtful.push_back({shape.normal, shape.level});
    }
    view.facets.push_back(f);
    view.up_to.push_back(total += shape.area * std::max(kLeastCosine, cosine));
  }
  for (const GroupEdge& edge : group.edges) {
    const uint32_t left = state[edge.left], right = state[edge.right];
    if (left != right || left >= ViewEdge::kDoubtful) view.edges.push_back({edge.from, edge.to, left, right});
  }
}

const GroupView* GroupViews::from(Vec3 point) const {
  const Vec3 towards = point - centre_;
  if (views_.empty() || !(length2(towards) > kFar * kFar * radius_ * radius_)) return nullptr;
  const CubePoint at = cube_point(towards);
  const auto cell = [](double u) { return std::clamp(static_cast<int>((u + 1) / 2 * kSide), 0, kSide - 1); };
  return &views_[static_cast<size_t>((at.face * kSide + cell(at.v)) * kSide + cell(at.u))];
}

}  // namespace strad
