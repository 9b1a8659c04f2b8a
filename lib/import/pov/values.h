// What a POV-Ray scene file can name: numbers, strings, transformations, textures, objects, lights, cameras.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "import/pov/tokens.h"

namespace strad {

// A place in a file, for what is complained about only when it is used.
struct PovPlace {
  std::string file;
  uint32_t line = 0;
};
struct PovProblem {
  std::string what;
  PovPlace place;
};

// A number, a vector or a colour (red, green, blue, filter, transmit).
struct PovNumbers {
  int size = 1;  // 1 to 5
  std::array<double, 5> parts{};
  double operator[](int i) const { return parts[static_cast<size_t>(i)]; }
  double& operator[](int i) { return parts[static_cast<size_t>(i)]; }
};

// p maps to x * rows[0] + y * rows[1] + z * rows[2] + rows[3].
struct PovTransform {
  std::array<Vec3, 4> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{}};

  Vec3 direction(Vec3 v) const { return v.x * rows[0] + v.y * rows[1] + v.z * rows[2]; }
  Vec3 point(Vec3 p) const { return direction(p) + rows[3]; }
  bool mirrors() const { return dot(cross(rows[0], rows[1]), rows[2]) < 0; }
  // First this, then `next`.
  void append(const PovTransform& next) {
    for (size_t i = 0; i < 3; ++i) rows[i] = next.direction(rows[i]);
    rows[3] = next.point(rows[3]);
  }
};

// A picture laid on by texture coordinates.
struct PovImage {
  std::string path, name;
  bool linear = false;  // its numbers are light, not on the sRGB curve
  PovPlace place;
};

struct PovPigment {
  std::string name;  // of the declaration it comes from
  Rgb colour;        // POV-Ray's pigments are black where nothing is said
  std::shared_ptr<const PovImage> image;
  std::optional<PovProblem> problem;
};

struct PovFinish {
  double diffuse = 0.6;   // POV-Ray's own
  Rgb ambient, emission;  // POV-Ray's own ambient light is 0.1; here only what the file says counts
  std::optional<PovProblem> problem;  // mirrors
  std::optional<PovProblem> note;     // highlights: no light to speak of
};

struct PovTexture {
  std::string name;  // of the declaration it comes from
  PovPigment pigment;
  PovFinish finish;
  PovPlace place;
};

// What a texture comes to in light.
struct PovSurface {
  std::string name;  // of its texture or pigment; "" where neither was declared
  Rgb reflectance, emission;
  std::shared_ptr<const PovImage> image;  // multiplies the reflectance
  std::vector<PovProblem> problems, notes;
  PovPlace place;
};
using PovSurfacePointer = std::shared_ptr<const PovSurface>;

// A flat piece of surface, counter-clockwise seen from outside in a right-handed space.
struct PovFacet {
  std::vector<uint32_t> corners;  // points of the object, 3 or more
  std::vector<uint32_t> uvs;      // as many, or none
  uint32_t part = 0;
  bool no_shadow = false;
  PovSurfacePointer surface;  // none: that of the object around it
};

struct PovLight {
  std::string name;  // of the declaration it comes from
  PovPlace place;
  Vec3 location;
  Rgb colour;
  bool spotlight = false;
  Vec3 point_at{0, 0, 1};
  double radius = 30, falloff = 45, tightness = 0;  // degrees, POV-Ray's own
  bool area = false;
  Vec3 axis1, axis2;
  int size1 = 1, size2 = 1;
  double fade_distance = 0, fade_power = 0;
  std::vector<PovProblem> problems;
};

// Without end until it is bounded.
struct PovPlane {
  Vec3 normal;  // unit
  double distance = 0;
};

struct PovObject {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  std::vector<PovFacet> facets;
  std::vector<std::string> parts{""};  // names of what it is made of; "" is the object itself
  std::vector<PovLight> lights;
  std::optional<PovPlane> plane;
  std::vector<PovProblem> problems;  // what it should hold but does not
  std::vector<PovProblem> notes;
  bool compound = false;  // a texture given later goes to facets without one only
  PovPlace place;
};

struct PovCamera {
  std::string name;
  Vec3 location, direction{0, 0, 1}, right{4.0 / 3, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
  PovPlace place;
  std::optional<PovProblem> problem;
};

struct PovMacro {
  std::shared_ptr<const PovFile> file;
  size_t body = 0;  // first token
  std::vector<std::string> parameters;
};

// Declared, but of no use here: an interior, a normal, a function.
struct PovIgnored {};

struct PovArray;
using PovValue =
    std::variant<PovIgnored, PovNumbers, std::string, std::shared_ptr<PovArray>, PovTransform, PovPigment,
                 PovFinish, PovTexture, std::shared_ptr<const PovObject>, PovLight, PovCamera, PovMacro>;

struct PovArray {
  std::vector<size_t> sizes;                   // of each dimension
  std::vector<std::optional<PovValue>> items;  // the last index runs fastest
};

}  // namespace strad
