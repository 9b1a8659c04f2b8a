#include "solve/gather/receiver.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

Vec3 origin_of(const Receiver& receiver, int ray) {
  if (!receiver.spread) return receiver.position;
  // Other ratios than those of the directions, so that neither coordinate is in step with one of them: two
  // of the R4 sequence (Roberts 2018), powers of 1 / 1.1673.
  constexpr double kRatios[2] = {0.6287067210378087, 0.5385972572236101};
  constexpr double kRim = 0.002;  // not on the rim, where surfaces meet
  double xi[2];
  for (uint64_t i = 0; i < 2; ++i) {
    const double shifted = unit_from(mix64(receiver.seed + 2 + i)) + kRatios[i] * (ray + 1);
    xi[i] = kRim + (1 - 2 * kRim) * (shifted - std::floor(shifted));
  }
  return point_on_patch(receiver.patch, xi[0], xi[1]);
}

Receiver receiver_on(const NodeTree& tree, uint32_t face, Vec3 position, uint64_t seed, int rays) {
  const MeshBuilder& builder = tree.builder();
  Receiver receiver;
  receiver.position = position;
  receiver.normal = tree.face_normal(face);
  receiver.body = body_of(tree.scene(), tree.scene().polygons[builder.mesh().faces[face].polygon]);
  receiver.seed = seed;
  receiver.rays = static_cast<int>(builder.accuracy_share(face) * rays);
  return receiver;
}

Receiver receiver_of_face(const NodeTree& tree, uint32_t face, int rays) {
  Receiver receiver = receiver_on(tree, face, {}, hash_of(face, 2), rays);
  receiver.spread = true;
  receiver.patch = face_points(tree.scene(), tree.builder().mesh().faces[face]);
  return receiver;
}

// The part of an undivided face that is nearest to one of its vertices: the corner, the middles of the edges
// that meet there, and the middle of the face.
PatchPoints part_at_vertex(const NodeTree& tree, uint32_t face, uint32_t vertex) {
  const Face& f = tree.builder().mesh().faces[face];
  const PatchPoints points = face_points(tree.scene(), f);
  const uint32_t* vertices = tree.builder().mesh().elements[f.element].vertices;
  const int n = points.corner_count,
            c = static_cast<int>(std::find(vertices, vertices + n, vertex) - vertices);
  const Vec3 corner = points.corners[c];
  Vec3 middle;
  for (int i = 0; i < n; ++i) middle += points.corners[i] / n;
  return {{corner, lerp(corner, points.corners[(c + 1) % n], 0.5), middle,
           lerp(corner, points.corners[(c + n - 1) % n], 0.5)},
          4};
}

}  // namespace

Receiver receiver_of_vertex(const NodeTree& tree, uint32_t vertex, int rays) {
  const MeshBuilder& builder = tree.builder();
  const uint32_t face = builder.face_of_vertex(vertex);
  if (is_uniform(builder.mesh().elements[builder.mesh().faces[face].element]))
    return receiver_of_face(tree, face, rays);
  Receiver receiver = receiver_on(tree, face, builder.sample_point(vertex), hash_of(vertex), rays);
  const Face& f = builder.mesh().faces[face];
  const Vec2 uv = parametric_of(tree.scene(), tree.scene().polygons[f.polygon], receiver.position);
  const uint32_t leaf = tree.leaf_at(f.polygon, f.side, uv);
  if (leaf < tree.nodes().size()) receiver.node = leaf;
  if (vertex < builder.undivided_vertices()) {
    receiver.spread = true;
    receiver.patch = part_at_vertex(tree, face, vertex);
  }
  return receiver;
}

Receiver receiver_of_patch(const NodeTree& tree, uint32_t node, int rays) {
  const Node& patch = tree.nodes()[node];
  Receiver receiver = receiver_on(tree, patch.face, patch.centre, hash_of(patch.element, 1), rays);
  receiver.spread = true;
  receiver.patch = patch_points(tree, patch);
  receiver.node = node;
  if (patch.is_part) receiver.rays /= 4;  // as many as the four parts of a leaf had together
  return receiver;
}

Receiver receiver_of_leaf(const NodeTree& tree, uint32_t leaf, int rays) {
  const size_t nodes = tree.nodes().size();
  return leaf < nodes ? receiver_of_patch(tree, leaf, rays)
                      : receiver_of_face(tree, leaf - static_cast<uint32_t>(nodes), rays);
}

// R2 points on the disk (Malley 1988), shifted for each receiver.
std::vector<RestRay> rays_of(const Receiver& receiver, const DirectionDensity& density, int count,
                             double offset) {
  const double u0 = unit_from(mix64(receiver.seed)), v0 = unit_from(mix64(receiver.seed + 1));
  const Frame frame = frame_about(receiver.normal);
  const Vec3 lift = offset * receiver.normal;
  std::vector<RestRay> rays(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    float at = 1;
    const Point2 xi = density.warp(r2_point(static_cast<uint32_t>(i), u0, v0), &at);
    const double r = std::sqrt(xi.u), phi = 2 * kPi * xi.v;
    rays[static_cast<size_t>(i)] = {origin_of(receiver, i) + lift,
                                    r * std::cos(phi) * frame.tangent + r * std::sin(phi) * frame.bitangent +
                                        std::sqrt(std::max(0.0, 1 - xi.u)) * frame.normal,
                                    xi, 1 / at};
  }
  return rays;
}

}  // namespace strad
