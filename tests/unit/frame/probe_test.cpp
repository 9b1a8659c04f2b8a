// Light at single points, and the table of them.
#include "frame/probe.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "frame/probe_text.h"
#include "synthetic.h"

namespace strad {
namespace {

Scene room() {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {4, 3, 2}, {0.5f, 0.5f, 0.5f}, {});
  return scene;
}

TEST(Probe, NearestPointAndItsSide) {
  const Scene scene = room();  // polygon 0 is the floor, 3 the wall x = 4
  const ProbePoint floor = nearest_point(scene, {{1, 2, 0.3}, {}});
  EXPECT_EQ(floor.polygon, 0u);
  EXPECT_TRUE(floor.front);
  EXPECT_NEAR(length(floor.rest_point - Vec3{1, 2, 0}), 0, 1e-12);
  EXPECT_FALSE(nearest_point(scene, {{1, 2, 0.3}, Vec3{0, 0, -1}}).front);
  EXPECT_EQ(nearest_point(scene, {{9, 1, 1}, {}}).polygon, 3u);
}

TEST(Probe, NormalChoosesAmongEquallyNear) {
  const Scene scene = room();
  const Vec3 on_edge{4, 1, 0};  // of floor and wall
  EXPECT_EQ(nearest_point(scene, {on_edge, Vec3{0, 0, 1}}).polygon, 0u);
  EXPECT_EQ(nearest_point(scene, {on_edge, Vec3{-1, 0, 0}}).polygon, 3u);
}

TEST(Probe, NearestOfTrianglesInAllRegions) {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  scene.materials.push_back({});
  scene.objects.push_back({"triangle", 0});
  scene.polygons.push_back({{0, 1, 2, kNone}, {kNone, kNone, kNone, kNone}, 0, 0});
  const auto nearest = [&](Vec3 p) { return nearest_point(scene, {p, {}}).rest_point; };
  EXPECT_EQ(nearest({1, 1, 5}), (Vec3{1, 1, 0}));
  EXPECT_EQ(nearest({-1, -1, 1}), (Vec3{0, 0, 0}));
  EXPECT_EQ(nearest({6, -1, 0}), (Vec3{4, 0, 0}));
  EXPECT_EQ(nearest({-1, 6, 0}), (Vec3{0, 4, 0}));
  EXPECT_EQ(nearest({2, -3, 1}), (Vec3{2, 0, 0}));
  EXPECT_EQ(nearest({-3, 2, 1}), (Vec3{0, 2, 0}));
  EXPECT_EQ(nearest({4, 4, 0}), (Vec3{2, 2, 0}));
}

TEST(Probe, SolutionIsInterpolated) {
  const Scene scene = room();
  const Slab slab = plain_slab(scene, 0, 1, [](Vec3 p) {
    const float e = static_cast<float>(p.x + 2 * p.y);
    return Rgb{e, 2 * e, 0};
  });
  Probe probe(scene, {nearest_point(scene, {{1, 2, 0}, {}})}, {});
  const ProbeValue value = probe.at(slab, 0.5).front();
  EXPECT_NEAR(value.irradiance.r, 5, 1e-5);
  EXPECT_NEAR(value.irradiance.g, 10, 1e-5);
  EXPECT_NEAR(value.radiance.r, 0.5 * 5 / kPi, 1e-6);
}

// A square lamp of half side 1, 2 m over the floor: see lights_test.
TEST(Probe, DirectLightIsExactAndCanBeLeftOut) {
  Scene scene;
  add_quad(&scene, {-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {1, 1, 1});
  add_quad(&scene, {-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {}, {3, 3, 3});
  const Slab slab = even_slab(scene, {0.25f, 0.25f, 0.25f});
  const ProbePoint under = nearest_point(scene, {{0, 0, 0}, {}});
  const double r = 0.5 / std::sqrt(1.25), direct = 3 * 4 * r * std::atan(r);
  const auto irradiance = [&](ProbeDirect from) {
    return Probe(scene, {under}, {from, false}).at(slab, 0).front().irradiance.r;
  };
  EXPECT_NEAR(irradiance(ProbeDirect::kPoint), direct + 0.25, 1e-5);
  EXPECT_NEAR(irradiance(ProbeDirect::kMesh), 0.25, 1e-6);  // the mesh has none
  EXPECT_NEAR(irradiance(ProbeDirect::kNone), 0.25, 1e-6);
}

TEST(Probe, FollowsItsBody) {
  Scene scene;
  scene.end = 1;
  add_quad(&scene, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {1, 1, 1});
  scene.bodies.push_back({});
  scene.bodies.back().keys = {{0, {0, 0, 0}, 0, false, {}}, {1, {0, 0, 1}, 0, false, {}}};
  scene.objects.back().body = 1;
  scene.spots.push_back({"key", 0, 1, 1.2, {{0, {0, 0, 3}, {0, 0, 0}, {9, 9, 9}}}});
  const Slab slab = even_slab(scene, {});
  Probe probe(scene, {nearest_point(scene, {{0, 0, 0}, {}})}, {});
  EXPECT_NEAR(probe.at(slab, 0).front().irradiance.r, 9 / 9.0, 1e-5);
  EXPECT_NEAR(probe.at(slab, 1).front().irradiance.r, 9 / 4.0, 1e-5);  // 1 m nearer
}

TEST(ProbeText, Queries) {
  EXPECT_EQ(parse_probe("--at", "1,2.5,-3").position, (Vec3{1, 2.5, -3}));
  EXPECT_FALSE(parse_probe("--at", "1,2,3").normal.has_value());
  EXPECT_EQ(*parse_probe("--at", "1,2,3,0,0,-2").normal, (Vec3{0, 0, -1}));
  for (const char* text :
       {"", "1,2", "1,2,3,4", "1,2,3,0,0,0", "1,2,x", "1,,2,3", "1,2,nan", "1,2,3,", "1 2 3"}) {
    EXPECT_THROW(parse_probe("--at", text), BadInput) << text;
  }
}

TEST(ProbeText, FilesOfPoints) {
  const auto queries = parse_probes("points", "# a comment\n1 2 3\n\n 4,5,6\t0,0,1 # on top\r\n");
  ASSERT_EQ(queries.size(), 2u);
  EXPECT_EQ(queries[1].position, (Vec3{4, 5, 6}));
  EXPECT_TRUE(queries[1].normal.has_value());
  try {
    parse_probes("points", "1 2 3\n4 5\n");
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_STREQ(fault.what(), "points:2: found 2 numbers, expected X,Y,Z or X,Y,Z,NX,NY,NZ");
  }
}

TEST(ProbeText, Rows) {
  EXPECT_EQ(probe_header(), "time\tpoint\tobject\tr\tg\tb\ter\teg\teb\n");
  const ProbeValue value{{0.5f, 1, 2}, {3, 4, 0.125f}};
  EXPECT_EQ(probe_row(0.04, 2, "left\twall 1\\", value),
            "0.04\t2\tleft\\011wall\\0401\\134\t0.5\t1\t2\t3\t4\t0.125\n");
}

}  // namespace
}  // namespace strad
