// POV-Ray's patterns, layers and finishes become one colour each; functions, splines and files have their
// values.
#include <gtest/gtest.h>

#include "import_folder.h"
#include "scene_measures.h"

namespace strad {
namespace {

class ImportPovLooks : public ImportPovFolder {
 protected:
  ImportPovLooks() { std::filesystem::create_directories(folder_ / "below"); }
  // Of a box with these modifiers that reflects all of its pigment.
  Rgb reflectance(const std::string& modifiers) {
    return import("#default { finish { diffuse 1 } }\nbox { 0, 1 " + modifiers + " }")
        .materials[0]
        .reflectance;
  }
  // The upper corner of a box made with an expression; z is mirrored.
  Vec3 value(const std::string& before, const std::string& expression) {
    const Scene scene = import(before + "\nbox { -100, " + expression + " }");
    Box box;
    for (const Vec3 p : scene.vertices) box.add(p);
    return {box.upper.x, box.upper.y, -box.lower.z};
  }
};

void expect_near(Rgb a, Rgb b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-6);
}

// The picture's mean, half of red; that it would be clear is told.
TEST_F(ImportPovLooks, transparency_of_pictures_is_told) {
  write("p.ppm", "P6\n2 1\n255\n\xff" + std::string(5, '\0'));
  expect_near(reflectance("pigment { image_map { ppm \"p.ppm\" } }"), {0.5f, 0, 0});
  EXPECT_FALSE(noted("filter and transmit of image_map are ignored: holes are where its alpha says so"));
  reflectance("pigment { image_map { ppm \"p.ppm\" transmit all 0.5 } }");
  EXPECT_TRUE(noted("filter and transmit of image_map are ignored: holes are where its alpha says so"));
}

TEST_F(ImportPovLooks, patterns_have_their_mean_colour) {
  expect_near(reflectance("pigment { checker rgb <.2, 0, 0>, rgb <.4, .6, 0> }"), {0.3f, 0.3f, 0});
  EXPECT_TRUE(noted("pigment checker is taken as its mean colour"));
  expect_near(reflectance("pigment { checker color rgb .2 color rgb .4 scale 2 }"), {0.3f, 0.3f, 0.3f});
  // Mortar of 1 in bricks of 4 by 2: bricks are (3/4)(1/2) of the wall.
  expect_near(reflectance("pigment { brick rgb 0, rgb .8 brick_size <4, 2, 2> mortar 1 }"),
              {0.3f, 0.3f, 0.3f});
  // Linear from 0 to 0.8 over half of the values, constant over the rest: 0.4 / 2 + 0.8 / 2.
  expect_near(reflectance("pigment { gradient x color_map { [0 rgb 0] [0.5 rgb .8] } turbulence 1 }"),
              {0.6f, 0.6f, 0.6f});
  // Entries of two values, as old files have them.
  expect_near(reflectance("pigment { bozo color_map { [0, .5 color rgb .2 color rgb .2] [.5, 1 color rgb .6 "
                          "color rgb .6] } }"),
              {0.4f, 0.4f, 0.4f});
  expect_near(reflectance("pigment { average pigment_map { [1 rgb .2] [3 checker rgb .4, rgb .8] } }"),
              {0.5f, 0.5f, 0.5f});
  expect_near(reflectance("pigment { granite }"), {0.5f, 0.5f, 0.5f});
  EXPECT_TRUE(noted("pigment granite without colours is taken as grey"));
  expect_near(
      reflectance(
          "texture { tiles { texture { pigment { rgb .2 } } tile2 texture { pigment { rgb .4 } } } }"),
      {0.3f, 0.3f, 0.3f});
  // Reflectances are mixed, not colours and finishes apart: (0.8 * 0.5 + 0.2 * 1) / 2.
  expect_near(reflectance("texture { checker texture { pigment { rgb .8 } finish { diffuse .5 } }"
                          " texture { pigment { rgb .2 } } }"),
              {0.3f, 0.3f, 0.3f});
}

TEST_F(ImportPovLooks, layers_show_what_is_below) {
  // Half of the upper layer is clear: 0.5 * 0.8 + 0.5 * 0.4.
  expect_near(reflectance("texture { pigment { rgb .4 } } texture { pigment { rgbt <.8, .8, .8, .5> } }"),
              {0.6f, 0.6f, 0.6f});
  // A filter of 0.5 lets 0.5 of its own colour through: 0.5 * 0.8 + 0.4 * 0.4.
  expect_near(reflectance("texture { pigment { rgb .4 } } texture { pigment { rgbf <.8, .8, .8, .5> } }"),
              {0.56f, 0.56f, 0.56f});
  const Scene clear = import("box { 0, 1 pigment { rgbt 1 } }\nsphere { 9, 1 pigment { rgb 1 } }");
  for (const Polygon& polygon : clear.polygons) EXPECT_EQ(clear.objects[polygon.object].name, "sphere");
  EXPECT_TRUE(noted("clear surface left out: all light passes"));
}

TEST_F(ImportPovLooks, finishes_are_mirrors_and_glass) {
  const auto looks = [&](const std::string& modifiers) {
    return import("box { 0, 1 " + modifiers + " }").materials[0];
  };
  Material m = looks("pigment { rgb .5 } finish { diffuse .6 reflection .2 }");
  expect_near(m.reflectance, {0.3f, 0.3f, 0.3f});
  expect_near(m.finish.specular, {0.2f, 0.2f, 0.2f});
  EXPECT_FALSE(m.finish.fresnel || m.finish.metallic);
  // The mirror of a metal has its colour: 0.5 * 0.4.
  m = looks("pigment { rgb .5 } finish { diffuse .6 reflection { .4 metallic } }");
  expect_near(m.finish.specular, {0.2f, 0.2f, 0.2f});
  EXPECT_TRUE(m.finish.metallic);
  m = looks("pigment { rgb .5 } finish { reflection { 0, 1 fresnel on } } interior { ior 1.3 }");
  EXPECT_TRUE(m.finish.fresnel);
  EXPECT_FLOAT_EQ(m.finish.ior, 1.3f);
  // No more light is sent back than comes: 1 - 0.8 is left.
  m = looks("pigment { rgb .5 } finish { diffuse .6 reflection .8 }");
  expect_near(m.reflectance, {0.2f, 0.2f, 0.2f});
  EXPECT_TRUE(noted("diffuse reflectance is lowered to what mirror and glass leave of the light"));
  // A filter of 0.5 lets 0.5 of its own colour through; the other half is opaque, with a diffuse of 0.6.
  m = looks("pigment { rgbf <.8, .6, .4, .5> } finish { diffuse .6 } interior { ior 1.5 fade_power 2 }");
  expect_near(m.finish.transmission, {0.4f, 0.3f, 0.2f});
  expect_near(m.reflectance, {0.24f, 0.18f, 0.12f});
  EXPECT_FLOAT_EQ(m.finish.ior, 1.5f);
  // Clear, but it bends what is seen: it is not left out.
  m = looks("pigment { rgbt 1 } interior { ior 1.5 }");
  expect_near(m.finish.transmission, {1, 1, 1});
  // In a mean over a pattern of finishes a mirror is diffuse: (0.6 * 0.5 + 0.2 + 0.6 * 0.5) / 2.
  expect_near(
      reflectance("texture { checker texture { pigment { rgb .5 } finish { diffuse .6 reflection .2 } }"
                  " texture { pigment { rgb .5 } finish { diffuse .6 } } }"),
      {0.4f, 0.4f, 0.4f});
  EXPECT_TRUE(noted("mirror reflection in layers or a pattern is taken as diffuse"));
}

TEST_F(ImportPovLooks, reflectances_are_limited) {
  expect_near(reflectance("pigment { rgb <3, .5, -1> }"), {0.98f, 0.5f, 0});
  EXPECT_TRUE(noted("reflectance above 0.98 is taken as 0.98"));
  EXPECT_TRUE(noted("negative reflectance is taken as 0"));
}

TEST_F(ImportPovLooks, skies_are_left_out_where_they_light_nothing) {
  import("background { rgb 1 }\nsky_sphere { pigment { rgb 1 } }\nfog { distance 9 rgb 1 }\nbox { 0, 1 }");
  EXPECT_TRUE(noted("background light is left out: without radiosity it lights nothing"));
  EXPECT_TRUE(noted("sky_sphere is left out: without radiosity it lights nothing"));
  EXPECT_TRUE(noted("fog is left out: it changes what is seen, not what is lit"));
}

TEST_F(ImportPovLooks, functions_have_the_values_of_their_declaration) {
  expect_near(value("#declare A = 2; #declare F = function { x + A*y*z }\n#declare A = 9;", "F(1, 2, 3)"),
              {13, 13, 13});
  expect_near(value("#declare G = function(a, b) { pow(a, b) }\n#declare F = function(a) { G(a, 2) + 1 }",
                    "<F(3), G(2, 3), 1>"),
              {10, 8, 1});
  expect_near(value("#declare F = function { transform { rotate 90*z translate x } }", "F(1, 2, 3)"),
              {-1, 1, 3});
  expect_near(value("#macro Of(H) H(2, 0, 0) #end\n#declare F = function { 3*x }", "Of(F)"), {6, 6, 6});
}

// Values that POV-Ray 3.7 printed.
TEST_F(ImportPovLooks, splines_are_those_of_povray) {
  const std::string points = " -1, <0,0,0>, 0, <1,2,3>, 1.5, <4,1,0>, 2, <2,2,5>, 4, <0,1,1> }";
  expect_near(value("#declare S = spline { cubic_spline" + points, "S(0.8)"),
              {3.11022222, 1.43348148, 0.64088889});
  expect_near(value("#declare S = spline { natural_spline" + points, "S(0.8)"),
              {3.59029333, 1.25454222, -0.35018667});
  expect_near(value("#declare S = spline { quadratic_spline" + points, "S(0.8)"),
              {2.37600000, 2.06400000, 2.52000000});
  // Between (1, 2, 3) at 0 and (4, 1, 0) at 1.5.
  expect_near(value("#declare S = spline {" + points, "S(0.5)"), {2, 2 - 1.0 / 3, 2});
}

TEST_F(ImportPovLooks, objects_are_measured) {
  expect_near(value("#declare B = box { -1, <2, 3, 4> translate x }", "max_extent(B) - min_extent(B)"),
              {3, 4, 5});
  expect_near(value("#declare N = <0,0,0>; #declare P = trace(box { -1, 1 }, <.5, .25, -9>, z, N);", "P + N"),
              {0.5, 0.25, -2});
  expect_near(value("#declare B = difference { box { -1, 1 } box { 0, 2 } }",
                    "<inside(B, -0.5), inside(B, 0.5), inside(B, 3)>"),
              {1, 0, 0});
}

TEST_F(ImportPovLooks, files_of_the_folder_are_read) {
  std::ofstream(folder_ / "below" / "n.txt") << "1.5, <2, -3, 4>, \"name\"\n7";
  expect_near(
      value("#fopen F \"below/n.txt\" read\n#read (F, A, B, C)\n#declare More = defined(F);\n#read (F, D)\n"
            "#declare End = defined(F);\n#fclose F",
            "<A, B.y, D + strlen(C)>"),
      {1.5, -3, 11});
  expect_near(value("#declare S = 0;\n#fopen F \"below/n.txt\" read\n#while (defined(F)) #read (F, A) "
                    "#declare S = S + 1; "
                    "#end",
                    "S"),
              {4, 4, 4});
}

TEST_F(ImportPovLooks, what_a_scene_writes_it_can_read_again) {
  // Strings are written as they are, numbers with all digits; nothing comes to the disk.
  expect_near(value("#fopen F \"own.txt\" write\n#write (F, \"\\\"name\\\",\", 1/3, \",\", <1, 2, 3>)\n"
                    "#fclose F\n#fopen F \"own.txt\" append\n#write (F, \" , 7\")\n#fclose F\n"
                    "#fopen F \"own.txt\" read\n#read (F, A, B, C, D)\n#fclose F",
                    "<strlen(A), B * 3, C.z + D>"),
              {4, 1, 10});
  EXPECT_TRUE(noted("#fopen for writing: no file is written"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "own.txt"));
  expect_near(value("#fopen F \"own.inc\" write\n#write (F, \"#declare Q = 5;\\n\")\n#fclose F\n"
                    "#include \"own.inc\"",
                    "Q"),
              {5, 5, 5});
  EXPECT_NE(refusal("#write (G, 1)").find("expected a file that #fopen has opened for writing"),
            std::string::npos);
}

TEST_F(ImportPovLooks, a_macro_can_close_or_empty_the_file_in_use) {
  EXPECT_NE(refusal("#fopen F \"own.txt\" write\n#write (F, \"1, 2\")\n#fclose F\n#fopen F \"own.txt\" read\n"
                    "#declare A = array[2];\n#macro M() #fclose F 1 #end\n#read (F, A[M()], A[0])")
                .find("the file F has been closed while it is read"),
            std::string::npos);
  expect_near(value("#macro M() #fopen G \"own.txt\" write 7 #end\n#fopen F \"own.txt\" write\n"
                    "#write (F, \"12345678\", M())\n#fclose F\n#fopen F \"own.txt\" read\n#read (F, A)",
                    "A"),
              {7, 7, 7});
}

// An element that is an array is a copy, as in POV-Ray: no array holds itself.
TEST_F(ImportPovLooks, an_array_in_itself_is_a_copy) {
  expect_near(value("#declare A = array[1] { 5 }\n#declare A[0] = A;", "A[0][0]"), {5, 5, 5});
}

// A function of 900 functions within each other: each adds 1.
TEST_F(ImportPovLooks, functions_call_each_other) {
  expect_near(value("#declare F = function(x) { x }\n"
                    "#for (I, 1, 900) #declare F = function(x) { F(x) + 1 } #end",
                    "F(2)"),
              {902, 902, 902});
}

TEST_F(ImportPovLooks, functions_are_those_of_pov_ray) {
  // As POV-Ray 3.7 prints them, at <1, .2, -.7>.
  const std::string at = "(1, .2, -.7", functions = "#include \"functions.inc\"\n";
  const std::vector<std::pair<std::string, double>> cases{
      {"f_sphere" + at + ", 1)", 0.236932},
      {"f_torus" + at + ", 1, .25)", 0.047807},
      {"f_rounded_box" + at + ", .1, 1, .8, .6)", 0.123606},
      {"f_superellipsoid" + at + ", .5, .3)", -0.013764},
      {"f_r" + at + ")", 1.236932},
      {"f_th" + at + ")", 2.181522},
      {"f_ph" + at + ")", 1.408393},
      {"f_ellipsoid" + at + ", 1, 2, 3)", 2.360085},
  };
  for (const auto& [call, expected] : cases) EXPECT_NEAR(value(functions, call).x, expected, 2e-6) << call;
  // Noise lies around 0.5, and is told.
  const double noise = value(functions, "f_noise3d(.3, .4, .5)").x;
  EXPECT_GT(noise, 0);
  EXPECT_LT(noise, 1);
  EXPECT_TRUE(noted("noise is alike POV-Ray's, not the same"));
}

// Compiled bodies have the values of the same expressions outside functions.
TEST_F(ImportPovLooks, functions_are_compiled_as_they_are_read) {
  for (const char* text : {"-x*y + 3/y - 2", "(x > 2 ? y : -y) * 2", "max(x, y, 1.5) - min(x, y)",
                           "!(x = y) + (x <= y & y != 2)", "select(x - y, 1, 2, 3)", "sin(x)*cos(y) + pi",
                           "1 - - x", "V.y * x", "pow(x, y) + mod(7, y)"}) {
    const std::string body = text;
    EXPECT_NEAR(
        value("#declare V = <4, 5, 6>;\n#declare F = function(x, y) { " + body + " };", "F(3, 2)").x,
        value("#declare V = <4, 5, 6>;\n#macro F(X, Y) #local x = X; #local y = Y; (" + body + ") #end",
              "F(3, 2)")
            .x,
        1e-5)
        << body;
  }
  expect_near(value("#declare F = function(x) { -x^2 }; #declare G = function(a, b) { F(a) + F(b)*2 };",
                    "<F(3) + 10, G(1, 2) + 10, 3>"),
              {1, 1, 3});
  EXPECT_NE(refusal("#declare F = function(x) { 1/x };\nbox { 0, F(0) }").find("has no finite value here"),
            std::string::npos);
  expect_near(value("#declare F = function { spline { 0, <0, 0, 0>, 1, <2, 4, 6> } };", "F(0.5)"), {1, 2, 3});
}

TEST_F(ImportPovLooks, a_bad_index_is_skipped_where_unknown_things_are) {
  const std::string text = "#declare A = array[2] { 3, 4 }\nbox { 0, A[-1] }";
  EXPECT_EQ(refusal(text), "room.pov:2: index -1 of the array A, expected 0 to 1");
  options_.skip_unknown = true;
  EXPECT_EQ(refusal(text), "");
  EXPECT_TRUE(noted("index -1 of the array A is taken as the nearest that there is"));
}

}  // namespace
}  // namespace strad
