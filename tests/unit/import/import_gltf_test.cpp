// glTF files: what moves is where the format's own text puts it, at any instant; what is wrong is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/rng.h"
#include "import/gltf/gltf.h"
#include "import_folder.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

// A file that is built buffer by buffer: each list of floats is a buffer view and an accessor.
class Gltf {
 public:
  int floats(const std::string& type, int components, const std::vector<float>& values) {
    const size_t at = bytes_.size();
    bytes_.resize(at + 4 * values.size());
    std::memcpy(bytes_.data() + at, values.data(), 4 * values.size());
    add(at, 4 * values.size(), 5126, type, values.size() / static_cast<size_t>(components));
    return count_++;
  }
  int shorts(const std::vector<uint16_t>& values) {
    const size_t at = bytes_.size();
    bytes_.resize(at + (2 * values.size() + 3) / 4 * 4);
    std::memcpy(bytes_.data() + at, values.data(), 2 * values.size());
    add(at, 2 * values.size(), 5123, "SCALAR", values.size());
    return count_++;
  }
  // A quad of 2 m by 1 m, as mesh 0.
  void quad() {
    const int points = floats("VEC3", 3, {0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0}),
              corners = shorts({0, 1, 2, 0, 2, 3});
    meshes = R"([{"name":"quad","primitives":[{"attributes":{"POSITION":)" + std::to_string(points) +
             "},\"indices\":" + std::to_string(corners) + ",\"material\":0}]}]";
  }
  std::string json() const {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + roots + "}],\"nodes\":" + nodes +
           ",\"meshes\":" + meshes + ",\"materials\":" + materials +
           R"(,"buffers":[{"uri":"data.bin","byteLength":)" + std::to_string(bytes_.size()) +
           "}],\"bufferViews\":[" + views_ + "],\"accessors\":[" + accessors_ + "]" + more + "}";
  }
  const std::vector<char>& bytes() const { return bytes_; }

  std::string roots = "[0]", nodes, meshes;
  std::string materials =
      R"([{"name":"grey","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"metallicFactor":0}}])";
  std::string more;  // after a comma

 private:
  void add(size_t at, size_t size, int component, const std::string& type, size_t items) {
    const std::string comma = count_ ? "," : "";
    views_ += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(at) +
              ",\"byteLength\":" + std::to_string(size) + "}";
    accessors_ += comma + "{\"bufferView\":" + std::to_string(count_) +
                  ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(items) +
                  ",\"type\":\"" + type + "\"}";
  }
  std::vector<char> bytes_;
  std::string views_, accessors_;
  int count_ = 0;
};

class ImportGltf : public ImportFolder {
 protected:
  using ImportFolder::refusal;
  Scene import(const std::string& json) override {
    write("s.gltf", json);
    report_ = {};
    return import_gltf(path("s.gltf"), options_, gltf_, &report_);
  }
  void write_data(const Gltf& file) const {
    write("data.bin", std::string(file.bytes().data(), file.bytes().size()));
  }
  Scene import(const Gltf& file) {
    write_data(file);
    return import(file.json());
  }
  std::string refusal(const Gltf& file) {
    write_data(file);
    return refusal(file.json());
  }

  GltfOptions gltf_;
};

float any(uint64_t seed, uint64_t i) { return static_cast<float>(hash_of(seed, i) >> 40) * 0x1p-23f - 1; }

// The format's formulas, written out: section 3.5.2 (TRS), appendix C.
using Matrix = std::array<std::array<double, 4>, 4>;  // rows

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix m{};
  for (size_t r = 0; r < 4; ++r)
    for (size_t c = 0; c < 4; ++c)
      for (size_t k = 0; k < 4; ++k) m[r][c] += a[r][k] * b[k][c];
  return m;
}

Matrix trs(std::array<double, 3> t, std::array<double, 4> q, std::array<double, 3> s) {
  const auto [x, y, z, w] = q;
  Matrix m{{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t[0]},
            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t[1]},
            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t[2]},
            {0, 0, 0, 1}}};
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) m[r][c] *= s[c];
  return m;
}

struct Track {
  std::string interpolation;
  std::vector<float> times, values;
  size_t width = 3;

  std::vector<double> at(double time) const {
    const bool spline = interpolation == "CUBICSPLINE";
    const auto value = [&](size_t key, size_t part) {
      std::vector<double> v;
      for (size_t c = 0; c < width; ++c) v.push_back(values[(spline ? 3 * key + part : key) * width + c]);
      return v;
    };
    if (time <= times.front()) return normal(value(0, 1));
    if (time >= times.back()) return normal(value(times.size() - 1, 1));
    size_t k = 0;
    while (times[k + 1] <= time) ++k;
    const double td = double{times[k + 1]} - times[k], u = (time - times[k]) / td;
    const std::vector<double> a = value(k, 1), b = value(k + 1, 1);
    std::vector<double> result(width);
    if (interpolation == "STEP") return normal(a);
    if (spline) {
      const std::vector<double> out = value(k, 2), in = value(k + 1, 0);
      for (size_t c = 0; c < width; ++c)
        result[c] = (2 * u * u * u - 3 * u * u + 1) * a[c] + td * (u * u * u - 2 * u * u + u) * out[c] +
                    (-2 * u * u * u + 3 * u * u) * b[c] + td * (u * u * u - u * u) * in[c];
      return normal(result);
    }
    double wa = 1 - u, wb = u;
    if (width == 4) {
      const std::vector<double> p = normal(a), q = normal(b);
      const double d = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
      const double angle = std::acos(std::min(std::abs(d), 1.0)), sign = d < 0 ? -1 : 1;
      if (angle > 1e-9)
        wa = std::sin(angle * (1 - u)) / std::sin(angle), wb = sign * std::sin(angle * u) / std::sin(angle);
      for (size_t c = 0; c < 4; ++c) result[c] = wa * p[c] + wb * q[c];
      return normal(result);
    }
    for (size_t c = 0; c < width; ++c) result[c] = wa * a[c] + wb * b[c];
    return result;
  }
  std::vector<double> normal(std::vector<double> v) const {
    if (width < 4) return v;
    const double norm = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
    for (double& c : v) c /= norm;
    return v;
  }
};

Track any_track(uint64_t seed, const std::string& interpolation, size_t width) {
  Track track{interpolation, {}, {}, width};
  const size_t each = interpolation == "CUBICSPLINE" ? 3 : 1;
  float time = 0.1f * (1 + any(seed, 1));
  for (uint64_t key = 0; key < 6; ++key) {
    track.times.push_back(time);
    time += 0.3f + 0.2f * any(seed, 10 + key);
    for (uint64_t part = 0; part < each; ++part)
      for (uint64_t c = 0; c < width; ++c) track.values.push_back(any(seed, 100 + 40 * key + 10 * part + c));
  }
  return track;
}

std::string list(const std::vector<double>& numbers) {
  std::string text = "[";
  for (const double n : numbers) {
    char one[32];
    std::snprintf(one, sizeof one, "%s%.17g", text.size() > 1 ? "," : "", n);
    text += one;
  }
  return text + "]";
}

// Grandparent with a mirroring scale, parent that moves, child that moves with a scale that is not uniform,
// and an own mesh each for the parent and a node below the child. All samplers.
TEST_F(ImportGltf, NestedNodesAreWhereTheFormatPutsThem) {
  double worst = 0;
  uint64_t seed = 0;
  for (const char* translation : {"STEP", "LINEAR", "CUBICSPLINE"}) {
    for (const char* rotation : {"STEP", "LINEAR", "CUBICSPLINE"}) {
      for (int round = 0; round < 3; ++round, ++seed) {
        Gltf file;
        file.quad();
        const Track tracks[] = {any_track(4 * seed, translation, 3), any_track(4 * seed + 1, rotation, 4),
                                any_track(4 * seed + 2, rotation, 3),
                                any_track(4 * seed + 3, translation, 4)};
        std::string samplers, channels;
        for (int i = 0; i < 4; ++i) {
          const Track& track = tracks[i];
          const int input = file.floats("SCALAR", 1, track.times);
          const int output =
              file.floats(track.width == 3 ? "VEC3" : "VEC4", static_cast<int>(track.width), track.values);
          samplers += std::string(i ? "," : "") + "{\"input\":" + std::to_string(input) +
                      ",\"output\":" + std::to_string(output) + ",\"interpolation\":\"" +
                      track.interpolation + "\"}";
          channels += std::string(i ? "," : "") + "{\"sampler\":" + std::to_string(i) +
                      ",\"target\":{\"node\":" + std::to_string(i < 2 ? 1 : 2) + ",\"path\":\"" +
                      (track.width == 3 ? "translation" : "rotation") + "\"}}";
        }
        const std::array<double, 4> tilt{0.5, 0.5, -0.5, 0.5};
        file.nodes =
            R"([{"name":"base","translation":[1,2,3],"rotation":)" + list({tilt.begin(), tilt.end()}) +
            R"(,"scale":[-1.5,1.5,1.5],"children":[1]},{"name":"arm","children":[2],"mesh":0},)"
            R"({"name":"hand","scale":[1,2,-0.5],"children":[3]},{"name":"tool","mesh":0,"translation":[0.1,0.2,0.3]}])";
        file.more = ",\"animations\":[{\"samplers\":[" + samplers + "],\"channels\":[" + channels + "]}]";
        const Scene scene = import(file);
        ASSERT_EQ(scene.objects.size(), 2u);
        ASSERT_EQ(scene.bodies.size(), 3u);
        EXPECT_EQ(scene.bodies[2].parent, 1u);
        const Matrix base = trs({1, 2, 3}, tilt, {-1.5, 1.5, 1.5});
        const Matrix tool = trs({0.1, 0.2, 0.3}, {0, 0, 0, 1}, {1, 1, 1});
        const auto placed = [&](double time) {  // of arm and tool
          const auto a = tracks[0].at(time), b = tracks[1].at(time), c = tracks[2].at(time),
                     d = tracks[3].at(time);
          const Matrix arm = product(base, trs({a[0], a[1], a[2]}, {b[0], b[1], b[2], b[3]}, {1, 1, 1}));
          const Matrix hand = trs({c[0], c[1], c[2]}, {d[0], d[1], d[2], d[3]}, {1, 2, -0.5});
          return std::array<Matrix, 2>{arm, product(product(arm, hand), tool)};
        };
        const auto corner = [](const Matrix& m, double x, double y) {
          return Vec3{m[0][0] * x + m[0][1] * y + m[0][3], m[1][0] * x + m[1][1] * y + m[1][3],
                      m[2][0] * x + m[2][1] * y + m[2][3]};
        };
        const auto at_rest = placed(0);
        for (uint64_t i = 0; i < 200; ++i) {
          const double time = 2.5 * (1 + double{any(999, i)}) / 2;
          const std::vector<Pose> poses = poses_at(scene, time);
          const auto now = placed(time);
          for (size_t object = 0; object < 2; ++object) {
            const double size = length(corner(at_rest[object], 2, 1) - corner(at_rest[object], 0, 0));
            for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}) {
              const Vec3 found = poses[scene.objects[object].body] * corner(at_rest[object], x, y);
              worst = std::max(worst, length(found - corner(now[object], x, y)) / size);
            }
          }
        }
      }
    }
  }
  EXPECT_LE(worst, 1e-5);
  RecordProperty("worst_times_1e9", std::to_string(1e9 * worst));
}

TEST_F(ImportGltf, MaterialsMeshesLightsAndCameras) {
  Gltf file;
  const int points = file.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}),
            corners = file.shorts({0, 1, 3, 2});
  file.meshes = R"([{"primitives":[{"attributes":{"POSITION":)" + std::to_string(points) +
                "},\"indices\":" + std::to_string(corners) + R"(,"mode":5,"material":0}]}])";
  file.materials =
      R"([{"name":"lamp","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.4,0.2,1],"metallicFactor":0.25},)"
      R"("emissiveFactor":[1,0.5,0],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}}}])";
  file.nodes =
      R"([{"name":"one","mesh":0},{"name":"two","mesh":0,"translation":[5,0,0],"scale":[-1,1,1]},)"
      R"({"name":"torch","translation":[0,3,0],"rotation":[-0.70710678118654752,0,0,0.70710678118654752],)"
      R"("extensions":{"KHR_lights_punctual":{"light":0}}},{"name":"eye","translation":[0,1,9],"camera":0}])";
  file.roots = "[0,1,2,3]";
  file.more =
      R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot",)"
      R"("color":[1,0.5,0.25],"intensity":1366,"spot":{"innerConeAngle":0.2,"outerConeAngle":0.5}}]}},)"
      R"("cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}])";
  const Scene scene = import(file);
  // A strip 0 1 3 2 of two triangles, seen from +z, twice; the mirrored one is wound the other way, to face
  // +z, too.
  ASSERT_EQ(scene.polygons.size(), 4u);
  for (const Polygon& polygon : scene.polygons) {
    const Vec3 a = scene.vertices[polygon.corners[0]], b = scene.vertices[polygon.corners[1]],
               c = scene.vertices[polygon.corners[2]];
    EXPECT_GT(cross(b - a, c - a).z, 0);
  }
  EXPECT_EQ(scene.vertices.size(), 8u);
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].reflectance, (Rgb{0.75f * 0.8f, 0.75f * 0.4f, 0.75f * 0.2f}));
  EXPECT_EQ(scene.materials[0].emission, (Rgb{8, 4, 0}));
  // 1366 cd at 683 lm / W are 2 W / sr. The torch is turned by -90 degrees about x: -z becomes -y.
  ASSERT_EQ(scene.spots.size(), 1u);
  EXPECT_NEAR(scene.spots[0].keys[0].intensity.r, 2, 1e-6);
  EXPECT_NEAR(scene.spots[0].keys[0].intensity.b, 0.5, 1e-6);
  EXPECT_LT(length(scene.spots[0].keys[0].aim - Vec3{0, 2, 0}), 1e-12);
  EXPECT_EQ(scene.spots[0].inner, 0.2);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].keys[0].from, (Vec3{0, 1, 9}));
  EXPECT_EQ(scene.cameras[0].keys[0].to, (Vec3{0, 1, 8}));
  EXPECT_EQ(scene.cameras[0].keys[0].fov, 0.8);
}

// A metal reflects by its facets alone, of alpha roughness^2; of half glass, half of the base colour is
// transmitted and half reflected diffusely.
TEST_F(ImportGltf, MetalsMirrorAndTransmissionMakesGlass) {
  const auto material = [&](const std::string& factors, const std::string& more) {
    Gltf file;
    file.quad();
    file.nodes = R"([{"mesh":0}])";
    file.materials = R"([{"name":"m","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.25,1])" + factors +
                     "}" + more + "}]";
    return import(file).materials.at(0);
  };
  const Material gold = material(R"(,"metallicFactor":1,"roughnessFactor":0.5)", "");
  EXPECT_TRUE(is_black(gold.reflectance));
  EXPECT_EQ(gold.finish.specular, (Rgb{1, 0.5f, 0.25f}));
  EXPECT_EQ(gold.finish.roughness, 0.25f);
  EXPECT_TRUE(gold.finish.metallic);
  const Material half = material(R"(,"metallicFactor":0)",
                                 R"(,"extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5},)"
                                 R"("KHR_materials_ior":{"ior":1.25}})");
  EXPECT_EQ(half.finish.transmission, (Rgb{0.5f, 0.25f, 0.125f}));
  EXPECT_EQ(half.finish.ior, 1.25f);
  EXPECT_TRUE(half.finish.fresnel);
  EXPECT_NEAR(half.reflectance.g, 0.25, 1e-6);
  EXPECT_TRUE(is_plain(material(R"(,"metallicFactor":0)", "").finish));
  EXPECT_THROW(material(R"(,"roughnessFactor":2)", ""), BadInput);
}

// A picture of two pixels, the second with an alpha of 100 / 255. Its opacity is moved so that the limit is a
// half.
TEST_F(ImportGltf, AlphaGivesHolesWhereTheModeSaysSo) {
  const std::string picture =
      "data:image/"
      "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR42mPgEpH7r2FkkwIACKYCNnfm628A"
      "AAAASUVORK5CYII=";
  const auto opacity = [&](const std::string& mode) {
    Gltf file;
    file.quad();
    file.nodes = R"([{"mesh":0}])";
    file.materials = R"([{"name":"leaf",)" + mode +
                     R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0}}])";
    file.more = R"(,"textures":[{"source":0}],"images":[{"uri":")" + picture + "\"}]";
    const Scene scene = import(file);
    EXPECT_EQ(scene.textures.at(0).srgb, (std::vector<uint8_t>{10, 20, 30, 40, 50, 60}));
    return scene.textures.at(0).opacity.values;
  };
  EXPECT_TRUE(opacity("").empty());
  EXPECT_EQ(opacity(R"("alphaMode":"BLEND",)"), (std::vector<uint8_t>{255, 100}));
  EXPECT_EQ(note(0), "s.gltf:1: alphaMode BLEND is taken as holes where alpha is below a half");
  EXPECT_EQ(opacity(R"("alphaMode":"MASK",)"), (std::vector<uint8_t>{255, 100}));
  // 100 + 127.5 - 0.25 * 255 = 163.75
  EXPECT_EQ(opacity(R"("alphaMode":"MASK","alphaCutoff":0.25,)"), (std::vector<uint8_t>{255, 164}));
}

TEST_F(ImportGltf, WhatCannotBeTakenIsNamed) {
  const auto with = [](const std::string& nodes, const std::string& more) {
    Gltf file;
    file.quad();
    file.nodes = nodes;
    const int times = file.floats("SCALAR", 1, {0, 1});
    const int values = file.floats("VEC3", 3, {1, 1, 1, 2, 2, 2});
    const int turns = file.floats("VEC4", 4, {0, 0, 0, 1, 0, 1, 0, 0});
    file.more = more;
    for (const auto& [name, index] : {std::pair{"TIMES", times}, {"VALUES", values}, {"TURNS", turns}})
      for (size_t at = file.more.find(name); at != std::string::npos; at = file.more.find(name))
        file.more.replace(at, std::string(name).size(), std::to_string(index));
    return file;
  };
  const auto moved = [](const std::string& path, const std::string& output, int node) {
    return R"(,"animations":[{"samplers":[{"input":TIMES,"output":)" + output +
           R"(}],"channels":[{"sampler":0,"target":{"node":)" + std::to_string(node) + ",\"path\":\"" + path +
           "\"}}]}]";
  };
  const std::string one = R"([{"name":"one","mesh":0}])";
  const std::string two =
      R"([{"name":"one","mesh":0,"scale":[1,2,1],"children":[1]},{"name":"two","mesh":0}])";
  EXPECT_EQ(refusal(with(one, moved("translation", "VALUES", 0))), "");
  EXPECT_EQ(refusal(with(one, moved("scale", "VALUES", 0))),
            "s.gltf: scaling that moves, of node \"one\" is not supported");
  EXPECT_EQ(refusal(with(one, moved("weights", "VALUES", 0))),
            "s.gltf: animation of morph targets, in animation \"animation0\", is not supported");
  EXPECT_EQ(refusal(with(two, moved("rotation", "TURNS", 1))),
            "s.gltf: a turn within a scaling that is not uniform, of node \"two\" is not supported");
  EXPECT_EQ(refusal(with(two, moved("translation", "VALUES", 1))), "");
  EXPECT_EQ(refusal(with(one, moved("translation", "VALUES", 7))),
            "s.gltf: animation \"animation0\": moves node 7 of 1");
  EXPECT_EQ(refusal(with(one, moved("translation", "TURNS", 0))),
            "s.gltf: animation \"animation0\" output: the accessor is of another type");
  EXPECT_EQ(refusal(with(R"([{"name":"one","mesh":0,"skin":0}])", R"(,"skins":[{"joints":[0]}])")),
            "s.gltf: a skin, of node \"one\", is not supported");
  EXPECT_EQ(refusal(with(R"([{"mesh":0,"children":[0]}])", "")), "s.gltf: node 0 of the scene has a parent");
  EXPECT_EQ(refusal(with(R"([{"mesh":4}])", "")), "s.gltf: node 0: uses mesh 4 of 1");
  EXPECT_EQ(refusal(with(one, R"(,"extensionsRequired":["EXT_x"])")),
            "s.gltf: requires extension \"EXT_x\", which is not supported");
  EXPECT_EQ(
      refusal(with(one, R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional"}]}})")), "");
  EXPECT_EQ(refusal(with(
                R"([{"name":"one","mesh":0,"extensions":{"KHR_lights_punctual":{"light":0}}}])",
                R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","name":"sun"}]}})")),
            "s.gltf: directional light \"sun\" is not supported");
  gltf_.animation = "walk";
  EXPECT_EQ(refusal(with(one, moved("translation", "VALUES", 0))),
            "--animation: found 'walk', expected one of animation0");
  gltf_.animation = "";
  options_.skip_unknown = true;
  EXPECT_EQ(import(with(one, moved("scale", "VALUES", 0))).bodies.size(), 1u);
}

TEST_F(ImportGltf, BuffersAreCheckedAndStayInTheFolder) {
  Gltf file;
  file.quad();
  file.nodes = R"([{"mesh":0}])";
  ASSERT_EQ(refusal(file), "");
  const std::string good = file.json();
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_THROW(import(text), BadInput) << text;
  };
  refused("\"byteLength\":48", "\"byteLength\":47");
  refused("\"byteLength\":48", "\"byteLength\":99999");
  refused("\"count\":4", "\"count\":5");
  refused("\"count\":4", "\"count\":4000000000");
  refused("\"count\":4", "\"count\":3");  // then an index is out of range
  refused("\"componentType\":5126", "\"componentType\":5130");
  refused("\"VEC3\"", "\"VEC2\"");
  refused("\"buffer\":0", "\"buffer\":3");
  refused("\"byteOffset\":48", "\"byteOffset\":4000000000");
  refused("data.bin", "/etc/passwd");
  refused("data.bin", "../data.bin");
  refused("data.bin", "%2e%2e/data.bin");
  refused("data.bin", "absent.bin");
  refused("data.bin", "data:application/octet-stream;base64,AAAA");
  refused("\"2.0\"", "\"1.0\"");
  refused("\"material\":0", "\"material\":1");
  for (size_t length = 0; length < good.size(); length += 7)
    EXPECT_THROW(import(good.substr(0, length)), BadInput);
}

}  // namespace
}  // namespace strad
