#include "solve/mesh/face_kinds.h"

#include <algorithm>
#include <unordered_map>

#include "base/disjoint_sets.h"

namespace strad {
namespace {

// Small faces in one plane are treated as one large face if they have no more corners per face than this.
constexpr double kCornersAFace = 1.25;

// Polygons smaller than `small` of which at least half the edges lead to a neighbour at a small angle.
std::vector<bool> curved_polygons(const Scene& scene, const PolygonJoints& joints, double small) {
  std::unordered_map<uint64_t, uint32_t> first_user;  // of an edge; looked up only, never iterated
  std::vector<int> continued(scene.polygons.size(), 0);
  for (uint32_t i = 0; i < scene.polygons.size(); ++i) {
    const Polygon& p = scene.polygons[i];
    if (!(longest_edge(scene, p) < small)) continue;
    for (int c = 0; c < p.corner_count(); ++c) {
      const auto [it, added] = first_user.try_emplace(joints.edge(i, c), i);
      if (added || !joints.continues(i, it->second)) continue;
      ++continued[i], ++continued[it->second];
    }
  }
  std::vector<bool> curved(continued.size());
  for (uint32_t i = 0; i < continued.size(); ++i)
    curved[i] = 2 * continued[i] >= scene.polygons[i].corner_count();
  return curved;
}

// Of the small sides, those that are not treated as parts of one large face in their plane. Small sides in
// one plane that share corners, here called a flat, are treated alike. Otherwise those at its rim would
// differ.
std::vector<bool> sides_in_no_flat(const Scene& scene, const PolygonJoints& joints,
                                   const std::vector<bool>& is_small) {
  const auto sides = static_cast<uint32_t>(is_small.size());
  std::unordered_map<CornerKey, uint32_t, CornerHash> first_user;  // looked up only, never iterated
  DisjointSets flats(sides);
  std::vector<uint32_t> new_corners(sides, 0);
  for (uint32_t s = 0; s < sides; ++s) {
    if (!is_small[s]) continue;
    for (int c = 0; c < scene.polygons[s / 2].corner_count(); ++c) {
      const auto [it, added] = first_user.try_emplace(joints.corner(s / 2, s % 2, c), s);
      if (added)
        ++new_corners[s];
      else
        flats.join(s, it->second);
    }
  }
  std::vector<uint32_t> polygons(sides, 0), corners(sides, 0);  // of a flat, by its lowest side
  for (uint32_t s = 0; s < sides; ++s) {
    if (!is_small[s]) continue;
    ++polygons[flats.find(s)];
    corners[flats.find(s)] += new_corners[s];
  }
  std::vector<bool> in_none(sides, false);
  for (uint32_t s = 0; s < sides; ++s) {
    const uint32_t flat = flats.find(s);
    in_none[s] = is_small[s] && !(corners[flat] <= kCornersAFace * polygons[flat]);
  }
  return in_none;
}

}  // namespace

double longest_edge(const Scene& scene, const Polygon& polygon) {
  double longest = 0;
  const int n = polygon.corner_count();
  for (int c = 0; c < n; ++c)
    longest = std::max(
        longest, length(scene.vertices[polygon.corners[(c + 1) % n]] - scene.vertices[polygon.corners[c]]));
  return longest;
}

FaceKinds face_kinds(const Scene& scene, const PolygonJoints& joints, const std::vector<bool>& reached,
                     double small) {
  const auto sides = static_cast<uint32_t>(reached.size());
  const auto edge_of = [&](uint32_t side) { return longest_edge(scene, scene.polygons[side / 2]); };
  std::vector<bool> is_small(sides);
  for (uint32_t s = 0; s < sides; ++s) is_small[s] = reached[s] && edge_of(s) < small;
  const std::vector<bool> in_no_flat = sides_in_no_flat(scene, joints, is_small);
  const std::vector<bool> curved = curved_polygons(scene, joints, small);
  FaceKinds kinds;
  for (uint32_t s = 0; s < sides; ++s) {
    if (!reached[s]) continue;
    if (!in_no_flat[s]) {
      kinds.divided.push_back(s);
    } else if (curved[s / 2] || edge_of(s) < small / 2) {
      kinds.uniform.push_back(s);
    } else {
      kinds.undivided.push_back(s);
    }
  }
  return kinds;
}

}  // namespace strad
