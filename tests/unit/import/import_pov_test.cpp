// POV-Ray scenes come in with their geometry, colours, lights and camera, or are refused by name, file and
// line.
#include <gtest/gtest.h>

#include <algorithm>

#include "import_folder.h"
#include "scene_measures.h"

namespace strad {
namespace {

class ImportPov : public ImportPovFolder {
 protected:
  // The value of an expression: the upper corner of a box made with it.
  Vec3 evaluated(const std::string& corner, const std::string& before = "") {
    const Scene scene = import(kKept + before + "box { <-1000, -1000, -1000>, " + corner + " }");
    Vec3 upper{-1e9, -1e9, -1e9};
    for (const Vec3 v : scene.vertices)
      for (int axis = 0; axis < 3; ++axis) upper[axis] = std::max(upper[axis], v[axis]);
    return upper;
  }
};

Vec3 normal_of(const Scene& scene, size_t polygon) {
  const Polygon& p = scene.polygons[polygon];
  const Vec3 a = scene.vertices[p.corners[0]];
  return normalized(cross(scene.vertices[p.corners[1]] - a, scene.vertices[p.corners[2]] - a));
}

TEST_F(ImportPov, evaluates_expressions) {
  expect_near(evaluated("<1 + 2*3, (4 - 1)/2, -2 + 2.5>"), {7, 1.5, 0.5});
  expect_near(evaluated("<1 2 3>*2 + x"), {3, 4, 6});
  expect_near(evaluated("2*y + <sqrt(16), pow(2, 3), abs(-5)>"), {4, 10, 5});
  expect_near(evaluated("vrotate(x, <0, 0, 90>) + vcross(x, y)*3 + vnormalize(<5, 0, 0>)"), {1, 1, 3});
  expect_near(evaluated("<(1 < 2), (3 <= 2 | 4 != 5), (1 & 0)>"), {1, 1, 0});
  expect_near(evaluated("<(1 > 2 ? 5 : 6), mod(7, 4), int(-2.5)>"), {6, 3, -2});
  expect_near(evaluated("<A.y, C.blue, pi>", "#declare A = <1, 2, 3>; #declare C = rgb <.1, .2, .3>;"),
              {2, 0.3, kPi});
  expect_near(
      evaluated("<strlen(S), val(\"2.5\"), asc(\"A\")>", "#declare S = concat(\"a\", str(3.14159, -6, 2));"),
      {7, 2.5, 65});
}

TEST_F(ImportPov, scatters_as_povray_does) {
  // The values that povray 3.7 prints.
  expect_near(evaluated("<rand(S), rand(S), 0>", "#declare S = seed(7);"), {0.95393288, 0.61046628, 0}, 1e-6);
  expect_near(evaluated("vrotate(<1, 2, 3>, <10, 20, 30>)"), {1.06743, 2.28906, 2.76058});
  expect_near(evaluated("<N, 0, 0>", "#declare N = 0; #for (K, 0, 1, 0.1) #declare N = N + 1; #end "),
              {11, 0, 0});
}

TEST_F(ImportPov, obeys_directives) {
  expect_near(evaluated("<N, 0, 0>",
                        "#declare N=0; #declare I=0; #while (I<5) #declare N=N+I; #declare I=I+1; #end "),
              {10, 0, 0});
  expect_near(evaluated("<N, 0, 0>", "#declare N=0; #for (I, 4, 0, -2) #declare N=N+I; #end "), {6, 0, 0});
  expect_near(
      evaluated("<N, 0, 0>", "#declare N=0; #for (I, 1, 9) #if (I=3) #break #end #declare N=N+I; #end "),
      {3, 0, 0});
  expect_near(evaluated("<1, 2, 3>*Twice(2)", "#macro Twice(A) #local B=A*2; B #end "), {4, 8, 12});
  expect_near(evaluated("<F(5), 0, 0>", "#macro F(N) #if (N<2) 1 #else N*F(N-1) #end #end "), {120, 0, 0});
  expect_near(evaluated("<A[1], B[1][0], dimension_size(A, 1)>",
                        "#declare A = array[3] {1, 2, 3}; #declare B = array[2][2] {{4, 5}, {6, 7}}; "),
              {2, 6, 3});
  expect_near(evaluated("<A[1], 0, 0>", "#declare A = array[2]\n#declare A[1] = 9; "), {9, 0, 0});
  expect_near(evaluated("<N, 0, 0>",
                        "#switch (2) #case (1) #declare N=1; #break #range (2, 3) #declare N=5; #break "
                        "#else #declare N=7; #end "),
              {5, 0, 0});
  expect_near(evaluated("<N, 0, 0>",
                        "#ifndef (N) #declare N=1; #else #declare N=2; #end #ifdef (M) #error \"no\" #end "),
              {1, 0, 0});
  expect_near(
      evaluated("<N, 0, 0>", "#if (0) #declare N=1; #elseif (1) #declare N=2; #else #declare N=3; #end "),
      {2, 0, 0});
}

TEST_F(ImportPov, includes_files_and_the_standard_colours_where_they_are) {
  write("part.inc", "#local Hidden = 3; #declare Shown = Hidden + 1;\n");
  expect_near(evaluated("<Shown, 0, 0>", "#include \"part.inc\" "), {4, 0, 0});
  EXPECT_EQ(refusal("#include \"part.inc\"\nbox { 0, Hidden }"),
            "room.pov:2: found \"Hidden\", expected a number");
  EXPECT_EQ(refusal("\n#include \"none.inc\""), "room.pov:2: included file \"none.inc\" is missing");
  const std::string corners = "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, ";
  EXPECT_EQ(refusal(corners + "<0, 1, 1e18> } }"), "room.pov:1: an index is too large");
  EXPECT_EQ(refusal(corners + "<0, 1, 3> } }"), "room.pov:1: face uses vertex 3 of 3");
}

TEST_F(ImportPov, makes_closed_bodies_with_their_fronts_outside) {
  options_.tessellate = 64;
  EXPECT_NEAR(volume_of(import("box { <0, 0, 0>, <1, 2, 3> }")), 6, 1e-6);
  EXPECT_NEAR(volume_of(import(kKept + "box { <1, 2, 3>, <0, 0, 0> scale <-1, 1, 1> }")), 6, 1e-6);
  // A sphere of radius 1 has 4 pi / 3; 64 x 32 sides inside it a little less.
  const double sphere = volume_of(import("sphere { <3, 4, 5>, 1 }"));
  EXPECT_NEAR(sphere, 4 * kPi / 3, 0.03);
  EXPECT_LT(sphere, 4 * kPi / 3);
  EXPECT_NEAR(volume_of(import("cylinder { <0, 0, 0>, <0, 0, 2>, 1 }")), 2 * kPi, 0.02);
  EXPECT_NEAR(volume_of(import("cone { <0, 1, 0>, 0, <0, 0, 0>, 1 }")), kPi / 3, 0.01);
  EXPECT_NEAR(area_of(import("cylinder { 0, 2*z, 1 open }")), 4 * kPi, 0.02);
  EXPECT_NEAR(area_of(import("disc { 0, y, 2, 1 }")), 3 * kPi, 0.02);
}

TEST_F(ImportPov, tessellates_as_told) {
  options_.tessellate = 5;
  EXPECT_EQ(import("sphere { 0, 1 }").polygons.size(), 10u);  // two bands
  EXPECT_EQ(import("cylinder { 0, y, 1 open }").polygons.size(), 5u);
}

TEST_F(ImportPov, mirrors_z_unless_the_camera_is_right_handed) {
  const std::string triangle = "triangle { <1, 0, 3>, <0, 1, 3>, <0, 0, 3> }\n";
  EXPECT_EQ(import(triangle).vertices[0].z, -3);
  EXPECT_EQ(import(kKept + triangle).vertices[0].z, 3);
  EXPECT_EQ(import("camera { location <0, 0, -5> look_at 0 }" + triangle).vertices[0].z, -3);
  EXPECT_EQ(import("camera { location 0 right -x }" + triangle).vertices[0].z, 3);
}

TEST_F(ImportPov, transforms_in_the_order_of_the_file) {
  const auto first = [&](const std::string& modifiers) {
    return import(kKept + "triangle { <1, 0, 0>, <1, 1, 0>, <1, 0, 1> " + modifiers + " }").vertices;
  };
  const auto contains = [](const std::vector<Vec3>& points, Vec3 wanted) {
    return std::any_of(points.begin(), points.end(), [&](Vec3 p) { return length(p - wanted) < 1e-5; });
  };
  EXPECT_TRUE(contains(first("rotate 90*z translate <10, 0, 0>"), {10, 1, 0}));
  EXPECT_TRUE(contains(first("translate <10, 0, 0> rotate 90*z"), {0, 11, 0}));
  EXPECT_TRUE(contains(first("rotate <90, 90, 0>"), {0, 0, -1}));
  EXPECT_TRUE(contains(first("scale <2, 3, 4>"), {2, 3, 0}));
  EXPECT_TRUE(contains(first("matrix <0, 1, 0, -1, 0, 0, 0, 0, 1, 5, 6, 7>"), {5, 7, 7}));
  EXPECT_TRUE(contains(first("translate 3*x transform { rotate 90*z translate x inverse }"), {0, -3, 0}));
}

TEST_F(ImportPov, cuts_polygons_with_holes) {
  const Scene scene =
      import(kKept + "polygon { 10, <0,0>, <4,0>, <4,4>, <0,4>, <0,0>, <1,1>, <1,2>, <2,2>, <2,1>, <1,1> }");
  EXPECT_NEAR(area_of(scene), 15, 1e-6);
}

TEST_F(ImportPov, bounds_planes_by_boxes) {
  const Scene scene =
      import(kKept + "plane { y, 1 pigment { rgb 0.5 } clipped_by { box { <0, 0, 0>, <2, 5, 3> } } }");
  EXPECT_NEAR(area_of(scene), 6, 1e-6);
  expect_near(normal_of(scene, 0), {0, 1, 0});
  const Scene turned =
      import(kKept + "plane { <0, 2, 0>, 1 rotate 90*z bounded_by { box { -1, 1 } } translate 5*x }");
  EXPECT_NEAR(area_of(turned), 4, 1e-6);
  EXPECT_NEAR(turned.vertices[0].x, 4,
              1e-6);  // the length of the normal has no effect; the plane lies in a side of the box
}

TEST_F(ImportPov, gives_textures_to_what_has_none) {
  const Scene scene = import(
      "#declare Red = texture { pigment { rgb <0.5, 0, 0> } finish { diffuse 0.5 } }\n"
      "#declare Wheel = sphere { 0, 1 }\n"
      "#declare Car = union { object { Wheel } object { Wheel translate 3*x } box { 0, 1 texture { Red } } "
      "}\n"
      "object { Car pigment { rgb 1 } finish { diffuse 0.25 emission 2 } }\nobject { Car translate 9*y }");
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Car/Wheel", "Car/Wheel_2", "Car", "Car_2/Wheel",
                                             "Car_2/Wheel_2", "Car_2"}));
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[0].name, "Car");
  EXPECT_EQ(scene.materials[0].reflectance, (Rgb{0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(scene.materials[0].emission, (Rgb{2, 2, 2}));
  EXPECT_EQ(scene.materials[1].name, "Red");
  EXPECT_EQ(scene.materials[1].reflectance, (Rgb{0.25f, 0, 0}));
  EXPECT_EQ(scene.materials[2].reflectance, (Rgb{0, 0, 0}));  // POV-Ray's default pigment is black
}

TEST_F(ImportPov, reads_meshes) {
  const Scene scene = import(
      "#declare T = array[2] {texture { pigment { rgb 0.25 } finish { diffuse 1 } },"
      " texture { pigment { rgb 0.75 } finish { diffuse 1 emission <1, 2, 4> } }}\n" +
      kKept +
      "mesh2 { vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <1,1,0> }"
      " texture_list { 2, #for (I, 0, 1) texture { T[I] } #end }"
      " face_indices { 3, <0,1,2>, 0, <1,3,2>, 0, 1, 1 <0,1,3> } pigment { rgb 0.5 } finish { diffuse 1 } }\n"
      "mesh { triangle { <0,0,1>, <1,0,1>, <0,1,1> texture { T[0] } }"
      " smooth_triangle { <0,0,2>, z, <1,0,2>, z, <0,1,2>, z } }");
  ASSERT_EQ(scene.polygons.size(), 5u);
  const auto reflectance = [&](size_t p) {
    return scene.materials[scene.polygons[p].material].reflectance.r;
  };
  EXPECT_FLOAT_EQ(reflectance(0), 0.25f);
  EXPECT_NEAR(reflectance(1), (0.25 + 0.75 + 0.75) / 3, 1e-6);
  EXPECT_FLOAT_EQ(reflectance(2), 0.5f);
  EXPECT_NEAR(scene.materials[scene.polygons[1].material].emission.b, 2.0 / 3 * 0.75 * 4, 1e-6);
  expect_near(normal_of(scene, 0), {0, 0, -1});  // clockwise, as coordinates are not mirrored
  EXPECT_EQ(scene.vertices.size(), 4u + 3 + 3);
}

TEST_F(ImportPov, turns_lights_into_the_same_light) {
  const Scene scene =
      import(kKept +
             "box { -1, 1 }\n"
             "light_source { <0, 3, 0> rgb <1, 2, 3> fade_distance 0.1 fade_power 2 }\n"
             "light_source { <0, 5, 0> rgb 1 spotlight point_at <0, 1, 0> radius 20 falloff 30 }\n"
             "#declare Lamp = light_source { 0 rgb 2 area_light 2*x, 3*z, 4, 4 spotlight radius 90 falloff "
             "90 tightness 1"
             " point_at -y fade_distance 1 fade_power 2 }\n"
             "light_source { Lamp translate 9*y }\n"
             "light_source { 8*y rgb 1 area_light 2*x, 3*z, 4, 4 jitter adaptive 1 fade_distance 1 "
             "fade_power 2 }\n");
  ASSERT_EQ(scene.spots.size(), 2u);
  // I = 2 pi d^2 colour.
  EXPECT_NEAR(scene.spots[0].keys[0].intensity.g, 2 * kPi * 0.01 * 2, 1e-5);
  EXPECT_GT(scene.spots[0].outer, 3.14);
  // Unfading: I = pi r^2 colour, where r = 4 is the distance to point_at.
  EXPECT_NEAR(scene.spots[1].keys[0].intensity.g, kPi * 16, 1e-3);
  EXPECT_NEAR(scene.spots[1].inner, 20 * kPi / 180, 1e-9);
  EXPECT_NEAR(scene.spots[1].outer, 30 * kPi / 180, 1e-9);
  // A Lambertian panel of 6 m^2: Le = I / A = 2 pi 2 / 6. It looks down, and is moved down a little.
  const Polygon& lamp = scene.polygons[6];
  EXPECT_EQ(scene.objects[lamp.object].name, "Lamp");
  EXPECT_NEAR(scene.materials[lamp.material].emission.r, 4 * kPi / 6, 1e-5);
  expect_near(normal_of(scene, 6), {0, -1, 0});
  EXPECT_LT(scene.vertices[lamp.corners[0]].y, 9);
  // A point light of area: 2 I / A to each side.
  EXPECT_EQ(scene.polygons.size(), 9u);
  EXPECT_NEAR(scene.materials[scene.polygons[7].material].emission.r, 2 * 2 * kPi / 6, 1e-5);
  EXPECT_NEAR(dot(normal_of(scene, 7), normal_of(scene, 8)), -1, 1e-6);
}

TEST_F(ImportPov, reads_the_camera) {
  // Left-handed: z is mirrored. The vertical field of view is 2 atan(|up| / 2 / |direction|).
  const Scene scene =
      import("camera { angle 90 location <1, 2, -5> right 2*x up y look_at <1, 2, 0> }\nbox { 0, 1 }");
  ASSERT_EQ(scene.cameras.size(), 1u);
  const CameraKey& key = scene.cameras[0].keys[0];
  expect_near(key.from, {1, 2, 5});
  expect_near(normalized(key.to - key.from), {0, 0, -1});
  expect_near(key.up, {0, 1, 0});
  EXPECT_NEAR(key.fov, 2 * std::atan(0.5), 1e-9);  // half as high as wide, 90 degrees wide
}

TEST_F(ImportPov, looks_straight_down) {
  const CameraKey key = import("camera { location 5*y look_at 0 }\nbox { 0, 1 }").cameras[0].keys[0];
  expect_near(normalized(key.to - key.from), {0, -1, 0});
  expect_near(key.up, {0, 0, -1});  // POV-Ray's z
}

TEST_F(ImportPov, leaves_out_the_picture_of_a_lamp) {
  const std::string text =
      "box { 0, 1 no_shadow pigment { rgb 1 } finish { diffuse 0 ambient 0.8 } }\nbox { 0, 1 no_shadow }";
  EXPECT_EQ(import(text).polygons.size(), 6u);
  EXPECT_EQ(
      note(0),
      "room.pov:1: glowing surface without shadow left out: its light comes from light sources (6 in all)");
}

TEST_F(ImportPov, scales_light_with_lengths) {
  options_.scale = 0.5;
  const Scene scene = import("box { 0, 2 }\nlight_source { 4*y rgb 1 fade_distance 1 fade_power 2 }");
  EXPECT_NEAR(scene.spots[0].keys[0].intensity.r, 2 * kPi * 0.25,
              1e-5);  // the same irradiance at half the distance
  EXPECT_NEAR(scene.spots[0].keys[0].at.y, 2, 1e-9);
}

TEST_F(ImportPov, refuses_by_name_what_it_cannot_show) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"sphere_sweep { 1, 0.2 }", "room.pov:1: sphere_sweep is not supported"},
      {"box { 0, 1 }\ndifference { box { 0, 1 } julia_fractal { 0, 1 } }",
       "room.pov:2: julia_fractal is not supported"},
      {"#declare T = ovus { 1, 0.2 }\nunion { box { 0, 1 }\nobject { T } }",
       "room.pov:1: ovus is not supported"},
      {"box { 0, 1 }\nquadric { <0, 1, 0>, 0, 0, -1 }",
       "room.pov:2: quadric without bounds is not supported"},
      {"box { 0, 1 pigment { checkers rgb 0, rgb 1 } }", "room.pov:1: pigment checkers is not supported"},
      {"media { emission 1 }", "room.pov:1: media is not supported"},
      {"background { rgb 1 }\nglobal_settings { radiosity { count 9 } }",
       "room.pov:1: background light with radiosity, which lights the scene, is not supported"},
      {"box { 0, 1 }\nlight_source { 0 rgb 1 parallel point_at x }",
       "room.pov:2: light_source parallel is not supported"},
      {"box { 0, 1 }\nlight_source { 0 rgb -1 }", "room.pov:2: a light of negative colour is not supported"},
      {"camera { fisheye angle 200 }\nbox { 0, 1 }", "room.pov:1: camera fisheye is not supported"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(refusal(text), expected) << text;
  options_.skip_unknown = true;
  for (const auto& [text, expected] : cases) {
    import(text + "\nbox { 5, 6 }");
    const std::string left_out = expected.substr(0, expected.size() - std::string("is not supported").size());
    EXPECT_TRUE(note(0).starts_with(left_out + "left out")) << note(0);
  }
  EXPECT_EQ(refusal("background { rgb 1 }\njulia_fractal { 0 }"),
            "room.pov: has no polygons but what was left out; room.pov:2: julia_fractal left out");
}

TEST_F(ImportPov, refuses_broken_files_with_their_line) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "room.pov: is empty"},
      {"// nothing", "room.pov: has no polygons"},
      {"box { 0, 1", "room.pov:1: found the end of the file, expected an object's modifier or }"},
      {"box { <1, 2 }", "room.pov:1: found \"}\", expected a number"},
      {"\nbox { 0, Size }", "room.pov:2: found \"Size\", expected a number"},
      {"cube { 0, 1 }", "room.pov:1: found \"cube\", expected an object, a light or a directive"},
      {"#declare A = ;", "room.pov:1: found \";\", expected a number"},
      {"#declare A = blob2", "room.pov:1: found \"blob2\", expected a value"},
      {"#if (1) box { 0, 1 }", "room.pov:1: the block is not closed, expected #end"},
      {"#end", "room.pov:1: found #end outside a block"},
      {"#while (1) #end", "room.pov:1: the file takes more than 5000000 turns of loops"},
      {"#macro M() M() #end M()", "room.pov:1: includes and macros are nested too deep"},
      {"#include \"room.pov\"", "room.pov:1: includes and macros are nested too deep"},
      {"#for (I, 0, 1, 0) #end", "room.pov:1: the loop never ends: its step is 0"},
      {"#declare A = array[2] {1, 2};\nbox { 0, A[2] }",
       "room.pov:2: index 2 of the array A, expected 0 to 1"},
      {"#declare A = array[1e9][1e9];", "room.pov:1: the array has 1000000000.000000 elements"},
      {"box { 0, 1/0 }", "room.pov:1: division by 0"},
      {"box { 0, sqrt(-1) }", "room.pov:1: sqrt has no finite value here"},
      {"box { 0, 1e99 }", "room.pov:1: found \"1e99\", expected a finite number"},
      {"/* open", "room.pov:1: a comment is not closed, expected */"},
      {"#debug \"open", "room.pov:1: a string is not closed, expected \""},
      {"box { 0, 1 scale <1, 0, 1> }", "room.pov:1: the transformation makes things flat"},
      {"#fopen F \"../x\" read", "room.pov:1: #fopen of \"../x\", which is not below the scene's folder"},
      {"#declare F = function { x + 1", "room.pov:1: a function is not closed, expected }"},
      {"#declare F = function(a) { a }\nbox { 0, F(1, 2) }",
       "room.pov:2: the function F has 2 arguments, expected 1"},
      {"mesh2 { vertex_vectors { 1, 0 } face_indices { 1,\n<0, 0, 7> } }",
       "room.pov:2: face uses vertex 7 of 1"},
      {"#error \"stop\"", "room.pov:1: #error \"stop\""},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(refusal(text), expected) << text;
}

TEST_F(ImportPov, survives_deep_nesting) {
  std::string braces, parentheses;
  for (int i = 0; i < 100000; ++i) braces += "union { ", parentheses += "(";
  EXPECT_NE(refusal(braces).find("nested too deep"), std::string::npos);
  EXPECT_NE(refusal("box { 0, " + parentheses + " }").find("nested too deep"), std::string::npos);
  EXPECT_EQ(refusal("box { 0, " + std::string(1000001, '-') + "1 }"), "");
  std::string declarations;
  for (int i = 0; i < 100000; ++i) declarations += "#declare A = 1\n";  // no semicolon ends them
  EXPECT_EQ(refusal(declarations + "box { 0, A }"), "");
}

TEST_F(ImportPov, names_every_truncation_or_imports_it) {
  const std::string text =
      "#declare N = 2; #macro M(A) A*2 #end\n#for (I, 0, N) box { I, M(I) + 1 texture { pigment { rgb <.1, "
      ".2, .3> } } }"
      " #end\nlight_source { <0, 9, 0> rgb 1 spotlight point_at 0 }\nmesh2 { vertex_vectors { 3, 0, x, y }"
      " face_indices { 1, <0, 1, 2> } translate z }\ncamera { location -z look_at 0 }\n";
  for (size_t size = 0; size < text.size(); ++size) {
    try {
      EXPECT_FALSE(import(text.substr(0, size)).polygons.empty());
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("room.pov"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace strad
