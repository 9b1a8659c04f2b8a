// A scene to chunks and back: geometry and materials. The motion chunk is in motion_io.cpp.
#include "scene/scene_io.h"

#include <algorithm>
#include <bit>

#include "base/error.h"
#include "scene/finish_io.h"
#include "scene/motion_io.h"
#include "scene/rgb_io.h"

namespace strad {
namespace {

constexpr ChunkType kProvenance = chunk_type("prov");
constexpr ChunkType kVertices = chunk_type("VERT");
constexpr ChunkType kTextureCoordinates = chunk_type("TEXC");
constexpr ChunkType kPolygons = chunk_type("POLY");
constexpr ChunkType kObjects = chunk_type("OBJS");
constexpr ChunkType kMaterials = chunk_type("MATL");
constexpr ChunkType kTexture = chunk_type("TEXR");
constexpr ChunkType kTextureModes = chunk_type("TEXM");
constexpr ChunkType kTextureHoles = chunk_type("TEXA");
constexpr ChunkType kMotion = chunk_type("MOTN");

// Differences of the bits of successive floats: neighbours in a file are mostly neighbours in space, and then
// only low bytes differ.
void put_floats(Bytes* to, const std::vector<float>& column) {
  std::vector<uint64_t> differences;
  differences.reserve(column.size());
  uint32_t previous = 0;
  for (const float value : column) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    differences.push_back((bits - previous) & 0xffffffffu);
    previous = bits;
  }
  put_planes(to, differences, 4);
}

std::vector<float> get_floats(ByteReader* from, size_t count) {
  std::vector<float> column(count);
  uint32_t previous = 0;
  const std::vector<uint64_t> differences = get_planes(from, count, 4);
  for (size_t i = 0; i < count; ++i) {
    previous += static_cast<uint32_t>(differences[i]);
    column[i] = std::bit_cast<float>(previous);
    if (!std::isfinite(column[i])) from->fail("found a coordinate that is not finite");
  }
  return column;
}

template <typename Point>
void put_points(Bytes* to, const std::vector<Point>& points, std::initializer_list<double Point::*> axes) {
  put_varint(to, points.size());
  for (const auto axis : axes) {
    std::vector<float> column;
    column.reserve(points.size());
    for (const Point& point : points) column.push_back(static_cast<float>(point.*axis));
    put_floats(to, column);
  }
}

template <typename Point>
std::vector<Point> get_points(ByteReader* from, std::initializer_list<double Point::*> axes) {
  std::vector<Point> points(from->count(4 * axes.size(), "points"));
  for (const auto axis : axes) {
    const std::vector<float> column = get_floats(from, points.size());
    for (size_t i = 0; i < points.size(); ++i) points[i].*axis = column[i];
  }
  return points;
}

// A column of indices as differences from one polygon to the next; kNone counts as -1.
template <typename Get>
void put_indices(Bytes* to, const std::vector<Polygon>& polygons, Get get) {
  int64_t previous = 0;
  for (const Polygon& polygon : polygons) {
    const uint32_t index = get(polygon);
    const int64_t value = index == kNone ? -1 : static_cast<int64_t>(index);
    put_signed(to, value - previous);
    previous = value;
  }
}

template <typename Get>
void get_indices(ByteReader* from, std::vector<Polygon>* polygons, Get get) {
  int64_t previous = 0;
  for (Polygon& polygon : *polygons) {
    previous += from->signed_varint();
    if (previous < -1 || previous >= kNone) from->fail("found an index out of range");
    get(polygon) = static_cast<uint32_t>(previous);  // -1 becomes kNone
  }
}

void put_polygons(Bytes* to, const std::vector<Polygon>& polygons) {
  put_varint(to, polygons.size());
  for (int c = 0; c < 4; ++c) put_indices(to, polygons, [c](const Polygon& p) { return p.corners[c]; });
  for (int c = 0; c < 4; ++c) put_indices(to, polygons, [c](const Polygon& p) { return p.uvs[c]; });
  put_indices(to, polygons, [](const Polygon& p) { return p.material; });
  put_indices(to, polygons, [](const Polygon& p) { return p.object; });
}

std::vector<Polygon> get_polygons(ByteReader* from) {
  std::vector<Polygon> polygons(from->count(10, "polygons"));
  for (int c = 0; c < 4; ++c)
    get_indices(from, &polygons, [c](Polygon& p) -> uint32_t& { return p.corners[c]; });
  for (int c = 0; c < 4; ++c) get_indices(from, &polygons, [c](Polygon& p) -> uint32_t& { return p.uvs[c]; });
  get_indices(from, &polygons, [](Polygon& p) -> uint32_t& { return p.material; });
  get_indices(from, &polygons, [](Polygon& p) -> uint32_t& { return p.object; });
  return polygons;
}

void put_objects(Bytes* to, const std::vector<Object>& objects) {
  put_varint(to, objects.size());
  for (const Object& object : objects) {
    put_text(to, object.name);
    put_varint(to, object.body);
  }
}

std::vector<Object> get_objects(ByteReader* from) {
  std::vector<Object> objects(from->count(2, "objects"));
  for (Object& object : objects) {
    object.name = from->text();
    object.body = from->number(kNone, "a body");
  }
  return objects;
}

void put_materials(Bytes* to, const std::vector<Material>& materials) {
  put_varint(to, materials.size());
  for (const Material& material : materials) {
    put_text(to, material.name);
    put_rgb(to, material.reflectance);
    put_rgb(to, material.emission);
    put_varint(to, material.texture == kNone ? 0 : uint64_t{material.texture} + 1);
  }
}

std::vector<Material> get_materials(ByteReader* from) {
  std::vector<Material> materials(from->count(26, "materials"));
  for (Material& material : materials) {
    material.name = from->text();
    material.reflectance = get_rgb(from);
    material.emission = get_rgb(from);
    material.texture = from->number(kNone, "a texture") - 1;  // 0 becomes kNone
  }
  return materials;
}

// Differences from the pixel to the left, wrapped: flat areas become zeros.
void put_differences(Bytes* to, const std::vector<uint8_t>& values, size_t step) {
  for (size_t i = 0; i < values.size(); ++i)
    put_u8(to, static_cast<uint8_t>(values[i] - (i < step ? 0 : values[i - step])));
}

std::vector<uint8_t> get_differences(ByteReader* from, uint64_t width, uint64_t height, size_t step) {
  const uint64_t pixels = width * height;
  if (pixels > from->remaining() / step) from->fail("found a picture larger than the bytes left");
  const ByteSpan differences = from->bytes(step * pixels);
  std::vector<uint8_t> values(differences.begin(), differences.end());
  for (size_t i = step; i < values.size(); ++i)
    values[i] = static_cast<uint8_t>(values[i] + values[i - step]);
  return values;
}

void put_texture(Bytes* to, const Texture& texture) {
  put_text(to, texture.name);
  put_varint(to, texture.width);
  put_varint(to, texture.height);
  put_differences(to, texture.srgb, 3);
}

Texture get_texture(ByteReader* from) {
  Texture texture;
  texture.name = from->text();
  texture.width = from->number(kNone, "a width");
  texture.height = from->number(kNone, "a height");
  texture.srgb = get_differences(from, texture.width, texture.height, 3);
  return texture;
}

// Of all textures; no size where a texture has no holes.
void put_texture_holes(Bytes* to, const std::vector<Texture>& textures) {
  put_varint(to, textures.size());
  for (const Texture& texture : textures) {
    put_varint(to, texture.opacity.width);
    put_varint(to, texture.opacity.height);
    put_differences(to, texture.opacity.values, 1);
  }
}

std::vector<Opacity> get_texture_holes(ByteReader* from) {
  std::vector<Opacity> all(from->count(2, "textures"));
  for (Opacity& opacity : all) {
    opacity.width = from->number(kNone, "a width");
    opacity.height = from->number(kNone, "a height");
    opacity.values = get_differences(from, opacity.width, opacity.height, 1);
  }
  return all;
}

// Frozen numbers: 0 repeats, 1 is clamped.
void put_texture_modes(Bytes* to, const std::vector<Texture>& textures) {
  put_varint(to, textures.size());
  for (const Texture& texture : textures) put_varint(to, texture.clamp ? 1 : 0);
}

std::vector<bool> get_texture_modes(ByteReader* from) {
  std::vector<bool> clamps(from->count(1, "textures"));
  for (size_t i = 0; i < clamps.size(); ++i) clamps[i] = from->number(1, "a mode of a texture") == 1;
  return clamps;
}

void put_lines(Bytes* to, const std::vector<std::string>& lines) {
  put_varint(to, lines.size());
  for (const std::string& line : lines) put_text(to, line);
}

std::vector<std::string> get_lines(ByteReader* from) {
  std::vector<std::string> lines(from->count(1, "lines"));
  for (std::string& line : lines) line = from->text();
  return lines;
}

void decode(ChunkType type, ByteReader* from, Scene* scene, std::vector<bool>* clamps,
            std::vector<Opacity>* opacities, StoredNormals* normals, std::vector<Finish>* finishes) {
  if (type == kProvenance) scene->provenance = get_lines(from);
  if (type == kVertices) scene->vertices = get_points<Vec3>(from, {&Vec3::x, &Vec3::y, &Vec3::z});
  if (type == kTextureCoordinates) scene->uvs = get_points<Vec2>(from, {&Vec2::x, &Vec2::y});
  if (type == kPolygons) scene->polygons = get_polygons(from);
  if (type == kNormalsChunk) *normals = get_normals(from);
  if (type == kObjects) scene->objects = get_objects(from);
  if (type == kMaterials) scene->materials = get_materials(from);
  if (type == kTexture) scene->textures.push_back(get_texture(from));
  if (type == kTextureModes) *clamps = get_texture_modes(from);
  if (type == kTextureHoles) *opacities = get_texture_holes(from);
  if (type == kFinishesChunk) *finishes = get_finishes(from);
  if (type == kMotion) get_motion(from, scene);
}

constexpr ChunkType kRequired[] = {kVertices, kPolygons, kObjects, kMaterials, kMotion};
constexpr ChunkType kOptional[] = {kProvenance,   kTextureCoordinates, kTexture,      kTextureModes,
                                   kTextureHoles, kNormalsChunk,       kFinishesChunk};

bool contains(std::span<const ChunkType> types, ChunkType type) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

std::vector<Chunk> encode_scene(const Scene& scene) {
  std::vector<Chunk> chunks;
  const auto add = [&chunks](ChunkType type) {
    chunks.push_back({type, {}});
    return &chunks.back().content;
  };
  put_lines(add(kProvenance), scene.provenance);
  put_points(add(kVertices), scene.vertices, {&Vec3::x, &Vec3::y, &Vec3::z});
  if (!scene.uvs.empty()) put_points(add(kTextureCoordinates), scene.uvs, {&Vec2::x, &Vec2::y});
  put_polygons(add(kPolygons), scene.polygons);
  if (!scene.normals.empty()) put_normals(add(kNormalsChunk), scene);
  put_objects(add(kObjects), scene.objects);
  put_materials(add(kMaterials), scene.materials);
  if (has_finishes(scene)) put_finishes(add(kFinishesChunk), scene.materials);
  for (const Texture& texture : scene.textures) put_texture(add(kTexture), texture);
  const bool any_clamp =
      std::any_of(scene.textures.begin(), scene.textures.end(), [](const Texture& t) { return t.clamp; });
  if (any_clamp) put_texture_modes(add(kTextureModes), scene.textures);
  const bool any_holes = std::any_of(scene.textures.begin(), scene.textures.end(),
                                     [](const Texture& t) { return !t.opacity.values.empty(); });
  if (any_holes) put_texture_holes(add(kTextureHoles), scene.textures);
  put_motion(add(kMotion), scene);
  return chunks;
}

bool SceneDecoder::knows(ChunkType type) { return contains(kRequired, type) || contains(kOptional, type); }

bool SceneDecoder::add(ChunkType type, ByteSpan content, const std::string& place) {
  if (!knows(type)) return false;
  if (type != kTexture && contains(seen_, type)) throw BadInput(place + ": there is one already");
  seen_.push_back(type);
  ByteReader from(content, place);
  decode(type, &from, &scene_, &clamps_, &opacities_, &normals_, &finishes_);
  from.finish();
  return true;
}

Scene SceneDecoder::finish(const std::string& place) {
  for (const ChunkType type : kRequired)
    if (!contains(seen_, type)) throw BadInput(place + ": the scene has no chunk " + name_of(type));
  const auto check = [&](ChunkType type, const char* what, size_t count) {
    if (contains(seen_, type) && count != scene_.textures.size())
      throw BadInput(place + ": found " + what + " of " + std::to_string(count) + " textures, expected " +
                     std::to_string(scene_.textures.size()));
  };
  check(kTextureModes, "modes", clamps_.size());
  check(kTextureHoles, "holes", opacities_.size());
  for (size_t i = 0; i < clamps_.size(); ++i) scene_.textures[i].clamp = clamps_[i];
  for (size_t i = 0; i < opacities_.size(); ++i) scene_.textures[i].opacity = std::move(opacities_[i]);
  if (contains(seen_, kFinishesChunk)) apply_finishes(finishes_, place, &scene_);
  if (contains(seen_, kNormalsChunk)) apply_normals(std::move(normals_), place, &scene_);
  try {
    validate(scene_);
  } catch (const BadInput& fault) {
    throw BadInput(place + ": " + fault.what());
  }
  return std::move(scene_);
}

}  // namespace strad
