// POV-Ray's cut, turned and drawn objects have the volumes and surfaces that geometry gives them.
#include <gtest/gtest.h>

#include <cmath>

#include "import_folder.h"
#include "scene_measures.h"

namespace strad {
namespace {

// With coordinates kept as they are, and a pigment that names nothing.
class ImportPovShapes : public ImportPovFolder {
 protected:
  Scene import(const std::string& text) override { return ImportPovFolder::import(kKept + text); }
};

// The sum of the polygons' areas as vectors, which is 0 for a closed surface, and 0 of it where nothing is
// missing.
Vec3 opening_of(const Scene& scene) {
  Vec3 sum;
  for (const Polygon& p : scene.polygons) {
    const auto& v = scene.vertices;
    for (int k = 2; k < p.corner_count(); ++k)
      sum += 0.5 * cross(v[p.corners[k - 1]] - v[p.corners[0]], v[p.corners[k]] - v[p.corners[0]]);
  }
  return sum;
}

TEST_F(ImportPovShapes, boxes_cut_by_boxes) {
  struct Case {
    std::string text;
    double volume, area;
  };
  const std::vector<Case> cases{
      // A corner of volume 1 is gone; three of its sides are replaced by three others.
      {"difference { box { -1, 1 } box { 0, 2 } }", 7, 24},
      {"intersection { box { -1, 1 } box { 0, 2 } }", 1, 6},
      // Sides in one plane count once.
      {"intersection { box { -1, 1 } box { -1, 1 } }", 8, 24},
      {"intersection { box { -1, 1 } box { -1, 1 } box { <-1, -1, 0>, 1 } }", 4, 2 * 4 + 4 * 2},
      {"difference { box { -1, 1 } box { <0, -1, -1>, 1 } }", 4, 2 * 4 + 4 * 2},
      // A hole of 1 by 1 through the box: its two ends are open, its four sides are new.
      {"difference { box { -1, 1 } box { <-.5, -2, -.5>, <.5, 2, .5> } }", 8 - 2, 24 - 2 + 4 * 2},
      // What is taken away twice is taken away once: a slab of 2 by 2 by 0.5.
      {"difference { box { -1, 1 } union { box { <-2, 0, -2>, <2, .3, 2> } box { <-2, .2, -2>, <2, .5, 2> } "
       "} }",
       8 - 2, 2 * (4 + 4 + 4 * 1 + 4 * .5)},
      {"difference { difference { box { -1, 1 } box { 0, 2 } } box { -2, <2, -.5, 2> } }", 7 - 2,
       24 - 4 * .5 * 2},
      // Planes have all behind them inside.
      {"intersection { plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 } plane { z, 1 } plane { "
       "-z, 1 } }",
       8, 24},
      {"intersection { box { -1, 1 } plane { y, 0 inverse } }", 4, 2 * 4 + 4 * 2},
      {"intersection { box { -1, 1 } plane { y, 0 rotate 180*x } scale 2 translate x }", 32,
       4 * (2 * 4 + 4 * 2)},
      {"difference { box { -1, 1 scale <-1, 1, 1> } box { 0, 2 scale <-1, 1, 1> } }", 7, 24},
  };
  for (const Case& c : cases) {
    const Scene scene = import(c.text);
    EXPECT_NEAR(volume_of(scene), c.volume, 1e-5) << c.text;
    EXPECT_NEAR(area_of(scene), c.area, 1e-5) << c.text;
    EXPECT_NEAR(length(opening_of(scene)), 0, 1e-5) << c.text;
  }
}

// What two solids have in common and what one has alone make up the one, whatever facets they have.
TEST_F(ImportPovShapes, parts_of_round_objects_make_up_the_whole) {
  const std::vector<std::pair<std::string, std::string>> pairs{
      {"sphere { 0, 1 }", "box { <-.3, -.2, -.1>, 2 }"},
      {"sphere { 0, 1 }", "sphere { .7, 1 }"},
      {"torus { 1, 0.4 }", "box { 0, 3 rotate 20*y }"},
      {"cylinder { -y, y, .5 }", "cylinder { -2*x, 2*x, .4 }"},
      {"superellipsoid { <.3, .6> }", "torus { 1, .3 rotate 40*x }"},
      {"prism { 0, 1, 10, <0,0>, <4,0>, <4,4>, <0,4>, <0,0>, <1,1>, <1,2>, <2,2>, <2,1>, <1,1> }",
       "sphere { <1.5, 1, 2>, 1 }"},
      {"blob { threshold .5 sphere { 0, 1, 1 } sphere { x, 1, 1 } }", "plane { <1, 2, 3>, .2 }"},
  };
  for (const auto& [a, b] : pairs) {
    const double whole = volume_of(import(a));
    const Scene common = import("intersection { " + a + " " + b + " }"),
                alone = import("difference { " + a + " " + b + " }");
    EXPECT_GT(volume_of(common), 0.01) << a << b;
    EXPECT_NEAR(volume_of(common) + volume_of(alone), whole, 1e-5 * whole) << a << b;
    EXPECT_NEAR(length(opening_of(common)), 0, 1e-5) << a << b;
    EXPECT_NEAR(length(opening_of(alone)), 0, 1e-5) << a << b;
  }
}

TEST_F(ImportPovShapes, clips_without_closing) {
  // Half a box, open where it was cut.
  EXPECT_NEAR(area_of(import("box { -1, 1 clipped_by { plane { y, 0 } } }")), 4 + 4 * 2, 1e-5);
  EXPECT_NEAR(area_of(import("object { box { -1, 1 } clipped_by { box { -2, <2, 0, 2> } } }")), 4 + 4 * 2,
              1e-5);
}

TEST_F(ImportPovShapes, turns_outlines) {
  options_.tessellate = 12;
  // A polygon of area A whose centre is at the distance R, turned in 12 steps: R A times the perimeter of the
  // regular 12-gon of circumradius 1 (Pappus, for prisms with oblique ends).
  const double around = 12 * 2 * std::sin(kPi / 12) * std::cos(kPi / 12);
  const double circle = 12 * std::sin(2 * kPi / 12) / 2 * 0.25;  // the area of a 12-gon of circumradius 0.5
  EXPECT_NEAR(volume_of(import("torus { 2, 0.5 }")), 2 * circle * around, 1e-5);
  EXPECT_NEAR(volume_of(import("lathe { 5, <1,0>, <2,0>, <2,1>, <1,1>, <1,0> }")), 1.5 * around, 1e-5);
  // Also clockwise, and a cone, which ends on the axis: a third of its prism.
  EXPECT_NEAR(volume_of(import("lathe { linear_spline 5, <1,0>, <1,1>, <2,1>, <2,0>, <1,0> }")), 1.5 * around,
              1e-5);
  EXPECT_NEAR(volume_of(import("lathe { 3, <0,0>, <1,0>, <0,3> }")), around / 2, 1e-5);
  // A sor through points on a cylinder is one.
  EXPECT_NEAR(volume_of(import("sor { 5, <1,-1>, <1,0>, <1,1>, <1,2>, <1,3> }")), 2 * around / 2, 1e-5);
  // The last point only gives a slope, and may be as high as the one before; others may not.
  EXPECT_NEAR(volume_of(import("sor { 5, <1,-1>, <1,0>, <1,1>, <1,2>, <1,2> }")), 2 * around / 2, 1e-5);
  EXPECT_NE(
      refusal("sor { 5, <1,-1>, <1,0>, <1,0>, <1,2>, <1,3> }").find("sor with two points at one height"),
      std::string::npos);
  const Scene sphere = import("superellipsoid { <1, 1> scale 2 }");
  for (const Vec3 p : sphere.vertices) EXPECT_NEAR(length(p), 2, 1e-6);
}

TEST_F(ImportPovShapes, draws_outlines) {
  const std::string ring = "<0,0>, <4,0>, <4,4>, <0,4>, <0,0>", hole = "<1,1>, <1,2>, <2,2>, <2,1>, <1,1>";
  const Scene prism = import("prism { -1, 2, 10, " + ring + ", " + hole + " }");
  EXPECT_NEAR(volume_of(prism), 3 * 15, 1e-4);
  EXPECT_NEAR(area_of(prism), 2 * 15 + 3 * (16 + 4), 1e-4);
  EXPECT_NEAR(area_of(import("prism { -1, 2, 5, " + ring + " open }")), 3 * 16, 1e-4);
  // Between y = 1 and y = 2 of a pyramid whose base at y = 1 has the area 16.
  EXPECT_NEAR(volume_of(import("prism { conic_sweep 1, 2, 5, " + ring + " }")), 16 * (8 - 1) / 3.0, 1e-4);
  // A letter is closed, as thick as told, and stands on its line.
  const Scene letter = import("text { ttf \"timrom.ttf\" \"H\" 0.25, 0 }");
  EXPECT_NEAR(length(opening_of(letter)), 0, 1e-6);
  Box box;
  for (const Vec3 p : letter.vertices) box.add(p);
  EXPECT_NEAR(box.lower.y, 0, 1e-3);
  EXPECT_NEAR(box.upper.z - box.lower.z, 0.25, 1e-6);
  EXPECT_GT(volume_of(letter), 0);
}

TEST_F(ImportPovShapes, finds_surfaces_of_functions) {
  // The parts of a blob of one sphere: strength (1 - d^2)^2 = threshold at d^2 = 1 - sqrt(0.25 / 1).
  const Scene blob = import("blob { threshold 0.25 sphere { 0, 1, 1 } }");
  for (const Vec3 p : blob.vertices) EXPECT_NEAR(length(p), std::sqrt(0.5), 0.01);
  EXPECT_NEAR(length(opening_of(blob)), 0, 1e-6);
  const double ball = 4 * kPi / 3;
  EXPECT_NEAR(volume_of(import("quadric { <1, 1, 1>, 0, 0, -1 }")), ball, 0.03 * ball);
  EXPECT_NEAR(volume_of(import("intersection { box { 0, 2 } quadric { <1, 1, 1>, 0, 0, -1 } }")), ball / 8,
              0.03 * ball / 8);
  // A cylinder without end, cut off by what it is taken from: a bore of radius 0.5.
  EXPECT_NEAR(volume_of(import("difference { box { -1, 1 } quadric { <1, 0, 1>, 0, 0, -0.25 } }")),
              8 - 2 * kPi / 4, 0.05);
  EXPECT_NEAR(
      volume_of(import("#declare R2 = 0.64; isosurface { function { x*x + y*y + z*z - R2 } contained_by {"
                       " box { <-1, 0, -1>, 1 } } }")),
      ball / 2 * 0.512, 0.03 * ball / 2 * 0.512);
  // Planes that cut off a cylinder: of radius 1 and 2 m high.
  EXPECT_NEAR(
      volume_of(import("intersection { quadric { <1, 0, 1>, 0, 0, -1 } plane { y, 1 } plane { -y, 1 } }")),
      2 * kPi, 0.03 * 2 * kPi);
  EXPECT_NEAR(volume_of(import("blob { threshold .25 component 1, 1, <0, 0, 0> }")),
              ball * std::pow(0.5, 1.5), 0.03 * ball);
  // x^2 + y^2 + z^2 - 1 as a polynomial of second order: x2 xy xz x y2 yz y z2 z 1.
  EXPECT_NEAR(volume_of(import("poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> }")), ball, 0.03 * ball);
  EXPECT_NEAR(area_of(import("bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3"
                             " <0,0,0> <1,0,0> <2,0,0> <3,0,0> <0,1,0> <1,1,0> <2,1,0> <3,1,0>"
                             " <0,2,0> <1,2,0> <2,2,0> <3,2,0> <0,3,0> <1,3,0> <2,3,0> <3,3,0> }")),
              9, 1e-5);
}

// What rays and points meet, by the box's own numbers: beside, inside, and through edges of its facets.
TEST_F(ImportPovShapes, tells_rays_and_points_of_objects) {
  const std::string box = "#declare B = box { -1, <1, 2, 3> rotate 90*y }\n";  // z becomes x, x becomes -z
  const auto corner = [&](const std::string& expression) {
    Box found;
    for (const Vec3 p : import(box + "box { -100, " + expression + " }").vertices) found.add(p);
    return found.upper;
  };
  expect_near(corner("trace(B, <9, 0, 0>, -x)"), {3, 0, 0});
  expect_near(corner("trace(B, <0, 9, 0>, -y)"), {0, 2, 0});
  expect_near(corner("trace(B, <9, 5, 0>, -x) + 1"), {1, 1, 1});  // misses
  expect_near(corner("<inside(B, <2.9, 1.9, .9>), inside(B, <3.1, 0, 0>), inside(B, <0, 0, 0>)>"), {1, 0, 1});
  expect_near(corner("<inside(sphere { 0, 1 }, 0), inside(torus { 1, .3 }, 0), inside(torus { 1, .3 }, x)>"),
              {1, 0, 1});
  // Also where rays along x pass through corners and edges: of a grid of points, those in the ball.
  const std::string grid =
      "#declare B = sphere { 0, 1 } #declare N = 0;\n#for (X, -1.5, 1.5, 0.25) #for (Y, -1.5, 1.5, 0.25)"
      " #for (Z, -1.5, 1.5, 0.25) #local Q = <X, Y, Z>; #local L = vlength(Q);\n"
      " #if ((L < 0.97 & !inside(B, Q)) | (L > 1.01 & inside(B, Q))) #declare N = N + 1; #end #end #end "
      "#end\n";
  Box wrong;
  for (const Vec3 p : import(grid + "box { -100, N }").vertices) wrong.add(p);
  EXPECT_EQ(wrong.upper.x, 0);
}

// The faces of a mesh may be sums of vectors.
TEST_F(ImportPovShapes, reads_faces_that_are_expressions) {
  const Scene scene = import(
      "#declare F = <0, 1, 2>; mesh2 { vertex_vectors { 4, 0, x, y, x + y } face_indices { 2, F, F + 1 } }");
  EXPECT_NEAR(area_of(scene), 1, 1e-6);
}

TEST_F(ImportPovShapes, cuts_planes_without_end) {
  // What is finite is the box and the camera: a box of 1 by 1 by 5, centred at z = 2.5. A plane is cut at 10
  // times its diagonal, to each side.
  const double half = 10 * std::sqrt(27.0);
  const Scene scene = import("box { 0, 1 }\nplane { y, 0 }\nplane { y, -3 scale 0.01 }");
  EXPECT_NEAR(area_of(scene), 6 + 2 * 4 * half * half, 0.01);
  ASSERT_EQ(report_.lines().size(), 1u);
  EXPECT_NE(report_.lines()[0].find("plane without end is cut at 10 times the size of the scene (2 in all)"),
            std::string::npos);
}

}  // namespace
}  // namespace strad
