// A glTF 2.0 file as plain data: all that strad takes of it, every index checked.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/pose.h"
#include "base/rgb.h"
#include "import/import.h"

namespace strad {

struct GltfPrimitive {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;  // as many, or none
  std::vector<std::array<uint32_t, 3>> triangles;
  uint32_t material = kNone;
  std::vector<std::string> problems;  // refused where it is used
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
};

struct GltfMaterial {
  std::string name;
  Rgb base_colour{1, 1, 1}, emission;
  double metallic = 1, roughness = 1, transmission = 0, ior = 1.5;  // as the file has them
  uint32_t image = kNone;
  double hole_below = 0;  // of the image's alpha; 0: no holes
  std::vector<std::string> problems, notes;
};

struct GltfCamera {
  std::string name;
  double yfov = 0;  // radians
  bool perspective = true;
};

struct GltfLight {
  std::string name, type;  // spot, point or directional
  Rgb intensity;           // candela times colour
  double inner = 0, outer = 0;
};

struct GltfNode {
  std::string name;
  std::vector<uint32_t> children;
  uint32_t mesh = kNone, camera = kNone, light = kNone;
  Vec3 translation{}, scale{1, 1, 1};
  Quat rotation{};
  std::optional<std::array<double, 16>> matrix{};  // by columns, in place of the three
  bool skinned = false;
};

enum class GltfPath { kTranslation, kRotation, kScale };
enum class GltfInterpolation { kStep, kLinear, kCubicSpline };

struct GltfChannel {
  uint32_t node = 0;
  GltfPath path{};
  GltfInterpolation interpolation{};
  std::vector<double> times;  // ascending, at least one
  std::vector<std::array<double, 4>>
      values;  // one a time; of a cubic spline three: tangent in, value, tangent out
};

struct GltfAnimation {
  std::string name;
  std::vector<GltfChannel> channels;
  std::vector<std::string> problems;  // of channels that are not taken
};

struct GltfModel {
  std::string file;  // its name in messages
  std::vector<GltfMesh> meshes;
  std::vector<GltfMaterial> materials;
  std::vector<Texture> images;  // without pixels where they are missing
  std::vector<GltfCamera> cameras;
  std::vector<GltfLight> lights;
  std::vector<GltfNode> nodes;
  std::vector<uint32_t> roots;  // of the scene that is shown
  std::vector<GltfAnimation> animations;
};

// Reads .gltf or .glb, told apart by its first bytes. Files that it names must lie in its folder or below.
// Throws IoError or BadInput.
GltfModel read_gltf(const std::string& path, const ImportOptions& options, ImportReport* report);

// Sets the roots: the nodes that a scene names, or without one all that have no parent. Throws BadInput
// unless the nodes below each root are a tree of their own: none has two parents, no root has one.
void set_roots(GltfModel* model, const std::vector<int>* named);

}  // namespace strad
