// What may be seen of an emitter group of many facets from afar, by direction. So the cost of its light grows
// with the edges of its outline, not with the number of its facets.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "frame/facet_mesh.h"

namespace strad {

// An edge that may lie on the outline; its facets as places in GroupView::doubtful plus kDoubtful, or one of
// the other two.
struct ViewEdge {
  static constexpr uint32_t kBehind = 0, kBefore = 1, kDoubtful = 2;
  uint32_t from = 0, to = 0;  // vertices of the group
  uint32_t left = kBehind, right = kBehind;
};

// The group from any point of a cone of directions that is far enough.
struct GroupView {
  struct Plane {
    Vec3 normal;  // rest
    double level = 0;
  };
  std::vector<Plane> doubtful;  // of facets that emit to some points of the cone only
  std::vector<ViewEdge> edges;
  std::vector<uint32_t> facets;  // all that emit to some point of it, in the order of the group
  std::vector<double> up_to;     // per entry of `facets`: estimated irradiance from it and all before it
};

class GroupViews {
 public:
  GroupViews() = default;
  // Only of a group with so many facets that views save time; others have none.
  explicit GroupViews(const FacetMesh& group);

  // The view of the group from `point`, rest; nullptr where there is none, or the point is too near.
  const GroupView* from(Vec3 point) const;

  // A sphere about the group, rest.
  Vec3 centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  void add_view(const FacetMesh& group, Vec3 towards, double half_angle);

  Vec3 centre_;
  double radius_ = 0;
  std::vector<GroupView> views_;  // kSide x kSide on each face of a cube about the group
};

}  // namespace strad
