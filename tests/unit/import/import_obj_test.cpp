// OBJ files become scenes or are refused with file and line; nothing is misread in silence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "import_folder.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

using ImportObj = ImportObjFolder;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\n";

TEST_F(ImportObj, reads_vertices_faces_and_materials) {
  write("m.mtl", "newmtl red wall\nKd 0.5 0.1 0.2 # a comment\nKe 1 2 3\nnewmtl unused\nKd 2 2 2\n");
  const Scene scene = import("mtllib m.mtl\no floor\nusemtl red wall\n" + kSquare + "f 1 2 3 4\n");
  ASSERT_EQ(scene.polygons.size(), 1u);
  EXPECT_EQ(scene.polygons[0].corner_count(), 4);
  EXPECT_EQ(scene.vertices[2], (Vec3{1, 0, -1}));
  EXPECT_EQ(scene.objects[0].name, "floor");
  ASSERT_EQ(scene.materials.size(), 1u);  // only those in use
  EXPECT_EQ(scene.materials[0].name, "red wall");
  EXPECT_EQ(scene.materials[0].reflectance, (Rgb{0.5f, 0.1f, 0.2f}));
  EXPECT_EQ(scene.materials[0].emission, (Rgb{1, 2, 3}));
  EXPECT_TRUE(report_.lines().empty());
}

TEST_F(ImportObj, understands_all_spellings_of_numbers_and_indices) {
  const Scene scene = import(
      "v +1e0 .5 -.25\r\nv 1. 2E-1 3e+0\r\nv 0 0 0 1.0\r\nv 5 6 7 0.1 0.2 0.3\r\nvt 0\r\nvt 0 1 0\r\nvn 0 0 "
      "1\r\n"
      "f -4/1/1 -3//1 -2/-1\r\nf 1// \\\r\n  3/ \\\r\n  4\r\n");
  ASSERT_EQ(scene.polygons.size(), 2u);
  EXPECT_EQ(scene.vertices[0], (Vec3{1, 0.5, -0.25}));
  EXPECT_EQ(scene.vertices[1], (Vec3{1, 0.2f, 3}));
  EXPECT_EQ(scene.polygons[1].corners[1], 2u);
  EXPECT_EQ(scene.polygons[1].corners[2], 3u);
}

TEST_F(ImportObj, takes_faces_before_their_vertices) {
  EXPECT_EQ(import("f 1 2 3\n" + kSquare).polygons.size(), 1u);
}

TEST_F(ImportObj, a_backslash_that_ends_a_comment_swallows_nothing) {
  EXPECT_EQ(import("# C:\\models\\\n" + kSquare + "f 1 2 3 4").vertices.size(), 4u);
}

TEST_F(ImportObj, names_objects_by_object_and_group) {
  const std::string f = "f 1 2 3 4\n";
  const Scene scene = import(kSquare + f + "g front  cube\n" + f + "o lamp\n" + f + "g lamp\n" + f +
                             "g shade\n" + f + "g\n" + f + "o lamp\ng shade\n" + f + "o empty\n");
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  EXPECT_EQ(names, (std::vector<std::string>{"unnamed", "front cube", "lamp", "lamp/shade"}));
  EXPECT_EQ(scene.polygons[6].object, 3u);
}

TEST_F(ImportObj, refuses_with_file_and_line) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "room.obj: is empty"},
      {"# nothing\n", "room.obj: has no polygons"},
      {kSquare + "l 1 2\np 1\n", "room.obj: has no polygons"},
      {std::string("v\0 0", 4), "room.obj: is not a text file: byte 0 at offset 1"},
      {"\xff\xfev\0", "room.obj: is UTF-16 text, expected ASCII or UTF-8"},
      {"v\n", "room.obj:1: v has 0 numbers, expected 3 to 7"},
      {"v 1\n", "room.obj:1: v has 1 numbers, expected 3 to 7"},
      {"\nv 1 2 # 3\n", "room.obj:2: v has 2 numbers, expected 3 to 7"},
      {"v 0,5 0 0\n", "room.obj:1: found \"0,5\", expected a finite number"},
      {"v nan 0 0\n", "room.obj:1: found \"nan\", expected a finite number"},
      {"v -inf 0 0\n", "room.obj:1: found \"-inf\", expected a finite number"},
      {"v 1e999 0 0\n", "room.obj:1: found \"1e999\", expected a finite number"},
      {"v 1e39 0 0\n", "room.obj:1: found \"1e39\", expected a finite number"},
      {"v 0x10 0 0\n", "room.obj:1: found \"0x10\", expected a finite number"},
      {"v 1.#IND 0 0\n", "room.obj:1: found \"1.#IND\", expected a finite number"},
      {"v +-1 0 0\n", "room.obj:1: found \"+-1\", expected a finite number"},
      {kSquare + "f 1 2 99\n" + kSquare, "room.obj:5: face uses vertex 99 of 8"},
      {kSquare + "f 1 2 0\n", "room.obj:5: face uses vertex 0, but they count from 1"},
      {kSquare + "f 1 2 -5\n", "room.obj:5: face uses vertex -5 of 4"},
      {kSquare + "f 1 2 99999999999\n", "room.obj:5: face uses vertex 99999999999 of 4"},
      {kSquare + "f 1/1 2/2 3/3\n", "room.obj:5: face uses texture coordinate 3 of 0"},
      {kSquare + "f 1 2 x\n", "room.obj:5: found \"x\", expected the number of a vertex"},
      {kSquare + "f 1 2 3.5\n", "room.obj:5: found \"3.5\", expected the number of a vertex"},
      {kSquare + "vt 0\nf 1/1/1/1 2 3\n", "room.obj:6: found \"1/1\", expected the number of a normal"},
      {kSquare + "vt 0 x\n", "room.obj:5: found \"x\", expected a finite number"},
      {"vertex 0 0 0\n", "room.obj:1: found \"vertex\", expected an OBJ statement such as v, f or usemtl"},
      {"mtllib\n", "room.obj:1: mtllib names no file"},
      {"mtllib none.mtl\n", "room.obj:1: material file \"none.mtl\" is missing"},
      {kSquare + "usemtl a\n\nf 1 2 3\n", "room.obj:7: material \"a\" is not defined"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(refusal(text), expected) << text;
}

TEST_F(ImportObj, refuses_a_folder_and_a_file_that_is_not_there) {
  EXPECT_THROW(import_obj(folder_.string(), options_, &report_), BadInput);
  EXPECT_THROW(import_obj(path("absent.obj"), options_, &report_), IoError);
}

TEST_F(ImportObj, refuses_broken_materials_with_their_line) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "m.mtl: is empty"},
      {"Kd 1 1 1\n", "m.mtl:1: found \"Kd\", expected newmtl before all else"},
      {"newmtl\n", "m.mtl:1: newmtl has no name"},
      {"newmtl a\nKd 1 1\n", "m.mtl:2: Kd has 2 numbers, expected R G B"},
      {"newmtl a\nKd 1 1 1 1\n", "m.mtl:2: Kd has 4 numbers, expected R G B"},
      {"newmtl a\nKd 0.5 nan 1\n", "m.mtl:2: Kd: found \"nan\", expected a finite number"},
      {"newmtl a\nKd 0.5 -1 1\n", "m.mtl:2: Kd -1 is negative"},
      {"newmtl a\nKd 0.5 1.5 1\n", "m.mtl:2: reflectance 1.500000, expected 0 to 1"},
      {"newmtl a\nKd spectral f.rfl\n", "m.mtl:2: Kd spectral is not supported, expected R G B"},
      {"newmtl a\nKe 1 1 inf\n", "m.mtl:2: Ke: found \"inf\", expected a finite number"},
      {"newmtl a\nmap_Kd -s 1 1 1\n", "m.mtl:2: map_Kd names no file"},
  };
  for (const auto& [text, expected] : cases) {
    write("m.mtl", text);
    EXPECT_EQ(refusal("mtllib m.mtl\nusemtl a\n" + kSquare + "f 1 2 3 4\n"), expected);
  }
}

TEST_F(ImportObj, counts_what_it_leaves_out) {
  const Scene scene = import(kSquare + "v 0.5 0 0\nf 1 1 1\nf 1 2\nf 1 2 5\nf 1 2 3 4\nf 1 1 2 3\nl 1 2\n" +
                             "f 1//7 2//8 3//9\n");
  EXPECT_EQ(scene.polygons.size(), 3u);
  EXPECT_EQ(note(0), "room.obj:6: degenerate face left out (3 in all)");
  EXPECT_EQ(note(1), "room.obj:11: line left out");
}

TEST_F(ImportObj, skips_what_is_missing_or_unknown_only_when_told) {
  const std::string text = "mtllib none.mtl\nwhatever 1\nusemtl a\n" + kSquare + "f 1 2 3 4\n";
  options_.skip_unknown = options_.skip_missing = true;
  const Scene scene = import(text);
  EXPECT_EQ(scene.materials[0].name, "a");
  EXPECT_EQ(scene.materials[0].reflectance, (Rgb{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(report_.lines().size(), 3u);
}

TEST_F(ImportObj, lowers_a_reflectance_of_one_and_says_so) {
  write("m.mtl", "newmtl a\nKd 1 0.5 1\nnewmtl b\nKd 1\n");
  const Scene scene = import("mtllib m.mtl\nusemtl a\n" + kSquare + "f 1 2 3\nusemtl b\nf 1 3 4\n");
  EXPECT_EQ(scene.materials[0].reflectance, (Rgb{0.98f, 0.5f, 0.98f}));
  EXPECT_EQ(scene.materials[1].reflectance, (Rgb{0.98f, 0.98f, 0.98f}));
  EXPECT_EQ(
      note(0),
      "m.mtl:2: reflectance above 0.98 is taken as 0.98: light must fade as it is reflected (2 in all)");
}

TEST_F(ImportObj, finds_material_files_whose_names_hold_blanks) {
  write("my room.mtl", "newmtl a\nKd 0.1 0.1 0.1\n");
  write("b.mtl", "newmtl b\nKd 0.2 0.2 0.2\nnewmtl a\nKd 0.3 0.3 0.3\n");
  write("c.mtl", "newmtl c\nKd 0.4 0.4 0.4\n");
  const Scene scene =
      import("mtllib my room.mtl\nmtllib b.mtl c.mtl\nusemtl a\n" + kSquare + "f 1 2 3\nusemtl c\nf 1 3 4\n");
  EXPECT_EQ(scene.materials[0].reflectance.r, 0.1f);
  EXPECT_EQ(scene.materials[1].reflectance.r, 0.4f);
  EXPECT_EQ(note(0), "b.mtl:3: material \"a\" is defined again: left out");
}

// A texture of one red and one white pixel, as PPM.
const std::string kPixels = std::string("P6 2 1 255\n\xff\x00\x00\xff\xff\xff", 17);

TEST_F(ImportObj, reads_textures_once_and_keeps_their_coordinates) {
  fs::create_directories(folder_ / "tex");
  write("tex/my wall.ppm", kPixels);
  write("m.mtl",
        "newmtl a\nmap_Kd -bm 2 tex\\my wall.ppm\nnewmtl b\nKd 0.5 0.5 0.5\n"
        "map_Kd tex/my wall.ppm\nnewmtl plain\nKd 0.5 0.5 0.5\n");
  const Scene scene =
      import("mtllib m.mtl\n" + kSquare +
             "vt 0 0\nvt 0.25 0\nvt 1 1\nvt 9 9\nusemtl plain\nf 1/4 2/4 3/4\nusemtl a\nf 1/1 2/2 3/3\n"
             "usemtl b\nf 1/1 3/3 4/2\nf 1 3 4\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].width, 2u);
  EXPECT_EQ(scene.textures[0].srgb[1], 0);
  EXPECT_EQ(scene.materials[1].texture, 0u);
  EXPECT_EQ(scene.materials[1].reflectance.r,
            kMaxReflectance);       // no Kd: as much as is allowed, times the texture
  EXPECT_EQ(scene.uvs.size(), 3u);  // those of the material without a texture are dropped
  EXPECT_EQ(scene.uvs[scene.polygons[1].uvs[1]], (Vec2{0.25, 0}));
  EXPECT_EQ(scene.polygons[0].uvs[0], kNone);
  EXPECT_EQ(scene.polygons[3].uvs[0], kNone);
  EXPECT_EQ(note(0), "m.mtl:2: map_Kd option -bm is ignored");
  EXPECT_EQ(note(1), "room.obj:16: face of a material with a texture has no texture coordinates");
}

TEST_F(ImportObj, places_textures_as_options_say) {
  write("t.ppm", kPixels);
  write("m.mtl",
        "newmtl plain\nmap_Kd t.ppm\nnewmtl placed\nmap_Kd -s 2 3 1 -o 0.5 -clamp on t.ppm\n"
        "newmtl again\nmap_Kd -clamp on -o 0.25 0.5 t.ppm\n");
  const Scene scene = import("mtllib m.mtl\n" + kSquare +
                             "vt 0 0\nvt 1 0\nvt 1 1\nusemtl plain\nf 1/1 2/2 3/3\nusemtl placed\n"
                             "f 1/1 2/2 3/3\nusemtl again\nf 1/1 2/2 3/3\n");
  EXPECT_TRUE(report_.lines().empty());
  // Coordinates are scaled, then moved: (1, 1) to (2 + 0.5, 3 + 0), and (1 + 0.25, 1 + 0.5).
  const auto uv = [&](size_t polygon) { return scene.uvs[scene.polygons[polygon].uvs[2]]; };
  EXPECT_EQ(uv(0), (Vec2{1, 1}));
  EXPECT_EQ(uv(1), (Vec2{2.5, 3}));
  EXPECT_EQ(uv(2), (Vec2{1.25, 1.5}));
  // Once as it repeats, once as it is clamped.
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_FALSE(scene.textures[scene.materials[0].texture].clamp);
  EXPECT_TRUE(scene.textures[scene.materials[1].texture].clamp);
  EXPECT_EQ(scene.materials[1].texture, scene.materials[2].texture);
}

// Two pixels, grey: what is left of a surface is its left half. They may belong to a map_Kd or stand alone.
TEST_F(ImportObj, map_d_gives_holes) {
  write("t.ppm", kPixels);
  write("h.ppm", "P6\n2 1\n255\n\xff\xff\xff" + std::string(3, '\0'));
  write("m.mtl",
        "newmtl a\nmap_Kd t.ppm\nmap_d h.ppm\nnewmtl b\nKd 0.2 0.3 0.4\nmap_d -s 2 h.ppm\nnewmtl c\nmap_Kd "
        "t.ppm\n"
        "newmtl d\nKd 0 0 0\nKe 1 1 1\nmap_d h.ppm\n");
  const std::string face = "f 1/1 2/2 3/3\n";
  const Scene scene = import("mtllib m.mtl\n" + kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nusemtl a\n" + face +
                             "usemtl b\n" + face + "usemtl c\n" + face + "usemtl d\n" + face);
  const auto opacity = [&](size_t m) { return scene.textures[scene.materials[m].texture].opacity.values; };
  EXPECT_EQ(opacity(0), (std::vector<uint8_t>{255, 0}));
  EXPECT_EQ(scene.textures[scene.materials[0].texture].srgb.size(), 6u);
  EXPECT_EQ(opacity(1), (std::vector<uint8_t>{255, 0}));
  EXPECT_EQ(scene.textures[scene.materials[1].texture].srgb, (std::vector<uint8_t>{255, 255, 255}));
  EXPECT_EQ(scene.materials[1].reflectance, (Rgb{0.2f, 0.3f, 0.4f}));
  EXPECT_EQ(scene.uvs[scene.polygons[1].uvs[1]], (Vec2{2, 0}));
  EXPECT_TRUE(opacity(2).empty());
  EXPECT_EQ(note(0), "m.mtl:12: a material that emits has no holes");
  EXPECT_EQ(report_.lines().size(), 1u);
  fs::remove(folder_ / "h.ppm");
  EXPECT_TRUE(refusal("mtllib m.mtl\nusemtl b\n" + kSquare + "f 1 2 3\n").starts_with("m.mtl:6: texture \""));
}

TEST_F(ImportObj, names_once_what_has_no_effect) {
  write("m.mtl",
        "newmtl a\nKa 0.2 0.2 0.2\nKd 0.5 0.5 0.5\nKs 0.1 0.1 0.1\nNs 30\nNi 1.45\nd 0.5\nillum 8\nPr 0.3\n"
        "map_Bump b.png\nmap_Ks s.png\nTf 1 0.5 0.5\nrefl -type sphere r.png\n"
        "newmtl b\nKd 0.5 0.5 0.5\nNi 1.3\nmap_Bump c.png\n"
        "newmtl silent\nKa 0 0 0\nKd 0.5 0.5 0.5\nKs 0 0 0\nNs 0\nNi 1\nd 1\nTr 0\nillum 2\nPr 0\n");
  import("mtllib m.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nusemtl silent\nf 1 2 3\n");
  EXPECT_EQ(report_.lines(),
            (std::vector<std::string>{path("room.obj") + ":2: vertex colour left out (3 in all)"}));
  import("mtllib m.mtl\n" + kSquare + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
  std::vector<std::string> notes;
  for (size_t i = 0; i < report_.lines().size(); ++i) notes.push_back(note(i));
  EXPECT_EQ(notes, (std::vector<std::string>{
                       "m.mtl:2: Ka is ignored: all light is computed",
                       "m.mtl:4: Ks is ignored: surfaces are diffuse", "m.mtl:5: Ns is ignored",
                       "m.mtl:6: Ni is ignored (2 in all)", "m.mtl:7: d is ignored: surfaces are opaque",
                       "m.mtl:8: illum is ignored", "m.mtl:9: Pr is ignored",
                       "m.mtl:10: map_Bump is ignored (2 in all)", "m.mtl:11: map_Ks is ignored",
                       "m.mtl:12: Tf is ignored", "m.mtl:13: refl is ignored"}));
}

TEST_F(ImportObj, illum_makes_mirrors_and_glass) {
  write("m.mtl",
        "newmtl usual\nKd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nNs 250\nNi 1.45\nd 1\nillum 2\n"
        "newmtl mirror\nKd 0.4 0.4 0.4\nKs 0.9 0.6 0.3\nNs 198\nillum 3\n"
        "newmtl varnish\nKd 0.5 0.5 0.5\nKs 1 1 1\nNi 1.5\nillum 5\n"
        "newmtl clear\nKd 0.8 0.8 0.8\nNi 1.5\nTf 0.9 0.8 0.7\nillum 7\n"
        "newmtl milky\nKd 0.8 0.8 0.8\nKs 0 0 0\nd 0.75\nNi 1.3\nillum 9\n"
        "newmtl glowing\nKd 0.5 0.5 0.5\nKe 1 1 1\nillum 4\n");
  const Scene scene = import("mtllib m.mtl\n" + kSquare +
                             "usemtl usual\nf 1 2 3\nusemtl mirror\nf 1 2 3\nusemtl varnish\nf 1 2 3\n"
                             "usemtl clear\nf 1 2 3\nusemtl milky\nf 1 2 3\nusemtl glowing\nf 1 2 3\n");
  const std::vector<Material>& m = scene.materials;
  EXPECT_EQ(m[0].finish, Finish{});  // what exporters write of any surface stays diffuse
  EXPECT_EQ(m[0].reflectance, (Rgb{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(m[1].finish.specular, (Rgb{0.9f, 0.6f, 0.3f}));
  EXPECT_FLOAT_EQ(m[1].finish.roughness, 0.1f);  // sqrt(2 / (198 + 2))
  // 1 - 0.9 is left of red, 1 - 0.6 of green; 1 - 0.3 of blue is more than there is.
  EXPECT_NEAR(m[1].reflectance.r, 0.1f, 1e-6f);
  EXPECT_NEAR(m[1].reflectance.g, 0.4f, 1e-6f);
  EXPECT_NEAR(m[1].reflectance.b, 0.4f, 1e-6f);
  EXPECT_TRUE(m[2].finish.fresnel);
  EXPECT_EQ(m[2].reflectance, (Rgb{0.5f, 0.5f, 0.5f}));  // 0.04 is mirrored at right angles
  EXPECT_EQ(m[3].finish.transmission, (Rgb{0.9f, 0.8f, 0.7f}));
  EXPECT_EQ(m[3].finish.specular, (Rgb{1, 1, 1}));
  EXPECT_TRUE(m[3].finish.fresnel);
  EXPECT_TRUE(is_black(m[3].reflectance));
  EXPECT_EQ(m[4].finish.transmission, (Rgb{0.25f, 0.25f, 0.25f}));  // 1 - d
  EXPECT_NEAR(m[4].reflectance.r, 0.6f, 1e-6f);                     // d Kd
  EXPECT_EQ(m[5].finish, Finish{});
}

// The sides of a column of `sides` quads about the y axis, of radius 1; counter-clockwise from outside.
std::string column(int sides, const std::function<std::string(int corner)>& normal_of_corner) {
  std::string vertices, faces;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    for (const double y : {0.0, 2.0})
      vertices += "v " + std::to_string(std::sin(angle)) + " " + std::to_string(y) + " " +
                  std::to_string(std::cos(angle)) + "\n";
    faces += "f";
    const int next = (i + 1) % sides;
    for (const int corner : {2 * i + 1, 2 * next + 1, 2 * next + 2, 2 * i + 2})
      faces += " " + std::to_string(corner) + normal_of_corner(corner);
    faces += "\n";
  }
  return vertices + faces;
}

// Is the normal at each corner that of the round column?
void expect_round(const Scene& scene, double tolerance) {
  for (const Polygon& polygon : scene.polygons) {
    ASSERT_TRUE(polygon.is_smooth());
    for (int c = 0; c < polygon.corner_count(); ++c) {
      const Vec3 at = scene.vertices[polygon.corners[c]];
      EXPECT_LT(length(scene.normals[polygon.normals[c]] - Vec3{at.x, 0, at.z}), tolerance);
    }
  }
}

TEST_F(ImportObj, takes_normals_of_any_length_and_either_winding) {
  std::string normals;
  for (int i = 0; i < 8; ++i)
    normals += "vn " + std::to_string(2 * std::sin(kPi / 4 * i)) + " 0 " +
               std::to_string(2 * std::cos(kPi / 4 * i)) + "\n";
  const auto of_corner = [](int corner) { return "//" + std::to_string((corner + 1) / 2); };
  const Scene scene = import(normals + column(8, of_corner));
  expect_round(scene, 1e-4);
  EXPECT_EQ(scene.normals.size(), 8u);    // each once
  EXPECT_EQ(report_.lines().size(), 1u);  // that there is no material, and nothing of normals
  // Inside out: faces stay as they are wound, and the normals follow them.
  std::string inwards;
  for (int i = 0; i < 8; ++i)
    inwards += "vn " + std::to_string(-std::sin(kPi / 4 * i)) + " 0 " +
               std::to_string(-std::cos(kPi / 4 * i)) + "\n";
  expect_round(import(inwards + column(8, of_corner)), 1e-4);
}

TEST_F(ImportObj, smooths_groups_and_angles_where_there_are_no_normals) {
  const auto none = [](int) { return ""; };
  // In a group: at each corner two quads of equal angle meet, whose mean is the round normal.
  expect_round(import("s 3\n" + column(8, none)), 1e-4);
  for (const char* off : {"", "s off\n", "s 0\n"})
    EXPECT_TRUE(import(off + column(8, none)).normals.empty()) << off;
  // By angle: quads meet at 45 degrees.
  options_.smooth = 46 * kPi / 180;
  expect_round(import(column(8, none)), 1e-4);
  options_.smooth = 44 * kPi / 180;
  EXPECT_TRUE(import(column(8, none)).normals.empty());
  // Two groups meet in an edge.
  options_.smooth = 0;
  const Scene parted =
      import("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\ns 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n");
  EXPECT_TRUE(parted.normals.empty());
}

TEST_F(ImportObj, stays_flat_where_normals_say_so_or_contradict) {
  options_.smooth = kPi;
  const std::string ridge = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\nvn 0 0 1\nvn 1 0 0\n";
  const Scene flat = import(ridge + "f 1//1 2//1 3//1 4//1\nf 2//2 5//2 6//2 3//2\n");
  EXPECT_TRUE(flat.normals.empty());
  const Scene contrary = import(ridge + "vn 0 0 -1\nf 1//1 2//3 3//1 4//1\n");
  EXPECT_TRUE(contrary.normals.empty());
  EXPECT_EQ(note(1), "room.obj:10: face whose normals lie on both of its sides is drawn flat");
  EXPECT_NE(refusal("s x\n" + ridge + "f 1 2 3\n").find("found s \"x\", expected off"), std::string::npos);
}

TEST_F(ImportObj, refuses_a_texture_that_is_missing_or_broken) {
  write("m.mtl", "newmtl a\nKd 0.5 0.5 0.5\nmap_Kd t.ppm\n");
  const std::string text = "mtllib m.mtl\nusemtl a\n" + kSquare + "f 1 2 3\n";
  EXPECT_TRUE(refusal(text).starts_with("m.mtl:3: texture \"")) << refusal(text);
  write("t.ppm", kPixels.substr(0, 14));
  EXPECT_TRUE(refusal(text).starts_with("m.mtl:3: ")) << refusal(text);
  options_.skip_missing = true;
  fs::remove(folder_ / "t.ppm");
  EXPECT_EQ(import(text).materials[0].texture, kNone);
}

TEST_F(ImportObj, lights_materials_by_pattern) {
  write("m.mtl", "newmtl lamp1\nKd 0 0 0\nKe 1 1 1\nnewmtl lamp2\nKd 0 0 0\n");
  const std::string text = "mtllib m.mtl\nusemtl lamp1\n" + kSquare + "f 1 2 3\nusemtl lamp2\nf 1 3 4\n";
  options_.lights = {{"lamp*", {5, 6, 7}}, {"lamp1", {8, 8, 8}}};
  const Scene scene = import(text);
  EXPECT_EQ(scene.materials[0].emission, (Rgb{8, 8, 8}));
  EXPECT_EQ(scene.materials[1].emission, (Rgb{5, 6, 7}));
  options_.lights = {{"lump*", {5, 6, 7}}};
  EXPECT_EQ(refusal(text), "room.obj: no material in use matches the light \"lump*\"");
}

TEST_F(ImportObj, refuses_scales_that_no_stream_can_hold) {
  for (const double scale : {1e300, 1e16, 1e-10, 1e-300}) {
    options_.scale = scale;
    const std::string said = refusal(kSquare + "f 1 2 3 4\n");
    EXPECT_TRUE(said.starts_with("room.obj: ")) << scale << ": " << said;
  }
  for (const double scale : {1e14, 1e-8}) {
    options_.scale = scale;
    EXPECT_EQ(refusal(kSquare + "f 1 2 3 4\n"), "");
  }
}

TEST_F(ImportObj, takes_names_that_are_not_utf8_as_latin1) {
  write("m.mtl", "newmtl gr\xfcn\nnewmtl \xc3\xa9t\xc3\xa9\n");
  const Scene scene = import("mtllib m.mtl\n" + kSquare +
                             "o T\xfcr\nusemtl gr\xfcn\nf 1 2 3\nusemtl \xc3\xa9t\xc3\xa9\nf 1 3 4\n");
  EXPECT_EQ(scene.objects[0].name, "T\xc3\xbcr");
  EXPECT_EQ(scene.materials[0].name, "gr\xc3\xbcn");
  EXPECT_EQ(scene.materials[1].name, "\xc3\xa9t\xc3\xa9");
  EXPECT_EQ(note(0), "room.obj: 2 names that are not UTF-8 are taken as Latin-1, such as \"gr\xc3\xbcn\"");
}

// Floats at 1e6 are 1/16 apart, so rounding changes a coordinate by up to 1/32; at 1e3 by less than 1e-4.
TEST_F(ImportObj, tells_when_floats_cannot_hold_the_vertices) {
  import("v 1000000 0 0\nv 1000001 0 0\nv 1000001 1 0\nf 1 2 3\n");
  EXPECT_EQ(note(1), "room.obj: so far from the origin, vertices are stored with errors of up to 0.03 m");
  import("v 1000 0 0\nv 1001 0 0\nv 1001 1 0\nf 1 2 3\n");
  EXPECT_EQ(note(1), "");
}

TEST_F(ImportObj, tells_of_lamps_that_lie_on_one_another) {
  write("m.mtl", "newmtl lamp\nKd 0 0 0\nKe 1 1 1\nnewmtl grey\nKd 0.5 0.5 0.5\n");
  const std::string lamp = "mtllib m.mtl\n" + kSquare + "usemtl lamp\no a\nf 1 2 3 4\n";
  import(lamp + "o b\nf 2 3 4 1\nv 0 0 0\no c\nf 5 2 3 4\n");  // from another corner, and by another vertex
  EXPECT_EQ(note(0),
            "room.obj: 2 emitting polygons lie exactly on others, such as one of \"b\": their light adds up");
  import(lamp +
         "o b\nf 4 3 2 1\nusemtl grey\nf 1 2 3 4\nusemtl lamp\nf 1 2 3\n");  // back to back, dark, smaller
  EXPECT_EQ(note(0), "");
}

TEST_F(ImportObj, scales_and_turns) {
  options_.scale = 0.01;
  options_.up = 'z';
  // A floor at height 3 in a file whose z is up, seen from above: its front must still look up.
  const Scene scene = import("v 0 0 3\nv 100 0 3\nv 0 100 3\nf 1 2 3\n");
  const auto& v = scene.vertices;
  EXPECT_NEAR(v[0].y, 0.03, 1e-9);
  EXPECT_NEAR(v[2].z, -1, 1e-9);
  EXPECT_GT(cross(v[1] - v[0], v[2] - v[0]).y, 0);
}

TEST_F(ImportObj, drops_vertices_that_nothing_uses) {
  EXPECT_EQ(import("v 9 9 9\n" + kSquare + "v 8 8 8\nf 2 3 4 5\n").vertices.size(), 4u);
}

TEST_F(ImportObj, names_every_truncation_or_imports_it) {
  write("m.mtl", "newmtl a\nKd 0.5 0.5 0.5\n");
  const std::string text =
      "mtllib m.mtl\nusemtl a\n" + kSquare + "vt 0 0\ng one two\nf 1/1 2/1 3/1 4/-1 \\\n 1\nf 1 2 3\n";
  for (size_t size = 0; size < text.size(); ++size) {
    try {
      EXPECT_FALSE(import(text.substr(0, size)).polygons.empty());
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("room.obj"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace strad
