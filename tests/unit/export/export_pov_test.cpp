// What the files for POV-Ray say. That POV-Ray shows them as strad-frame does is shown by
// tests/pipelines/pov_*.sh.
#include <gtest/gtest.h>

#include "base/error.h"
#include "export/pov/pov.h"
#include "export_scene.h"

namespace strad {
namespace {

// The square lit by direct 2 and indirect 1 W / m^2 everywhere: L = 0.5 * 3 / pi = 0.47746 all light
// together, and E / pi = 0.31831 of the indirect light.
Solution lit_square(const Scene& scene) {
  MeshBuilder builder(scene);
  builder.face(0, 0);
  const auto two = [](Vec3) { return grey(2); };
  const auto one = [](Vec3) { return grey(1); };
  return {{lit_slab(scene, builder.take(), two, one)}};
}

PovOptions options_for(const Scene& scene, PovLighting light) {
  PovOptions options;
  options.pattern = "out/s.%03d.inc";
  options.light = light;
  options.camera = scene.cameras[0];
  return options;
}

std::string find(const std::vector<ExportFile>& files, const std::string& name) {
  for (const ExportFile& file : files) {
    if (file.name == name) return file.bytes;
  }
  return "no file " + name;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PovExport, BakedCornersHoldRadiance) {
  const Scene scene = square_scene();
  const Solution solution = lit_square(scene);
  const PovExport pov(scene, solution, {{1, 0}}, options_for(scene, PovLighting::kBaked));
  const ExportFile frame = pov.frame_file(0);
  EXPECT_EQ(frame.name, "out/s.001.inc");
  EXPECT_TRUE(holds(frame.bytes, "array[4]")) << frame.bytes;
  EXPECT_TRUE(holds(frame.bytes, "<47746e-5,47746e-5,47746e-5>")) << frame.bytes;
  EXPECT_FALSE(holds(frame.bytes, "light_source"));
}

TEST(PovExport, OtherwiseCornersHoldIndirectRadiosityOfWhite) {
  const Scene scene = square_scene();
  const Solution solution = lit_square(scene);
  const PovExport pov(scene, solution, {{1, 0}}, options_for(scene, PovLighting::kLights));
  EXPECT_TRUE(holds(pov.frame_file(0).bytes, "<31831e-5,31831e-5,31831e-5>")) << pov.frame_file(0).bytes;
  const std::string geometry = find(pov.common_files(), "out/s_geometry.inc");
  EXPECT_TRUE(holds(geometry, "strad_pigment_white = pigment { rgb <50000e-5,50000e-5,50000e-5> }"))
      << geometry;
  EXPECT_TRUE(holds(geometry, "diffuse 1")) << geometry;
}

TEST(PovExport, MirrorsAndGlassKeepTheirFinish) {
  Scene scene = square_scene();
  scene.materials[0].finish.specular = {0.25f, 0.25f, 0.5f};
  const auto geometry = [&] {
    const Solution solution = lit_square(scene);
    const PovExport pov(scene, solution, {{1, 0}}, options_for(scene, PovLighting::kBaked));
    return find(pov.common_files(), "out/s_geometry.inc");
  };
  EXPECT_TRUE(holds(geometry(), "reflection { rgb <25000e-5,25000e-5,50000e-5> }")) << geometry();
  // Half opaque: POV-Ray halves the light of the pigment, which is therefore doubled.
  scene.materials[0].finish = {{1, 1, 1}, 0, {0.5f, 0.5f, 0.5f}, 1.5f, true, false};
  EXPECT_TRUE(holds(geometry(), "rgb strad_radiance_world[strad_i]/0.500000 transmit 0.500000"))
      << geometry();
  EXPECT_TRUE(holds(geometry(), "fresnel on")) << geometry();
  scene.materials[0].reflectance = {};
  EXPECT_TRUE(holds(geometry(), "rgb <50000e-5,50000e-5,50000e-5> filter 1 }")) << geometry();
  EXPECT_FALSE(holds(geometry(), "interior_texture"));  // else its inner side would be black
  EXPECT_FALSE(holds(geometry(), "ior"));               // a pane bends nothing
}

// Le + rho E / pi = 3 * 2 + 0.15915 in red; black paint still emits: the value times the least pigment.
TEST(PovExport, EmittersGlowWhateverTheyReflect) {
  Scene scene = square_scene();
  scene.materials[0].emission = {2, 2, 2};
  scene.materials[0].reflectance = {0.5f, 0, 0.5f};
  scene.glows = {{.material = 0, .keys = {{.time = 0, .value = 3}}}};
  const Solution solution = lit_square(scene);
  const PovExport pov(scene, solution, {{1, 0}}, options_for(scene, PovLighting::kLights));
  const std::string frame = pov.frame_file(0).bytes;
  EXPECT_TRUE(holds(frame, "<12318e-3,60000,12318e-3>")) << frame;
  EXPECT_TRUE(holds(frame, "#declare strad_lamp_white"));
  EXPECT_TRUE(holds(find(pov.common_files(), "out/s_geometry.inc"), "rgb <50000e-5,10000e-8,50000e-5>"));
}

TEST(PovExport, DarkLampsAndSpotsAreLeftOut) {
  Scene scene = square_scene();
  scene.materials[0].emission = {2, 2, 2};
  scene.glows = {{.material = 0, .keys = {{.time = 0, .value = 0}}}};
  scene.spots = {
      {.name = "key", .inner = 0.1, .outer = 0.2, .keys = {{.at = {0, 0, 1}, .aim = {}, .intensity = {}}}}};
  const Solution solution = lit_square(scene);
  const PovExport pov(scene, solution, {{1, 0}}, options_for(scene, PovLighting::kLights));
  EXPECT_FALSE(holds(pov.frame_file(0).bytes, "light_source"));
  EXPECT_TRUE(holds(pov.frame_file(0).bytes, "#macro strad_lights()\n#end"));
}

TEST(PovExport, IniCoversTheFrames) {
  const Scene scene = square_scene();
  const Solution solution = lit_square(scene);
  const PovExport pov(scene, solution, {{3, 0.2}, {5, 0.4}, {7, 0.6}},
                      options_for(scene, PovLighting::kBaked));
  const std::string ini = find(pov.common_files(), "out/s.ini");
  for (const char* line :
       {"Input_File_Name=\"s.pov\"\n", "Library_Path=\"out/\"\n", "Initial_Frame=3\n", "Final_Frame=7\n",
        "Frame_Step=2\n", "Initial_Clock=0.2\n", "Final_Clock=0.6\n", "Width=640\n", "Height=480\n"}) {
    EXPECT_TRUE(holds(ini, line)) << line << "in\n" << ini;
  }
}

// The second slab has its own mesh, so its own geometry, which its frames name.
TEST(PovExport, EachSlabHasItsGeometry) {
  Scene scene = square_scene();
  Solution solution = lit_square(scene);
  solution.slabs.push_back(solution.slabs[0]);
  solution.slabs[0].grid.spans[0].end = 0.5;
  solution.slabs[1].grid.spans[0].begin = 0.5;
  const PovExport pov(scene, solution, {{1, 0}, {6, 0.5}}, options_for(scene, PovLighting::kBaked));
  EXPECT_TRUE(holds(pov.frame_file(0).bytes, "strad_geometry = \"s_geometry.inc\""));
  EXPECT_TRUE(holds(pov.frame_file(1).bytes, "strad_geometry = \"s_geometry2.inc\""));
  EXPECT_TRUE(holds(find(pov.common_files(), "out/s_geometry2.inc"), "strad_body_world"));
}

TEST(PovExport, TexturesAreWrittenLinearTimesReflectance) {
  Scene scene = square_scene();
  scene.textures = {{.name = "t", .width = 1, .height = 1, .srgb = {255, 188, 0}}};
  scene.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.materials[0].texture = 0;
  for (uint32_t i = 0; i < 4; ++i) scene.polygons[0].uvs[i] = i;
  const Solution solution = lit_square(scene);
  for (const PovLighting light : {PovLighting::kBaked, PovLighting::kLights}) {
    const PovExport pov(scene, solution, {{1, 0}}, options_for(scene, light));
    const std::string ppm = find(pov.common_files(), "out/s_texture1.ppm");
    ASSERT_EQ(ppm.size(), 19u) << ppm;
    // 0.5 of white; sRGB 188 is 0.5029 linear, half of it 0.25144; as 16-bit words.
    const auto word = [&](size_t i) {
      return 256 * static_cast<unsigned char>(ppm[i]) + static_cast<unsigned char>(ppm[i + 1]);
    };
    EXPECT_EQ(word(13), 32768);
    EXPECT_NEAR(word(15) / 65535.0, 0.25144, 1e-4);
    EXPECT_EQ(word(17), 0);
    EXPECT_TRUE(holds(find(pov.common_files(), "out/s_geometry.inc"), "uv_vectors { 4,"));
  }
}

TEST(PovExport, RefusesNoFramesAndBadNumbersOfLights) {
  const Scene scene = square_scene();
  const Solution solution = lit_square(scene);
  PovOptions options = options_for(scene, PovLighting::kLights);
  EXPECT_THROW(PovExport(scene, solution, {}, options), BadInput);
  options.lamp_samples = 0;
  EXPECT_THROW(PovExport(scene, solution, {{1, 0}}, options), BadInput);
}

}  // namespace
}  // namespace strad
