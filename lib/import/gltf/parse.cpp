// The only user of tinygltf. It reads JSON and buffers; all that they say is checked here.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "import/gltf/components.h"
#include "import/gltf/files.h"
#include "import/gltf/model.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostItems = 50'000'000;  // of an accessor

struct Folder {
  fs::path path;
  std::string outside;  // a file that was asked for elsewhere
};

bool is_file(const std::string& name, void*) { return is_plain_file(name); }

bool read_whole(std::vector<unsigned char>* out, std::string* fault, const std::string& name, void* user) {
  auto* folder = static_cast<Folder*>(user);
  if (!is_inside(name, folder->path)) {
    folder->outside = name;
    *fault += name + " is outside the file's folder";
    return false;
  }
  try {
    append_file(name, out);
  } catch (const std::runtime_error& error) {
    *fault += error.what();
    return false;
  }
  return true;
}

// Keeps pictures as they are stored. Those in buffers are looked at later, when their bounds are known.
bool keep_picture(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

class GltfReader {
 public:
  GltfReader(const std::string& path, const ImportOptions& options, ImportReport* report)
      : path_(path), options_(options), report_(report) {
    made_.file = text_name(path);
  }
  GltfModel read();

 private:
  [[noreturn]] void fail(const std::string& what) const { throw BadInput(made_.file + ": " + what); }
  uint32_t index(int number, size_t count, const std::string& what) const;
  uint32_t optional_index(int number, size_t count, const std::string& what) const {
    return number < 0 ? kNone : index(number, count, what);
  }
  std::string name_of(const std::string& given, const std::string& kind, size_t i) const;
  void load();
  const unsigned char* view_bytes(int view, size_t offset, size_t size, const std::string& what) const;
  std::vector<double> numbers(int accessor, int components, const std::string& what) const;
  void put_sparse(const tinygltf::Accessor& accessor, size_t components, const std::string& what,
                  std::vector<double>* values) const;

  void extensions();
  void images();
  void materials();
  void meshes();
  GltfPrimitive primitive(const tinygltf::Primitive& given, const std::string& what) const;
  void cameras_and_lights();
  void nodes();
  void animations();
  void channel(const tinygltf::Animation& from, const tinygltf::AnimationChannel& given,
               const std::string& what, GltfAnimation* to);
  Rgb colour(const std::vector<double>& numbers, Rgb missing) const;

  const std::string& path_;
  const ImportOptions& options_;
  ImportReport* report_;
  tinygltf::Model model_;
  GltfModel made_;
};

uint32_t GltfReader::index(int number, size_t count, const std::string& what) const {
  if (number < 0 || static_cast<size_t>(number) >= count)
    fail(what + " " + std::to_string(number) + " of " + std::to_string(count));
  return static_cast<uint32_t>(number);
}

// Without what a motion file could not hold.
std::string GltfReader::name_of(const std::string& given, const std::string& kind, size_t i) const {
  std::string name = given.empty() ? kind + std::to_string(i) : given;
  for (char& c : name)
    if ((c >= 0 && c < ' ') || c == '"' || c == 0x7f) c = '_';
  return name;
}

void GltfReader::load() {
  std::vector<unsigned char> bytes = gltf_scene_bytes(path_);
  const size_t size = bytes.size();
  bytes.resize(size + 16);  // tinygltf takes the head of the second chunk for a part of its contents
  Folder folder{fs::path(path_).parent_path(), {}};
  if (folder.path.empty()) folder.path = ".";
  tinygltf::TinyGLTF loader;
  tinygltf::FsCallbacks files{is_file, tinygltf::ExpandFilePath, read_whole, nullptr, &folder};
  loader.SetFsCallbacks(files);
  loader.SetImageLoader(keep_picture, nullptr);
  std::string fault, warning;
  const bool binary = std::memcmp(bytes.data(), "glTF", 4) == 0;
  bool good = false;
  try {
    good = binary
               ? loader.LoadBinaryFromMemory(&model_, &fault, &warning, bytes.data(),
                                             static_cast<unsigned>(size), folder.path.string())
               : loader.LoadASCIIFromString(&model_, &fault, &warning, reinterpret_cast<char*>(bytes.data()),
                                            static_cast<unsigned>(size), folder.path.string());
  } catch (const std::exception& error) {  // of the JSON library, for numbers of the wrong type
    fail(error.what());
  }
  if (!folder.outside.empty()) fail("names a file outside its folder: " + in_quotes(folder.outside, 200));
  if (!good) fail(fault.empty() ? "is not a glTF file" : fault.substr(0, fault.find('\n')));
  if (!model_.asset.version.starts_with("2."))
    fail("has glTF version " + in_quotes(model_.asset.version) + ", expected 2.0");
}

// `size` bytes of a buffer view from `offset` on.
const unsigned char* GltfReader::view_bytes(int view, size_t offset, size_t size,
                                            const std::string& what) const {
  const auto& given = model_.bufferViews[index(view, model_.bufferViews.size(), what + ": uses buffer view")];
  const auto& data = model_.buffers[index(given.buffer, model_.buffers.size(), what + ": uses buffer")].data;
  if (given.byteOffset > data.size() || given.byteLength > data.size() - given.byteOffset)
    fail(what + ": its buffer view ends behind its buffer");
  if (offset > given.byteLength || size > given.byteLength - offset)
    fail(what + ": ends behind its buffer view");
  return data.data() + given.byteOffset + offset;
}

// The numbers of an accessor, `components` each.
std::vector<double> GltfReader::numbers(int accessor, int components, const std::string& what) const {
  const tinygltf::Accessor& given =
      model_.accessors[index(accessor, model_.accessors.size(), what + ": uses accessor")];
  const size_t width = bytes_of_component(given.componentType), count = given.count;
  if (tinygltf::GetNumComponentsInType(static_cast<uint32_t>(given.type)) != components || width == 0)
    fail(what + ": the accessor is of another type");
  if (count > kMostItems) fail(what + ": has " + std::to_string(count) + " items, too many");
  const size_t per_item = static_cast<size_t>(components);
  std::vector<double> values;
  if (given.bufferView >= 0) {
    const auto& view =
        model_.bufferViews[index(given.bufferView, model_.bufferViews.size(), what + ": uses buffer view")];
    const size_t stride = view.byteStride > 0 ? view.byteStride : width * per_item;
    if (stride < width * per_item || stride > 252) fail(what + ": its stride is " + std::to_string(stride));
    const size_t size = count > 0 ? stride * (count - 1) + width * per_item : 0;
    const unsigned char* bytes = view_bytes(given.bufferView, given.byteOffset, size, what);
    values.reserve(count * per_item);
    for (size_t i = 0; i < count; ++i)
      for (size_t c = 0; c < per_item; ++c)
        values.push_back(component_at(bytes + i * stride + c * width, given.componentType));
  } else {
    if (!given.sparse.isSparse && count > 0) fail(what + ": has no buffer view");
    values.resize(count * per_item);
  }
  if (given.sparse.isSparse) put_sparse(given, per_item, what, &values);
  if (given.normalized)
    for (double& value : values) value = normalized_value(value, given.componentType);
  for (const double value : values)
    if (!std::isfinite(value)) fail(what + ": has a number that is not finite");
  return values;
}

void GltfReader::put_sparse(const tinygltf::Accessor& accessor, size_t components, const std::string& what,
                            std::vector<double>* values) const {
  const auto& sparse = accessor.sparse;
  const size_t width = bytes_of_component(accessor.componentType);
  const size_t index_width = bytes_of_component(sparse.indices.componentType);
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 || index_width == 0)
    fail(what + ": is sparse in a wrong way");
  const auto count = static_cast<size_t>(sparse.count);
  const unsigned char* indices = view_bytes(
      sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset), count * index_width, what);
  const unsigned char* items =
      view_bytes(sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset),
                 count * width * components, what);
  for (size_t i = 0; i < count; ++i) {
    const double at = component_at(indices + i * index_width, sparse.indices.componentType);
    if (!(at >= 0 && at < static_cast<double>(accessor.count)))
      fail(what + ": a sparse index is out of range");
    for (size_t c = 0; c < components; ++c)
      (*values)[static_cast<size_t>(at) * components + c] =
          component_at(items + (i * components + c) * width, accessor.componentType);
  }
}

Rgb GltfReader::colour(const std::vector<double>& numbers, Rgb missing) const {
  if (numbers.size() < 3) return missing;
  const Rgb rgb{static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
                static_cast<float>(numbers[2])};
  if (!is_finite(rgb) || std::min({rgb.r, rgb.g, rgb.b}) < 0) fail("a colour is negative or not finite");
  return rgb;
}

void GltfReader::extensions() {
  for (const std::string& name : model_.extensionsRequired) {
    if (is_one_of(name, {"KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
                         "KHR_materials_transmission", "KHR_materials_ior", "KHR_mesh_quantization"}))
      continue;
    if (!options_.skip_unknown) fail("requires extension " + in_quotes(name) + ", which is not supported");
    report_->add("required extension " + in_quotes(name) + " left out", made_.file, 1);
  }
}

void GltfReader::images() {
  for (size_t i = 0; i < model_.images.size(); ++i) {
    tinygltf::Image& given = model_.images[i];
    const std::string what = "image " + std::to_string(i);
    Texture texture;
    texture.name = given.uri.empty() ? name_of(given.name, "image", i) : given.uri;
    std::vector<unsigned char> stored = std::move(given.image);
    if (given.bufferView >= 0) {
      const auto& view =
          model_.bufferViews[index(given.bufferView, model_.bufferViews.size(), what + ": uses buffer view")];
      const unsigned char* bytes = view_bytes(given.bufferView, 0, view.byteLength, what);
      stored.assign(bytes, bytes + view.byteLength);
    }
    if (!stored.empty()) {
      std::string fault, warning;
      tinygltf::Image decoded;
      if (!tinygltf::LoadImageData(&decoded, static_cast<int>(i), &fault, &warning, 0, 0, stored.data(),
                                   static_cast<int>(stored.size()), nullptr))
        fail(what + ": is not a picture that can be read");
      if (decoded.bits != 8 && decoded.bits != 16)
        fail(what + ": has " + std::to_string(decoded.bits) + " bits a channel");
      texture.width = static_cast<uint32_t>(decoded.width);
      texture.height = static_cast<uint32_t>(decoded.height);
      const size_t pixels = size_t{texture.width} * texture.height, wide = decoded.bits == 16 ? 2 : 1;
      const auto channels = static_cast<size_t>(decoded.component);
      if (channels < 3 || decoded.image.size() < pixels * channels * wide) fail(what + ": has no colours");
      for (size_t p = 0; p < pixels; ++p)
        for (size_t c = 0; c < 3; ++c)  // of 16 bits the upper 8, which are the second byte
          texture.srgb.push_back(decoded.image[(p * channels + c) * wide + wide - 1]);
      if (channels == 4) {
        texture.opacity = {texture.width, texture.height, {}};
        for (size_t p = 0; p < pixels; ++p)
          texture.opacity.values.push_back(decoded.image[(p * channels + 3) * wide + wide - 1]);
      }
    }
    made_.images.push_back(std::move(texture));
  }
}

void GltfReader::materials() {
  for (size_t i = 0; i < model_.materials.size(); ++i) {
    const tinygltf::Material& given = model_.materials[i];
    const auto& pbr = given.pbrMetallicRoughness;
    GltfMaterial material;
    material.name = name_of(given.name, "material", i);
    const auto number = [&](const char* extension, const char* name, double otherwise) {
      const auto found = given.extensions.find(extension);
      if (found == given.extensions.end() || !found->second.Get(name).IsNumber()) return otherwise;
      return found->second.Get(name).GetNumberAsDouble();
    };
    material.base_colour = colour(pbr.baseColorFactor, {1, 1, 1});
    material.metallic = pbr.metallicFactor;
    material.roughness = pbr.roughnessFactor;
    material.transmission = number("KHR_materials_transmission", "transmissionFactor", 0);
    material.ior = number("KHR_materials_ior", "ior", 1.5);
    material.emission = colour(given.emissiveFactor, {});
    const double strength = number("KHR_materials_emissive_strength", "emissiveStrength", 1);
    if (!(strength >= 0 && strength <= 1e15))
      fail("material " + material.name + ": its emissiveStrength is negative");
    material.emission = static_cast<float>(strength) * material.emission;
    if (pbr.baseColorTexture.index >= 0) {
      const auto& texture = model_.textures[index(pbr.baseColorTexture.index, model_.textures.size(),
                                                  "material " + material.name + ": uses texture")];
      material.image =
          index(texture.source, model_.images.size(), "material " + material.name + ": uses image");
      if (pbr.baseColorTexture.texCoord != 0) material.problems.push_back("baseColorTexture by TEXCOORD_1");
      if (pbr.baseColorTexture.extensions.contains("KHR_texture_transform"))
        material.problems.push_back("KHR_texture_transform");
    }
    if (given.emissiveTexture.index >= 0) material.problems.push_back("emissiveTexture");
    const double alpha = pbr.baseColorFactor.size() == 4 ? pbr.baseColorFactor[3] : 1;
    if (given.alphaMode == "MASK") material.hole_below = given.alphaCutoff / std::max(alpha, 1e-6);
    if (given.alphaMode == "BLEND") material.hole_below = 0.5 / std::max(alpha, 1e-6);
    if (given.alphaMode == "BLEND")
      material.notes.push_back("alphaMode BLEND is taken as holes where alpha is below a half");
    if (given.extensions.contains("KHR_materials_unlit"))
      material.notes.push_back("KHR_materials_unlit is taken as diffuse");
    if (pbr.metallicRoughnessTexture.index >= 0)
      material.notes.push_back("metallicRoughnessTexture is ignored");
    made_.materials.push_back(std::move(material));
  }
}

GltfPrimitive GltfReader::primitive(const tinygltf::Primitive& given, const std::string& what) const {
  GltfPrimitive made;
  made.material = optional_index(given.material, model_.materials.size(), what + ": uses material");
  if (!given.targets.empty()) made.problems.push_back("morph targets");
  if (given.extensions.contains("KHR_draco_mesh_compression"))
    fail(what + ": KHR_draco_mesh_compression is not supported");
  const int mode = given.mode < 0 ? TINYGLTF_MODE_TRIANGLES : given.mode;
  if (mode < TINYGLTF_MODE_TRIANGLES) return made;  // points and lines, without surface
  if (mode > TINYGLTF_MODE_TRIANGLE_FAN) fail(what + ": has mode " + std::to_string(mode));
  const auto position = given.attributes.find("POSITION");
  if (position == given.attributes.end()) fail(what + ": has no POSITION");
  const std::vector<double> points = numbers(position->second, 3, what + " POSITION");
  for (size_t i = 0; i + 2 < points.size(); i += 3) {
    made.points.push_back({points[i], points[i + 1], points[i + 2]});
    if (!(length(made.points.back()) < 1e15)) fail(what + ": a point is out of range");
  }
  if (const auto found = given.attributes.find("TEXCOORD_0"); found != given.attributes.end()) {
    const std::vector<double> uvs = numbers(found->second, 2, what + " TEXCOORD_0");
    if (uvs.size() / 2 != made.points.size()) fail(what + ": has not as many TEXCOORD_0 as POSITION");
    for (size_t i = 0; i + 1 < uvs.size(); i += 2) made.uvs.push_back({uvs[i], 1 - uvs[i + 1]});
  }
  std::vector<uint32_t> corners;
  if (given.indices >= 0) {
    for (const double at : numbers(given.indices, 1, what + " indices")) {
      if (!(at >= 0 && at < static_cast<double>(made.points.size())) || at != std::floor(at))
        fail(what + ": uses vertex " + std::to_string(static_cast<int64_t>(at)) + " of " +
             std::to_string(made.points.size()));
      corners.push_back(static_cast<uint32_t>(at));
    }
  } else {
    for (uint32_t i = 0; i < made.points.size(); ++i) corners.push_back(i);
  }
  const size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
  for (size_t i = 0; i + 2 < corners.size(); i += step) {
    const bool odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
    const uint32_t first = mode == TINYGLTF_MODE_TRIANGLE_FAN ? corners[0] : corners[i];
    made.triangles.push_back({first, corners[i + (odd ? 2 : 1)], corners[i + (odd ? 1 : 2)]});
  }
  return made;
}

void GltfReader::meshes() {
  for (size_t i = 0; i < model_.meshes.size(); ++i) {
    GltfMesh mesh{name_of(model_.meshes[i].name, "mesh", i), {}};
    for (const tinygltf::Primitive& given : model_.meshes[i].primitives) {
      if (given.mode >= 0 && given.mode < TINYGLTF_MODE_TRIANGLES)
        report_->add("points and lines left out", made_.file, 1);
      mesh.primitives.push_back(primitive(given, "mesh " + in_quotes(mesh.name)));
    }
    made_.meshes.push_back(std::move(mesh));
  }
}

void GltfReader::cameras_and_lights() {
  for (size_t i = 0; i < model_.cameras.size(); ++i) {
    const tinygltf::Camera& given = model_.cameras[i];
    made_.cameras.push_back(
        {name_of(given.name, "camera", i), given.perspective.yfov, given.type == "perspective"});
    if (made_.cameras.back().perspective && !(given.perspective.yfov > 0 && given.perspective.yfov < kPi))
      fail("camera " + in_quotes(made_.cameras.back().name) + ": its yfov is not within 0 to pi");
  }
  for (size_t i = 0; i < model_.lights.size(); ++i) {
    const tinygltf::Light& given = model_.lights[i];
    GltfLight light{name_of(given.name, "light", i),
                    given.type,
                    {},
                    given.spot.innerConeAngle,
                    given.spot.outerConeAngle};
    if (!(given.intensity >= 0 && given.intensity < 1e15))
      fail("light " + in_quotes(light.name) + ": its intensity is negative");
    light.intensity = static_cast<float>(given.intensity) * colour(given.color, {1, 1, 1});
    if (given.type == "spot" &&
        !(light.inner >= 0 && light.inner < light.outer && light.outer <= kPi / 2 + 1e-6))
      fail("light " + in_quotes(light.name) + ": its cone is not 0 <= inner < outer <= pi / 2");
    made_.lights.push_back(light);
  }
}

void GltfReader::nodes() {
  const auto& given = model_.nodes;
  for (size_t i = 0; i < given.size(); ++i) {
    const tinygltf::Node& from = given[i];
    const std::string what = "node " + std::to_string(i);
    GltfNode node;
    node.name = name_of(from.name, "node", i);
    node.mesh = optional_index(from.mesh, model_.meshes.size(), what + ": uses mesh");
    node.camera = optional_index(from.camera, model_.cameras.size(), what + ": uses camera");
    node.skinned = from.skin >= 0;
    if (const auto found = from.extensions.find("KHR_lights_punctual"); found != from.extensions.end()) {
      const auto& light = found->second.Get("light");
      node.light =
          index(light.IsInt() ? light.GetNumberAsInt() : -1, model_.lights.size(), what + ": uses light");
    }
    for (const int child : from.children)
      node.children.push_back(index(child, given.size(), what + ": uses node"));
    const auto numbers_of = [&](const std::vector<double>& list, size_t count) {
      if (!list.empty() && list.size() != count) fail(what + ": has a transformation of wrong size");
      for (const double value : list)
        if (!(std::abs(value) < 1e15)) fail(what + ": has a number that is out of range");
      return !list.empty();
    };
    if (numbers_of(from.matrix, 16)) {
      node.matrix.emplace();
      std::copy(from.matrix.begin(), from.matrix.end(), node.matrix->begin());
    }
    if (const auto& t = from.translation; numbers_of(t, 3)) node.translation = {t[0], t[1], t[2]};
    if (const auto& s = from.scale; numbers_of(s, 3)) node.scale = {s[0], s[1], s[2]};
    if (const auto& r = from.rotation; numbers_of(r, 4)) {
      const double norm = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
      if (!(norm > 0)) fail(what + ": its rotation has no length");
      node.rotation = {r[3] / norm, r[0] / norm, r[1] / norm, r[2] / norm};
    }
    made_.nodes.push_back(std::move(node));
  }
  if (model_.scenes.empty()) return set_roots(&made_, nullptr);
  const auto& scene =
      model_.scenes[index(std::max(model_.defaultScene, 0), model_.scenes.size(), "shows scene")];
  set_roots(&made_, &scene.nodes);
}

void GltfReader::channel(const tinygltf::Animation& from, const tinygltf::AnimationChannel& given,
                         const std::string& what, GltfAnimation* to) {
  if (given.target_path == "weights" || given.target_path == "pointer") {
    to->problems.push_back(given.target_path == "weights" ? "animation of morph targets"
                                                          : "KHR_animation_pointer");
    return;
  }
  if (given.target_node < 0) return;  // as the format says
  GltfChannel made;
  made.node = index(given.target_node, model_.nodes.size(), what + ": moves node");
  if (given.target_path == "translation") {
    made.path = GltfPath::kTranslation;
  } else if (given.target_path == "rotation") {
    made.path = GltfPath::kRotation;
  } else if (given.target_path == "scale") {
    made.path = GltfPath::kScale;
  } else {
    fail(what + ": has path " + in_quotes(given.target_path));
  }
  const auto& sampler = from.samplers[index(given.sampler, from.samplers.size(), what + ": uses sampler")];
  if (sampler.interpolation == "STEP") {
    made.interpolation = GltfInterpolation::kStep;
  } else if (sampler.interpolation == "CUBICSPLINE") {
    made.interpolation = GltfInterpolation::kCubicSpline;
  } else if (sampler.interpolation == "LINEAR" || sampler.interpolation.empty()) {
    made.interpolation = GltfInterpolation::kLinear;
  } else {
    fail(what + ": has interpolation " + in_quotes(sampler.interpolation));
  }
  made.times = numbers(sampler.input, 1, what + " input");
  const int components = made.path == GltfPath::kRotation ? 4 : 3;
  const std::vector<double> values = numbers(sampler.output, components, what + " output");
  const size_t each = made.interpolation == GltfInterpolation::kCubicSpline ? 3 : 1;
  if (made.times.empty() || values.size() != made.times.size() * each * static_cast<size_t>(components))
    fail(what + ": has not as many values as times");
  for (size_t i = 0; i < made.times.size(); ++i)
    if (!(made.times[i] >= 0 && made.times[i] < 1e6) || (i > 0 && !(made.times[i - 1] < made.times[i])))
      fail(what + ": its times do not ascend from 0 on");
  for (size_t i = 0; i < values.size(); i += static_cast<size_t>(components)) {
    made.values.push_back({values[i], values[i + 1], values[i + 2], components == 4 ? values[i + 3] : 0});
    for (const double value : made.values.back())
      if (!(std::abs(value) < 1e15)) fail(what + ": has a number that is out of range");
  }
  to->channels.push_back(std::move(made));
}

void GltfReader::animations() {
  for (size_t i = 0; i < model_.animations.size(); ++i) {
    GltfAnimation animation;
    animation.name = name_of(model_.animations[i].name, "animation", i);
    for (const auto& given : model_.animations[i].channels)
      channel(model_.animations[i], given, "animation " + in_quotes(animation.name), &animation);
    made_.animations.push_back(std::move(animation));
  }
}

GltfModel GltfReader::read() {
  load();
  extensions();
  images();
  materials();
  meshes();
  cameras_and_lights();
  nodes();
  animations();
  return std::move(made_);
}

}  // namespace

GltfModel read_gltf(const std::string& path, const ImportOptions& options, ImportReport* report) {
  return GltfReader(path, options, report).read();
}

}  // namespace strad
