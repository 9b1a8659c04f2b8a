// The hierarchy as it is split: every face in one place, areas and lobes kept, samples on surfaces.
#include "solve/links/nodes.h"

#include <gtest/gtest.h>

#include <set>

#include "base/rng.h"
#include "workbench.h"

namespace strad {
namespace {

// A floor, a plate that leans on it, and 60 small boxes on the world; 27 boxes on a body that moves.
Scene clutter() {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}});
  add_polygon(&scene, {{0.5, 2.5, 0}, {3.5, 2.5, 0}, {2.5, 3, 1.5}});
  for (uint64_t i = 0; i < 60; ++i) {
    const auto random = [&](uint64_t k) { return unit_from(hash_of(i, k)); };
    const Vec3 l{3.8 * random(1), 2.8 * random(2), 0.5 * random(3)};
    add_box(&scene, l, l + Vec3{0.02 + 0.1 * random(4), 0.02 + 0.1 * random(5), 0.02 + 0.1 * random(6)},
            false);
  }
  add_boxes(&scene, {1, 1, 1}, {2, 2, 2}, 3, 0.5, add_body(&scene, {1, 0, 0}));
  return scene;
}

struct Clutter : Workbench {
  Clutter() : Workbench(clutter(), 1, 1, Roots::kClusters) {}
  std::multiset<uint32_t> faces_of(const Node& node) const {
    if (!node.is_cluster()) return {node.face};
    const Cluster& cluster = nodes->cluster(node);
    const auto first = nodes->cluster_faces().begin() + cluster.first_face;
    return {first, first + cluster.face_count};
  }
};

Box box_of(const Workbench& bench, uint32_t face) {
  const PatchPoints points = face_points(bench.scene, bench.builder.mesh().faces[face]);
  Box box;
  for (int c = 0; c < points.corner_count; ++c) box.add(points.corners[c]);
  return box;
}
double largest_extent(const Box& box) {
  const Vec3 size = box.upper - box.lower;
  return std::max({size.x, size.y, size.z});
}

TEST(Nodes, StartsWithAClusterABody) {
  const Clutter bench;
  ASSERT_EQ(bench.nodes->nodes().size(), 2u);
  EXPECT_EQ(bench.cluster(0).face_count, 2u + 360);
  EXPECT_EQ(bench.cluster(1).face_count, 27u * 6);
  EXPECT_EQ(bench.node(0).body, 0u);
  EXPECT_EQ(bench.node(1).body, 1u);
  EXPECT_EQ(bench.nodes->slot_count(), 2u * kLobes);
}

TEST(Nodes, FacesWithoutClusters) {
  const Workbench bench(clutter(), 1, 1, Roots::kFaces);
  const size_t faces = bench.builder.mesh().faces.size();
  ASSERT_EQ(bench.nodes->nodes().size(), faces);
  for (uint32_t f = 0; f < faces; ++f) EXPECT_EQ(bench.nodes->node_of_face(f), f);
  EXPECT_EQ(bench.nodes->cluster_count(), 0u);
}

// However far it is split, in whatever order: the children of a cluster share its faces, each goes to one.
TEST(Nodes, SplittingKeepsEveryFaceOnce) {
  Clutter bench;
  for (uint32_t n = 0; n < bench.nodes->nodes().size(); ++n) {
    if (!bench.node(n).is_cluster()) continue;
    const std::multiset<uint32_t> before = bench.faces_of(bench.node(n));
    std::multiset<uint32_t> after;
    for (const uint32_t child : bench.children_of(n)) {
      EXPECT_EQ(bench.node(child).parent, n);
      EXPECT_EQ(bench.node(child).body, bench.node(n).body);
      after.merge(bench.faces_of(bench.node(child)));
    }
    EXPECT_EQ(after, before) << n;
    EXPECT_GT(bench.node(n).child_count, 1u);
    // Where the faces are, after each step.
    for (uint32_t f = 0; f < bench.builder.mesh().faces.size(); ++f) {
      const Node& holder = bench.node(bench.nodes->node_of_face(f));
      EXPECT_TRUE(holder.is_leaf());
      EXPECT_EQ(bench.faces_of(holder).count(f), 1u);
    }
  }
  std::set<uint32_t> patches;
  for (const Node& node : bench.nodes->nodes())
    if (!node.is_cluster()) patches.insert(node.face);
  EXPECT_EQ(patches.size(), bench.builder.mesh().faces.size());  // at the end each is a patch of its own
  std::set<uint32_t> slots;
  for (const Node& node : bench.nodes->nodes()) slots.insert(node.slot);
  EXPECT_EQ(slots.size(), bench.nodes->nodes().size());
}

TEST(Nodes, AreasAndLobesOfChildrenAddUp) {
  Clutter bench;
  bench.split_clusters();
  for (const Node& node : bench.nodes->nodes()) {
    if (!node.is_cluster()) continue;
    const Cluster& cluster = bench.nodes->cluster(node);
    double area = 0, lobes[kLobes] = {}, shares = 0;
    Rgb reflectance;
    for (uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const Node& child = bench.node(c);
      area += static_cast<double>(child.area);
      reflectance += (child.area / node.area) * child.reflectance;
      if (child.is_cluster()) {
        for (int l = 0; l < kLobes; ++l)
          lobes[l] += static_cast<double>(child.area * bench.nodes->cluster(child).lobe_share[l]);
      } else {
        const LobeWeights w = lobes_of_normal(child.normal);
        for (int l = 0; l < 3; ++l) lobes[w.lobe[l]] += static_cast<double>(child.area * w.weight[l]);
      }
    }
    EXPECT_NEAR(area, node.area, 1e-5 * node.area);
    EXPECT_NEAR(reflectance.g, node.reflectance.g, 1e-5);
    for (int l = 0; l < kLobes; ++l) {
      EXPECT_NEAR(lobes[l], cluster.lobe_share[l] * node.area, 1e-5 * node.area);
      shares += static_cast<double>(cluster.lobe_share[l]);
    }
    EXPECT_NEAR(shares, 1, 1e-5);
  }
}

// Christensen's octree: a face goes to the octant of its centre unless it is larger than an octant, or alone
// there.
TEST(Nodes, LargeFacesStayWithTheirParent) {
  Clutter bench;
  bench.split_clusters();
  int large = 0, clusters = 0;
  for (const Node& node : bench.nodes->nodes()) {
    if (!node.is_cluster()) continue;
    const Cluster& cluster = bench.nodes->cluster(node);
    const double octant = 0.5 * largest_extent(cluster.box);
    const Vec3 middle = cluster.box.centre();
    for (uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const Node& child = bench.node(c);
      if (!child.is_cluster()) {
        large += largest_extent(box_of(bench, child.face)) > octant;
        continue;
      }
      ++clusters;
      EXPECT_GT(cluster.face_count, 8u);  // so few stay flat
      std::set<int> octants;
      for (const uint32_t face : bench.faces_of(child)) {
        const Box box = box_of(bench, face);
        EXPECT_LE(largest_extent(box), octant);
        const Vec3 at = box.centre() - middle;
        octants.insert((at.x > 0) + 2 * (at.y > 0) + 4 * (at.z > 0));
      }
      EXPECT_EQ(octants.size(), 1u);
      EXPECT_LT(largest_extent(bench.nodes->cluster(child).box),
                2 * octant + 1e-9);  // tight, not of the octant
    }
  }
  EXPECT_GT(clusters, 20);
  EXPECT_GE(large, 2);
  // The floor and the plate are children of the root.
  for (uint32_t polygon = 0; polygon < 2; ++polygon)
    EXPECT_EQ(bench.node(bench.nodes->node_of_face(polygon)).parent, 0u);
}

TEST(Nodes, FacesAtOnePlaceComeToAnEnd) {
  Scene scene;
  scene.end = 1;
  for (int i = 0; i < 50; ++i) add_polygon(&scene, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});  // no area, no extent
  for (int i = 0; i < 50; ++i) add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  Workbench bench(scene, 1, 1, Roots::kClusters);
  bench.split_clusters();
  EXPECT_EQ(leaves_below(*bench.nodes, 0).size(), 100u);
  for (const Node& node : bench.nodes->nodes()) EXPECT_TRUE(std::isfinite(node.centre.x) && node.area >= 0);
}

TEST(Nodes, SpheresHoldTheirNodes) {
  Clutter bench;
  bench.split_clusters();
  for (const Node& node : bench.nodes->nodes())
    for (const uint32_t face : bench.faces_of(node)) {
      const PatchPoints points = face_points(bench.scene, bench.builder.mesh().faces[face]);
      for (int c = 0; c < points.corner_count; ++c)
        EXPECT_LE(length(points.corners[c] - node.centre), static_cast<double>(node.radius) * 1.000001);
    }
}

// Is a point on a face, but for rounding?
bool is_on(const Workbench& bench, uint32_t face, const SurfaceSample& sample) {
  const Vec3 normal = bench.nodes->face_normal(face);
  const PatchPoints p = face_points(bench.scene, bench.builder.mesh().faces[face]);
  if (dot(normal, sample.normal) < 0.999999) return false;
  if (std::abs(dot(sample.position - p.corners[0], normal)) > 1e-9) return false;
  for (int c = 0; c < p.corner_count; ++c) {
    const Vec3 edge = p.corners[(c + 1) % p.corner_count] - p.corners[c];
    if (dot(cross(normal, edge), sample.position - p.corners[c]) < -1e-9) return false;
  }
  return true;
}

TEST(Nodes, SamplesLieOnSurfacesOfTheirCluster) {
  Clutter bench;
  bench.split_clusters();
  for (const Node& node : bench.nodes->nodes()) {
    if (!node.is_cluster()) continue;
    const Cluster& cluster = bench.nodes->cluster(node);
    const std::multiset<uint32_t> faces = bench.faces_of(node);
    for (const SurfaceSample& sample : cluster.samples) {
      EXPECT_TRUE(
          std::any_of(faces.begin(), faces.end(), [&](uint32_t f) { return is_on(bench, f, sample); }));
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(sample.position[axis], cluster.box.lower[axis] - 1e-9);
        EXPECT_LE(sample.position[axis], cluster.box.upper[axis] + 1e-9);
      }
    }
  }
}

// Three quarters of the area have three quarters of the samples.
TEST(Nodes, SamplesAreSharedByArea) {
  Scene scene;
  scene.end = 1;
  add_polygon(&scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_polygon(&scene, {{0, 0, 5}, {3, 0, 5}, {3, 1, 5}, {0, 1, 5}});
  const Workbench bench(scene, 1, 1, Roots::kClusters);
  int high = 0;
  for (const SurfaceSample& sample : bench.cluster(0).samples) high += sample.position.z > 2;
  EXPECT_EQ(high, 3 * Cluster::kSamples / 4);
}

TEST(Nodes, LightsArePatchesOrFacesOfClusters) {
  Clutter bench;
  const Vec2 at{0.1, 0.1};  // on the floor
  const auto light = [&] { return bench.nodes->leaf_at(0, 0, at); };
  EXPECT_EQ(light(), bench.nodes->nodes().size());  // face 0, in a cluster
  EXPECT_EQ(bench.nodes->leaf_at(7, 0, {}), bench.nodes->nodes().size() + 7);
  EXPECT_EQ(bench.nodes->leaf_at(0, 1, at), kNone);  // that side has no face
  bench.children_of(0);
  const uint32_t floor = bench.nodes->node_of_face(0);
  EXPECT_EQ(light(), floor);
  bench.leaves_of(floor, 2);
  const Node& patch = bench.node(light());
  EXPECT_TRUE(patch.is_leaf());
  EXPECT_NEAR(patch.area, 12.0 / 16, 1e-6);
  EXPECT_NEAR(patch.centre.x, 0.5, 1e-9);  // the quarter of a quarter that holds the point
  EXPECT_NEAR(patch.centre.y, 0.375, 1e-9);
  EXPECT_EQ(bench.nodes->leaf_count(), bench.nodes->nodes().size() + bench.builder.mesh().faces.size());
}

}  // namespace
}  // namespace strad
