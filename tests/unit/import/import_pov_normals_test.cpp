// Round objects of POV-Ray are smooth, whole or cut: their normals are those of the surface that they stand
// for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "import_folder.h"
#include "scene_measures.h"

namespace strad {
namespace {

using ImportPovNormals = ImportPovFolder;

TEST_F(ImportPovNormals, round_objects_are_smooth) {
  // An ellipsoid x^2 + (y / 2)^2 + z^2 = 1: its normal at p is along (x, y / 4, z).
  const Scene egg = import(kKept + "sphere { 0, 1 scale <1, 2, 1> pigment { rgb 1 } }");
  EXPECT_FALSE(egg.normals.empty());
  EXPECT_LT(worst_normal(egg, [](Vec3 p) { return Vec3{p.x, p.y / 4, p.z}; }), 1e-4);
  // A cylinder's lids stay flat, and its sides point away from the axis.
  const Scene column = import(kKept + "cylinder { 0, 3*y, 1 pigment { rgb 1 } }");
  EXPECT_LT(worst_normal(column, [](Vec3 p) { return Vec3{p.x, 0, p.z}; }), 1e-4);
  EXPECT_TRUE(std::any_of(column.polygons.begin(), column.polygons.end(),
                          [](const Polygon& p) { return !p.is_smooth(); }));
  // A cone from radius 2 to 1 over a height of 1 has a slope of 45 degrees.
  const Scene cone = import(kKept + "cone { 0, 2, y, 1 open pigment { rgb 1 } }");
  EXPECT_LT(worst_normal(cone, [](Vec3 p) { return normalized(Vec3{p.x, 0, p.z}) + Vec3{0, 1, 0}; }), 1e-4);
}

// A ball's normals point away from its middle; as the wall of a hole they point to it. Where its facets are
// cut, the normal at a new corner is the mean of those around it, weighted as its position is: on a ball of
// flat facets that is exactly the direction from the middle.
TEST_F(ImportPovNormals, what_is_cut_from_round_objects_stays_smooth) {
  const double tolerance = 1e-4;  // radians, as precise as a stream keeps normals
  const auto flat_off_cut = [](const Scene& scene) {
    return std::count_if(scene.polygons.begin(), scene.polygons.end(), [&](const Polygon& polygon) {
      bool in_cut = true;
      for (int c = 0; c < polygon.corner_count(); ++c)
        in_cut = in_cut && std::abs(scene.vertices[polygon.corners[c]].y - 0.1) < 1e-6;
      return !polygon.is_smooth() && !in_cut;
    });
  };
  const Scene half = import(kKept + "intersection { sphere { 0, 1 } plane { -y, -0.1 } pigment { rgb 1 } }");
  EXPECT_FALSE(half.normals.empty());
  EXPECT_LT(worst_normal(half, [](Vec3 p) { return p; }), tolerance);
  EXPECT_EQ(flat_off_cut(half), 0);
  const Scene hole = import(kKept +
                            "difference { plane { y, 0.1 } sphere { 0, 1 } clipped_by { sphere { 0, 1.5 } }"
                            " pigment { rgb 1 } }");
  EXPECT_FALSE(hole.normals.empty());
  EXPECT_LT(worst_normal(hole, [](Vec3 p) { return -p; }), tolerance);
  EXPECT_EQ(flat_off_cut(hole), 0);
  // Across the axis, at an angle, and clipped: a column's normals point from its axis.
  const Scene column = import(kKept +
                              "difference { cylinder { -2*y, 2*y, 1 open } box { 0, 3 rotate <20, 30, 40> }"
                              " clipped_by { sphere { 0, 1.7 } } pigment { rgb 1 } }");
  EXPECT_FALSE(column.normals.empty());
  double worst = 0;
  for (const Polygon& polygon : column.polygons)
    for (int c = 0; polygon.is_smooth() && c < polygon.corner_count(); ++c) {
      const Vec3 p = column.vertices[polygon.corners[c]];
      worst = std::max(worst, length(column.normals[polygon.normals[c]] - normalized(Vec3{p.x, 0, p.z})));
    }
  EXPECT_LT(worst, tolerance);
}

TEST_F(ImportPovNormals, meshes_keep_their_normals) {
  const auto tilted = [](Vec3 p) { return Vec3{0.2, 0.1, p.x < 0.5 ? 1.0 : 1.5}; };
  const std::string corners = "<0,0,0>, <0.2,0.1,1>, <0,1,0>, <0.2,0.1,1>, <1,0,0>, <0.2,0.1,1.5>";
  const Scene smooth = import(kKept + "smooth_triangle { " + corners + " pigment { rgb 1 } }");
  EXPECT_FALSE(smooth.normals.empty());
  EXPECT_LT(worst_normal(smooth, tilted), 1e-4);
  const Scene mesh = import(kKept +
                            "mesh2 { vertex_vectors { 3, <0,0,0>, <0,1,0>, <1,0,0> }"
                            " normal_vectors { 2, <0.2,0.1,1>, <0.2,0.1,1.5> } face_indices { 1, <0,1,2> }"
                            " normal_indices { 1, <0,0,1> } pigment { rgb 1 } }");
  EXPECT_FALSE(mesh.normals.empty());
  EXPECT_LT(worst_normal(mesh, tilted), 1e-4);
}

}  // namespace
}  // namespace strad
