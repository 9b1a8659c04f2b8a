// Scenes in the stream: what was written is read back, and an invalid scene is refused.
#include "scene/scene_io.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.h"
#include "scene/octahedral.h"

namespace strad {
namespace {

// Uses every field once, with values that are exact as floats.
Scene full_scene() {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -2.25}};
  scene.uvs = {{0, 0}, {1, 0}, {1, 1}};
  scene.polygons = {{{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, 0, 0},
                    {{0, 1, 4, kNone}, {0, 1, 2, kNone}, 1, 1}};
  scene.objects = {{"floor", 0}, {"tent", 1}};
  scene.materials = {{"white", {0.75f, 0.75f, 0.75f}, {}, kNone},
                     {"lamp", {0.5f, 0.25f, 0}, {10, 20, 30}, 0}};
  scene.textures = {{"wood.png", 2, 1, {1, 2, 3, 255, 0, 3}}};
  scene.start = -1;
  scene.end = 23.5;
  scene.rate = 24;
  scene.bodies.push_back({"crane", 0, {1, 2, 3}, {0, 0, 1}, Ease::kSmooth, {}, {"crane_*", "hook"}});
  scene.bodies[1].keys = {{0, {1, 2, 3}, 0.5, false, {}}, {2, {}, 0, true, {0, 1, 0, 0}}};
  scene.spots = {{"key", 1, 0.25, 0.5, {{0, {1, 1, 1}, {0, 0, 0}, {30, 20, 10}}}}};
  scene.glows = {{1, {{0, 1}, {5, 0.25f}}}};
  scene.cameras = {{"main", {{0, {0, 1, 5}, {0, 1, 0}, {0, 1, 0}, 0.75}}}};
  scene.provenance = {"strad-import 0.1.0 room.obj", "strad-motion 0.1.0 'a b'"};
  return scene;
}

Scene decoded(const std::vector<Chunk>& chunks) {
  SceneDecoder decoder;
  for (const Chunk& chunk : chunks)
    EXPECT_TRUE(decoder.add(chunk.type, chunk.content, "chunk " + name_of(chunk.type)));
  return decoder.finish("test");
}

std::string fault_of(const std::vector<Chunk>& chunks) {
  try {
    decoded(chunks);
    return "";
  } catch (const BadInput& fault) {
    return fault.what();
  }
}

void expect_same_keys(const Body& a, const Body& b) {
  ASSERT_EQ(a.keys.size(), b.keys.size());
  for (size_t i = 0; i < a.keys.size(); ++i) {
    EXPECT_EQ(a.keys[i].time, b.keys[i].time);
    EXPECT_EQ(a.keys[i].move, b.keys[i].move);
    EXPECT_EQ(a.keys[i].turn, b.keys[i].turn);
    EXPECT_EQ(a.keys[i].has_quat, b.keys[i].has_quat);
    EXPECT_EQ(a.keys[i].quat, b.keys[i].quat);
  }
}

TEST(SceneIo, GeometryComesBack) {
  const Scene scene = full_scene(), back = decoded(encode_scene(scene));
  EXPECT_EQ(back.vertices, scene.vertices);
  EXPECT_EQ(back.uvs, scene.uvs);
  ASSERT_EQ(back.polygons.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    for (int c = 0; c < 4; ++c) {
      EXPECT_EQ(back.polygons[i].corners[c], scene.polygons[i].corners[c]);
      EXPECT_EQ(back.polygons[i].uvs[c], scene.polygons[i].uvs[c]);
    }
    EXPECT_EQ(back.polygons[i].material, scene.polygons[i].material);
    EXPECT_EQ(back.polygons[i].object, scene.polygons[i].object);
    EXPECT_EQ(back.objects[i].name, scene.objects[i].name);
    EXPECT_EQ(back.objects[i].body, scene.objects[i].body);
  }
}

TEST(SceneIo, MaterialsComeBack) {
  const Scene scene = full_scene(), back = decoded(encode_scene(scene));
  ASSERT_EQ(back.materials.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.materials[i].name, scene.materials[i].name);
    EXPECT_EQ(back.materials[i].reflectance, scene.materials[i].reflectance);
    EXPECT_EQ(back.materials[i].emission, scene.materials[i].emission);
    EXPECT_EQ(back.materials[i].texture, scene.materials[i].texture);
  }
  ASSERT_EQ(back.textures.size(), 1u);
  EXPECT_EQ(back.textures[0].name, "wood.png");
  EXPECT_EQ(back.textures[0].width, 2u);
  EXPECT_EQ(back.textures[0].srgb, scene.textures[0].srgb);
}

// Two triangles that meet in the edge of vertices 1 and 2; a third is flat.
Scene smooth_scene() {
  Scene scene = full_scene();
  scene.polygons.clear();
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  scene.normals = {octahedral_vector(0x80008000u), octahedral_vector(0x90008000u),
                   octahedral_vector(0x80007000u), octahedral_vector(0x88888888u)};
  scene.polygons.push_back({{0, 1, 2, kNone}, {kNone, kNone, kNone, kNone}, 0, 0, {0, 1, 2, kNone}});
  scene.polygons.push_back({{0, 1, 3, kNone}, {kNone, kNone, kNone, kNone}, 0, 0});
  scene.polygons.push_back({{1, 3, 2, kNone}, {kNone, kNone, kNone, kNone}, 0, 0, {1, 3, 1, kNone}});
  return scene;
}

TEST(SceneIo, NormalsComeBack) {
  const Scene scene = smooth_scene();
  const std::vector<Chunk> chunks = encode_scene(scene);
  const Scene back = decoded(chunks);
  EXPECT_EQ(back.normals, scene.normals);
  for (size_t p = 0; p < 3; ++p)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(back.polygons[p].normals[c], scene.polygons[p].normals[c]);
  const std::vector<Chunk> again = encode_scene(back);
  for (size_t i = 0; i < chunks.size(); ++i) EXPECT_EQ(again[i].content, chunks[i].content);
}

TEST(SceneIo, NormalsAreAncillaryAndMostlyPredicted) {
  // Their numbers: 0 to 2 are new, then a flat polygon, then vertex 1 again, a new one, and 1 (code 3) where
  // vertex 2 had another.
  for (const Chunk& chunk : encode_scene(smooth_scene())) {
    if (chunk.type != chunk_type("norm")) continue;
    EXPECT_FALSE(is_critical(chunk.type));
    ASSERT_EQ(chunk.content.size(), 1 + 4 * 4 + 1 + 7u);
    EXPECT_EQ(Bytes(chunk.content.end() - 8, chunk.content.end()), (Bytes{7, 1, 1, 1, 0, 1, 1, 3}));
  }
}

TEST(SceneIo, DamagedNormalsAreRefused) {
  const std::vector<Chunk> chunks = encode_scene(smooth_scene());
  const auto refused = [&](const std::function<void(Bytes*)>& damage) {
    std::vector<Chunk> damaged = chunks;
    for (Chunk& chunk : damaged)
      if (chunk.type == chunk_type("norm")) damage(&chunk.content);
    EXPECT_THROW(decoded(damaged), BadInput);
  };
  refused([](Bytes* b) { b->pop_back(); });
  refused([](Bytes* b) { b->push_back(0); });
  refused([](Bytes* b) { b->front() = 200; });         // more normals than bytes
  refused([](Bytes* b) { b->back() = 6; });            // normal 4 of 4
  refused([](Bytes* b) { b->back() = 0; });            // flat at one corner only
  refused([](Bytes* b) { (*b)[b->size() - 4] = 1; });  // no flat polygon: too few corners
  refused([](Bytes* b) { (*b)[b->size() - 8] = 6, b->pop_back(); });
  Scene scene = smooth_scene();
  scene.polygons[0].normals[2] = kNone;
  EXPECT_THROW(validate(scene), BadInput);
  scene = smooth_scene();
  scene.normals[1] = {0, 0, 2};
  EXPECT_THROW(validate(scene), BadInput);
}

TEST(SceneIo, ClampedTexturesComeBackAndCostNothingWhereThereAreNone) {
  Scene scene = full_scene();
  const size_t chunks = encode_scene(scene).size();
  scene.textures[0].clamp = true;
  const std::vector<Chunk> encoded = encode_scene(scene);
  EXPECT_EQ(encoded.size(), chunks + 1);
  EXPECT_TRUE(decoded(encoded).textures[0].clamp);
  EXPECT_TRUE(decoded(encoded).textures[0].opacity.values.empty());
  for (Chunk chunk : encoded) {
    if (chunk.type != chunk_type("TEXM")) continue;
    EXPECT_EQ(chunk.content, (Bytes{1, 1}));  // one texture, clamped
    SceneDecoder decoder;
    for (const Bytes& bad : {Bytes{1, 2}, Bytes{1}, Bytes{200, 1}, Bytes{1, 1, 0}})
      EXPECT_THROW(SceneDecoder().add(chunk.type, bad, "place"), BadInput);
    for (const Chunk& other : encoded)
      decoder.add(other.type, other.type == chunk.type ? Bytes{2, 1, 1} : other.content, "place");
    EXPECT_THROW(decoder.finish("stream"), BadInput);  // modes of two textures, but there is one
  }
}

TEST(SceneIo, HolesComeBackAndCostNothingWhereThereAreNone) {
  Scene scene = full_scene();
  const size_t chunks = encode_scene(scene).size();
  scene.textures[0].opacity = {3, 1, {255, 7, 0}};
  const std::vector<Chunk> encoded = encode_scene(scene);
  EXPECT_EQ(encoded.size(), chunks + 1);
  const Opacity back = decoded(encoded).textures[0].opacity;
  EXPECT_EQ(back.width, 3u);
  EXPECT_EQ(back.height, 1u);
  EXPECT_EQ(back.values, scene.textures[0].opacity.values);
  for (const Chunk& chunk : encoded) {
    if (chunk.type != chunk_type("TEXA")) continue;
    EXPECT_EQ(chunk.content, (Bytes{1, 3, 1, 255, 8, 249}));  // one texture; differences
    for (const Bytes& bad : {Bytes{1, 3, 1, 255, 8}, Bytes{1, 3, 2, 1, 1, 1}, Bytes{1, 3, 1, 1, 1, 1, 1}})
      EXPECT_THROW(SceneDecoder().add(chunk.type, bad, "place"), BadInput);
    SceneDecoder decoder;
    for (const Chunk& other : encoded)
      decoder.add(other.type, other.type == chunk.type ? Bytes{2, 0, 0, 0, 0} : other.content, "place");
    EXPECT_THROW(decoder.finish("stream"), BadInput);  // holes of two textures, but there is one
  }
  scene.textures[0].opacity.width = 2;
  EXPECT_THROW(validate(scene), BadInput);
}

TEST(SceneIo, FinishesComeBackAndCostNothingWhereThereAreNone) {
  Scene scene = full_scene();
  const size_t chunks = encode_scene(scene).size();
  scene.materials[0].finish = {{0.5f, 0.25f, 0}, 0.125f, {0, 0, 1}, 1.75f, true, true};
  const std::vector<Chunk> encoded = encode_scene(scene);
  EXPECT_EQ(encoded.size(), chunks + 1);
  const Scene back = decoded(encoded);
  EXPECT_EQ(back.materials[0].finish, scene.materials[0].finish);
  EXPECT_EQ(back.materials[1].finish, Finish{});
  for (const Chunk& chunk : encoded) {
    if (chunk.type != chunk_type("FNSH")) continue;
    ASSERT_EQ(chunk.content.size(), 67u);  // a count, then 33 bytes for each of two materials
    Bytes shorter = chunk.content, longer = chunk.content, flags = chunk.content, more = chunk.content;
    shorter.pop_back(), longer.push_back(0), flags.back() = 4, more[0] = 200;
    for (const Bytes& bad : {shorter, longer, flags, more})
      EXPECT_THROW(SceneDecoder().add(chunk.type, bad, "place"), BadInput);
    SceneDecoder decoder;
    const Bytes one(chunk.content.begin() + 1, chunk.content.begin() + 34);
    Bytes of_one{1};
    of_one.insert(of_one.end(), one.begin(), one.end());
    for (const Chunk& other : encoded)
      decoder.add(other.type, other.type == chunk.type ? of_one : other.content, "place");
    EXPECT_THROW(decoder.finish("stream"), BadInput);  // the finish of one material, but there are two
  }
  for (const float wrong : {-0.5f, 1.5f, std::numeric_limits<float>::quiet_NaN()}) {
    Scene bad = scene;
    bad.materials[0].finish.specular.g = wrong;
    EXPECT_THROW(validate(bad), BadInput);
    bad = scene;
    bad.materials[0].finish.transmission.b = wrong;
    EXPECT_THROW(validate(bad), BadInput);
    bad = scene;
    bad.materials[0].finish.roughness = wrong;
    EXPECT_THROW(validate(bad), BadInput);
    bad = scene;
    bad.materials[0].finish.ior = wrong == 1.5f ? 0 : wrong;
    EXPECT_THROW(validate(bad), BadInput);
  }
}

TEST(SceneIo, MotionComesBack) {
  const Scene scene = full_scene(), back = decoded(encode_scene(scene));
  EXPECT_EQ(back.start, -1);
  EXPECT_EQ(back.end, 23.5);
  EXPECT_EQ(back.rate, 24);
  EXPECT_EQ(back.provenance, scene.provenance);
  ASSERT_EQ(back.bodies.size(), 2u);
  EXPECT_EQ(back.bodies[1].name, "crane");
  EXPECT_EQ(back.bodies[1].parent, 0u);
  EXPECT_EQ(back.bodies[1].pivot, scene.bodies[1].pivot);
  EXPECT_EQ(back.bodies[1].axis, scene.bodies[1].axis);
  EXPECT_EQ(back.bodies[1].ease, Ease::kSmooth);
  EXPECT_EQ(back.bodies[1].parts, scene.bodies[1].parts);
  expect_same_keys(back.bodies[1], scene.bodies[1]);
}

TEST(SceneIo, LightsAndCamerasComeBack) {
  const Scene scene = full_scene(), back = decoded(encode_scene(scene));
  ASSERT_EQ(back.spots.size(), 1u);
  EXPECT_EQ(back.spots[0].name, "key");
  EXPECT_EQ(back.spots[0].body, 1u);
  EXPECT_EQ(back.spots[0].inner, 0.25);
  EXPECT_EQ(back.spots[0].outer, 0.5);
  EXPECT_EQ(back.spots[0].keys[0].at, scene.spots[0].keys[0].at);
  EXPECT_EQ(back.spots[0].keys[0].intensity, scene.spots[0].keys[0].intensity);
  ASSERT_EQ(back.glows.size(), 1u);
  EXPECT_EQ(back.glows[0].material, 1u);
  EXPECT_EQ(back.glows[0].keys[1].value, 0.25f);
  ASSERT_EQ(back.cameras.size(), 1u);
  EXPECT_EQ(back.cameras[0].name, "main");
  EXPECT_EQ(back.cameras[0].keys[0].from, scene.cameras[0].keys[0].from);
  EXPECT_EQ(back.cameras[0].keys[0].fov, 0.75);
}

TEST(SceneIo, WritingAgainGivesTheSameBytes) {
  const std::vector<Chunk> once = encode_scene(full_scene()), twice = encode_scene(decoded(once));
  ASSERT_EQ(once.size(), twice.size());
  for (size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].content, twice[i].content) << i;
}

TEST(SceneIo, EveryTruncatedChunkIsRefused) {
  const std::vector<Chunk> chunks = encode_scene(full_scene());
  for (size_t i = 0; i < chunks.size(); ++i) {
    for (size_t length = 0; length < chunks[i].content.size(); ++length) {
      std::vector<Chunk> cut = chunks;
      cut[i].content.resize(length);
      EXPECT_NE(fault_of(cut).find("content byte "), std::string::npos)
          << name_of(chunks[i].type) << " " << length;
    }
  }
}

TEST(SceneIo, AChunkWithATailIsRefused) {
  const std::vector<Chunk> chunks = encode_scene(full_scene());
  for (size_t i = 0; i < chunks.size(); ++i) {
    std::vector<Chunk> longer = chunks;
    longer[i].content.push_back(0);
    EXPECT_NE(fault_of(longer).find("1 bytes more than expected"), std::string::npos) << i;
  }
}

TEST(SceneIo, AMissingChunkIsTold) {
  std::vector<Chunk> chunks = encode_scene(full_scene());
  std::erase_if(chunks, [](const Chunk& chunk) { return chunk.type == chunk_type("POLY"); });
  EXPECT_EQ(fault_of(chunks), "test: the scene has no chunk POLY");
}

TEST(SceneIo, AChunkThatComesTwiceIsRefused) {
  std::vector<Chunk> chunks = encode_scene(full_scene());
  chunks.push_back(chunks[1]);
  EXPECT_EQ(fault_of(chunks), "chunk VERT: there is one already");
}

// Each breaks one rule of scene.h.
struct Fault {
  const char* name;
  void (*apply)(Scene*);
};

class BrokenScene : public testing::TestWithParam<Fault> {};

TEST_P(BrokenScene, IsRefused) {
  Scene scene = full_scene();
  EXPECT_NO_THROW(validate(scene));
  GetParam().apply(&scene);
  EXPECT_THROW(validate(scene), BadInput);
  EXPECT_NE(fault_of(encode_scene(scene)), "");
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

INSTANTIATE_TEST_SUITE_P(
    SceneIo, BrokenScene,
    testing::Values(Fault{"vertex_nan", [](Scene* s) { s->vertices[2].y = kNan; }},
                    Fault{"vertex_far", [](Scene* s) { s->vertices[2].y = -2e15; }},
                    Fault{"pivot_far", [](Scene* s) { s->bodies[1].pivot.x = 1e300; }},
                    Fault{"move_far", [](Scene* s) { s->bodies[1].keys[0].move.z = 2e15; }},
                    Fault{"spot_far", [](Scene* s) { s->spots[0].keys[0].at.z = 2e15; }},
                    Fault{"camera_far", [](Scene* s) { s->cameras[0].keys[0].to.z = 2e15; }},
                    Fault{"name_latin1", [](Scene* s) { s->objects[0].name = "gr\xfcn"; }},
                    Fault{"name_control", [](Scene* s) { s->bodies[1].name = "a\x1b[2J"; }},
                    Fault{"name_long_form", [](Scene* s) { s->materials[0].name = "\xc0\xaf"; }},
                    Fault{"name_of_spot", [](Scene* s) { s->spots[0].name = "\xff"; }},
                    Fault{"name_of_camera", [](Scene* s) { s->cameras[0].name = "\xff"; }},
                    Fault{"name_of_texture", [](Scene* s) { s->textures[0].name = "\xff"; }},
                    Fault{"provenance", [](Scene* s) { s->provenance.push_back("\xff"); }},
                    Fault{"uv_infinite", [](Scene* s) { s->uvs[0].x = kInfinity; }},
                    Fault{"corner", [](Scene* s) { s->polygons[0].corners[1] = 5; }},
                    Fault{"corner_none", [](Scene* s) { s->polygons[0].corners[1] = kNone; }},
                    Fault{"uv", [](Scene* s) { s->polygons[1].uvs[0] = 3; }},
                    Fault{"material", [](Scene* s) { s->polygons[0].material = 2; }},
                    Fault{"object", [](Scene* s) { s->polygons[0].object = 2; }},
                    Fault{"reflectance", [](Scene* s) { s->materials[0].reflectance.g = 1.5f; }},
                    Fault{"emission", [](Scene* s) { s->materials[1].emission.g = -1; }},
                    Fault{"texture", [](Scene* s) { s->materials[1].texture = 1; }},
                    Fault{"texture_size", [](Scene* s) { s->textures[0].width = 3; }},
                    Fault{"object_body", [](Scene* s) { s->objects[0].body = 2; }},
                    Fault{"no_world", [](Scene* s) { s->bodies.clear(); }},
                    Fault{"world_moves", [](Scene* s) { s->bodies[0].keys.resize(1); }},
                    Fault{"parent", [](Scene* s) { s->bodies[1].parent = 1; }},
                    Fault{"axis",
                          [](Scene* s) {
                            s->bodies[1].axis = {0, 0, 2};
                          }},
                    Fault{"quat",
                          [](Scene* s) {
                            s->bodies[1].keys[1].quat = {0, 0, 0, 0};
                          }},
                    Fault{"key_nan", [](Scene* s) { s->bodies[1].keys[0].turn = kNan; }},
                    Fault{"key_order", [](Scene* s) { s->bodies[1].keys[1].time = -1; }},
                    Fault{"spot_body", [](Scene* s) { s->spots[0].body = 2; }},
                    Fault{"spot_cone", [](Scene* s) { s->spots[0].inner = 1; }},
                    Fault{"spot_keys", [](Scene* s) { s->spots[0].keys.clear(); }},
                    Fault{"spot_intensity", [](Scene* s) { s->spots[0].keys[0].intensity.r = -1; }},
                    Fault{"glow_material", [](Scene* s) { s->glows[0].material = 2; }},
                    Fault{"glow_twice", [](Scene* s) { s->glows.push_back(s->glows[0]); }},
                    Fault{"glow_value", [](Scene* s) { s->glows[0].keys[0].value = kInfinity; }},
                    Fault{"camera_keys", [](Scene* s) { s->cameras[0].keys.clear(); }},
                    Fault{"camera_fov", [](Scene* s) { s->cameras[0].keys[0].fov = 0; }},
                    Fault{"interval", [](Scene* s) { s->end = -2; }},
                    Fault{"rate", [](Scene* s) { s->rate = 0; }},
                    Fault{"frames", [](Scene* s) { s->rate = 1e300; }}),
    [](const testing::TestParamInfo<Fault>& fault) { return fault.param.name; });

TEST(FrameCount, CountsWholeFrames) {
  Scene scene;
  const auto count = [&scene](double end, double rate) {
    scene.end = end;
    scene.rate = rate;
    return frame_count(scene);
  };
  EXPECT_EQ(count(24, 25), 600);
  EXPECT_EQ(count(0.28, 25), 7);  // 7.000000000000001 in floating point, and just below for others
  EXPECT_EQ(count(1.01, 25), 25);
  EXPECT_EQ(count(0, 25), 1);
}

}  // namespace
}  // namespace strad
