// Checks of a scene: all that the rest of the library assumes about it.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "base/utf8.h"
#include "scene/scene.h"

namespace strad {
namespace {

constexpr double kMostFrames = 1e9;  // frame numbers fit an int
constexpr double kUnitTolerance = 1e-6;
// Squares of lengths must fit a float, in which rays are traced. Stretches of a light year are 1e16 m.
constexpr double kFarthest = 1e15;

[[noreturn]] void fail(const std::string& kind, size_t index, const std::string& fault) {
  throw BadInput(kind + " " + std::to_string(index) + ": " + fault);
}

[[noreturn]] void fail(const std::string& kind, const std::string& name, const std::string& fault) {
  throw BadInput(kind + " '" + name + "': " + fault);
}

std::string index_fault(const std::string& what, uint64_t index, size_t count) {
  return what + " is " + std::to_string(index) + ", expected less than " + std::to_string(count);
}

constexpr const char* kNotPlaced = "a coordinate is not finite, or beyond 1e15 m";

bool is_placed(Vec3 p) {
  return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}

// Names are shown and written by many programs.
void check_name(const std::string& kind, const std::string& name) {
  if (!is_utf8(name)) throw BadInput(kind + " " + in_quotes(name) + ": its name is not UTF-8");
  for (const char c : name)
    if ((c >= 0 && c < ' ') || c == 0x7f)
      throw BadInput(kind + " " + in_quotes(name) + ": its name holds a control character");
}

void check_names(const Scene& scene) {
  for (const std::string& line : scene.provenance) check_name("provenance", line);
  for (const Texture& texture : scene.textures) check_name("texture", texture.name);
  for (const Material& material : scene.materials) check_name("material", material.name);
  for (const Object& object : scene.objects) check_name("object", object.name);
  for (const Body& body : scene.bodies) check_name("body", body.name);
  for (const Spot& spot : scene.spots) check_name("spot", spot.name);
  for (const Camera& camera : scene.cameras) check_name("camera", camera.name);
}

void check_points(const Scene& scene) {
  for (size_t i = 0; i < scene.vertices.size(); ++i)
    if (!is_placed(scene.vertices[i])) fail("vertex", i, kNotPlaced);
  for (size_t i = 0; i < scene.uvs.size(); ++i)
    if (!std::isfinite(scene.uvs[i].x) || !std::isfinite(scene.uvs[i].y))
      fail("texture coordinate", i, "it is not finite");
  for (size_t i = 0; i < scene.normals.size(); ++i)
    if (!(std::abs(length(scene.normals[i]) - 1) <= kUnitTolerance)) fail("normal", i, "its length is not 1");
}

void check_polygon(const Scene& scene, size_t i) {
  const Polygon& polygon = scene.polygons[i];
  for (int c = 0; c < polygon.corner_count(); ++c)
    if (polygon.corners[c] >= scene.vertices.size())
      fail("polygon", i, index_fault("a corner's vertex", polygon.corners[c], scene.vertices.size()));
  for (const uint32_t uv : polygon.uvs)
    if (uv != kNone && uv >= scene.uvs.size())
      fail("polygon", i, index_fault("a texture coordinate", uv, scene.uvs.size()));
  for (int c = 0; c < 4; ++c) {
    const uint32_t normal = polygon.normals[c];
    if ((normal != kNone) != (polygon.is_smooth() && c < polygon.corner_count()))
      fail("polygon", i, "it has a normal at some of its corners, expected at all or at none");
    if (normal != kNone && normal >= scene.normals.size())
      fail("polygon", i, index_fault("a normal", normal, scene.normals.size()));
  }
  if (polygon.material >= scene.materials.size())
    fail("polygon", i, index_fault("its material", polygon.material, scene.materials.size()));
  if (polygon.object >= scene.objects.size())
    fail("polygon", i, index_fault("its object", polygon.object, scene.objects.size()));
}

bool is_share(Rgb rgb) {
  for (int c = 0; c < 3; ++c)
    if (!(rgb[c] >= 0 && rgb[c] <= 1)) return false;
  return true;
}

void check_finish(const Material& material) {
  const Finish& finish = material.finish;
  if (!is_share(finish.specular)) fail("material", material.name, "specular reflectance is not within 0..1");
  if (!is_share(finish.transmission)) fail("material", material.name, "transmission is not within 0..1");
  if (!(finish.roughness >= 0 && finish.roughness <= 1))
    fail("material", material.name, "roughness is not within 0..1");
  if (!(finish.ior >= kLeastIor && finish.ior <= kMostIor))
    fail("material", material.name, "index of refraction is not within 0.01..100");
}

void check_material(const Scene& scene, const Material& material) {
  check_finish(material);
  const Rgb rho = material.reflectance, emission = material.emission;
  for (int c = 0; c < 3; ++c) {
    if (!(rho[c] >= 0 && rho[c] <= 1)) fail("material", material.name, "reflectance is not within 0..1");
    if (!(emission[c] >= 0 && std::isfinite(emission[c])))
      fail("material", material.name, "emission is negative or not finite");
  }
  if (material.texture != kNone && material.texture >= scene.textures.size())
    fail("material", material.name, index_fault("its texture", material.texture, scene.textures.size()));
}

void check_texture(const Texture& texture) {
  const uint64_t pixels = uint64_t{texture.width} * texture.height;
  if (pixels == 0) fail("texture", texture.name, "it has no pixels");
  if (texture.srgb.size() % 3 != 0 || texture.srgb.size() / 3 != pixels)
    fail("texture", texture.name, "its size is not width times height");
  if (texture.opacity.values.size() != uint64_t{texture.opacity.width} * texture.opacity.height)
    fail("texture", texture.name, "the size of its opacity is not width times height");
}

template <typename Key>
void check_times(const std::vector<Key>& keys, const std::string& kind, const std::string& name) {
  for (size_t i = 0; i < keys.size(); ++i) {
    if (!std::isfinite(keys[i].time)) fail(kind, name, "a key's time is not finite");
    if (i > 0 && keys[i].time < keys[i - 1].time) fail(kind, name, "its keys are not in order of time");
  }
}

bool is_unit(Quat q) { return std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) <= kUnitTolerance; }

void check_body(const Scene& scene, size_t i) {
  const Body& body = scene.bodies[i];
  if (i > 0 && body.parent >= i) fail("body", body.name, "its parent does not come before it");
  if (!is_placed(body.pivot)) fail("body", body.name, "its pivot is not finite, or beyond 1e15 m");
  if (!(std::abs(length2(body.axis) - 1) <= kUnitTolerance))
    fail("body", body.name, "its axis has not length 1");
  if (body.ease != Ease::kLinear && body.ease != Ease::kSmooth) fail("body", body.name, "unknown easing");
  check_times(body.keys, "body", body.name);
  for (const BodyKey& key : body.keys) {
    if (!is_placed(key.move)) fail("body", body.name, kNotPlaced);
    if (!std::isfinite(key.turn)) fail("body", body.name, "a key is not finite");
    if (key.has_quat && !is_unit(key.quat)) fail("body", body.name, "a quaternion has not length 1");
  }
}

void check_spot(const Scene& scene, const Spot& spot) {
  if (spot.body >= scene.bodies.size())
    fail("spot", spot.name, index_fault("its body", spot.body, scene.bodies.size()));
  if (!(0 <= spot.inner && spot.inner <= spot.outer && spot.outer < kPi))
    fail("spot", spot.name, "its cone is not 0 <= inner <= outer < 180 degrees");
  if (spot.keys.empty()) fail("spot", spot.name, "it has no key");
  check_times(spot.keys, "spot", spot.name);
  for (const SpotKey& key : spot.keys) {
    if (!is_placed(key.at) || !is_placed(key.aim)) fail("spot", spot.name, kNotPlaced);
    for (int c = 0; c < 3; ++c)
      if (!(key.intensity[c] >= 0 && std::isfinite(key.intensity[c])))
        fail("spot", spot.name, "an intensity is negative or not finite");
  }
}

void check_glows(const Scene& scene) {
  std::vector<bool> glows(scene.materials.size());
  for (size_t i = 0; i < scene.glows.size(); ++i) {
    const Glow& glow = scene.glows[i];
    if (glow.material >= glows.size())
      fail("glow", i, index_fault("its material", glow.material, glows.size()));
    const std::string& name = scene.materials[glow.material].name;
    if (glows[glow.material]) fail("glow", name, "its material has another glow");
    glows[glow.material] = true;
    if (glow.keys.empty()) fail("glow", name, "it has no key");
    check_times(glow.keys, "glow", name);
    for (const GlowKey& key : glow.keys)
      if (!(key.value >= 0 && std::isfinite(key.value)))
        fail("glow", name, "a value is negative or not finite");
  }
}

void check_camera(const Camera& camera) {
  if (camera.keys.empty()) fail("camera", camera.name, "it has no key");
  check_times(camera.keys, "camera", camera.name);
  for (const CameraKey& key : camera.keys) {
    if (!is_placed(key.from) || !is_placed(key.to)) fail("camera", camera.name, kNotPlaced);
    if (!is_finite(key.up)) fail("camera", camera.name, "a key is not finite");
    if (!(key.fov > 0 && key.fov < kPi))
      fail("camera", camera.name, "its field of view is not within 0..180 degrees");
  }
}

void check_time(const Scene& scene) {
  if (!std::isfinite(scene.start) || !std::isfinite(scene.end) || scene.end < scene.start)
    throw BadInput("the interval of time does not start before it ends");
  if (!(scene.rate > 0 && std::isfinite(scene.rate))) throw BadInput("the frame rate is not positive");
  if (!((scene.end - scene.start) * scene.rate < kMostFrames)) throw BadInput("there are too many frames");
}

void check_bodies(const Scene& scene) {
  if (scene.bodies.empty()) throw BadInput("there is no body, expected the world");
  if (scene.bodies[0].parent != 0 || !scene.bodies[0].keys.empty())
    throw BadInput("the first body moves, expected the world");
  for (size_t i = 0; i < scene.bodies.size(); ++i) check_body(scene, i);
  for (const Object& object : scene.objects)
    if (object.body >= scene.bodies.size())
      fail("object", object.name, index_fault("its body", object.body, scene.bodies.size()));
}

}  // namespace

void validate(const Scene& scene) {
  check_names(scene);
  check_time(scene);
  check_points(scene);
  for (size_t i = 0; i < scene.polygons.size(); ++i) check_polygon(scene, i);
  for (const Texture& texture : scene.textures) check_texture(texture);
  for (const Material& material : scene.materials) check_material(scene, material);
  check_bodies(scene);
  for (const Spot& spot : scene.spots) check_spot(scene, spot);
  check_glows(scene);
  for (const Camera& camera : scene.cameras) check_camera(camera);
}

bool has_finishes(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return !is_plain(material.finish); });
}

int frame_count(const Scene& scene) {
  // The product may be just below a whole number by rounding.
  const double frames = (scene.end - scene.start) * scene.rate;
  return std::max(1, static_cast<int>(std::floor(frames + 1e-6)));
}

}  // namespace strad
