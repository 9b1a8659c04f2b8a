// What a POV-Ray scene file describes: transformations, textures, objects, lights, cameras.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "import/pov/box_tree.h"
#include "import/pov/language/values.h"
#include "scene/scene.h"

namespace strad {

// p maps to x * rows[0] + y * rows[1] + z * rows[2] + rows[3].
struct PovTransform {
  std::array<Vec3, 4> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{}};

  Vec3 direction(Vec3 v) const { return v.x * rows[0] + v.y * rows[1] + v.z * rows[2]; }
  Vec3 point(Vec3 p) const { return direction(p) + rows[3]; }
  // Of a surface, outwards before and after; its length changes. By the cofactors, as for every plane.
  Vec3 normal(Vec3 n) const {
    const Vec3 turned =
        n.x * cross(rows[1], rows[2]) + n.y * cross(rows[2], rows[0]) + n.z * cross(rows[0], rows[1]);
    return mirrors() ? -turned : turned;
  }
  bool mirrors() const { return dot(cross(rows[0], rows[1]), rows[2]) < 0; }
  // Makes this the transformation by itself, then by `next`.
  void append(const PovTransform& next) {
    for (size_t i = 0; i < 3; ++i) rows[i] = next.direction(rows[i]);
    rows[3] = next.point(rows[3]);
  }
};

// A picture mapped by texture coordinates.
struct PovImage {
  std::string path, name;
  bool linear = false;  // its numbers are linear, not on the sRGB curve
  PovPlace place;
};

// Of a pattern: the mean over it.
struct PovPigment {
  std::string name;  // of its declaration
  Rgb colour;        // of the part that is opaque; POV-Ray's default is black
  double opacity = 1;
  Rgb passes;  // the fraction of light that goes through
  std::shared_ptr<const PovImage> image;
  std::optional<PovProblem> problem;
  std::optional<PovProblem> note;  // that it is a mean
};

struct PovFinish {
  double diffuse = 0.6;   // POV-Ray's default
  Rgb ambient, emission;  // 0 unless the file sets it; POV-Ray's default of 0.1 is not used
  Rgb reflection;         // of a mirror
  bool metallic = false;  // the mirror's colour is also that of the pigment
  bool fresnel = false;   // the mirror is that of a dielectric
  std::optional<PovProblem> problem;
  std::optional<PovProblem> note;         // highlights, which are ignored
  std::optional<PovProblem> mirror_note;  // what became of the mirror
};

struct PovTexture {
  std::string name;  // of its declaration
  PovPigment pigment;
  PovFinish finish;
  PovPlace place;
  double ior = 1;  // of the interior
};

// The entries of a color_map, pigment_map or texture_map: the values of a pattern at which they stand.
// Only the pigments matter in the first two.
struct PovMap {
  std::vector<std::pair<double, PovTexture>> entries;
};

// A texture as reflectance, emission and finish.
struct PovSurface {
  std::string name;  // of its texture or pigment; "" where neither was declared
  Rgb reflectance, emission;
  Finish finish;
  std::shared_ptr<const PovImage> image;  // multiplies the reflectance
  bool clear = false;                     // all light passes
  std::vector<PovProblem> problems, notes;
  PovPlace place;
};
using PovSurfacePointer = std::shared_ptr<const PovSurface>;

// A flat piece of surface, counter-clockwise seen from outside in a right-handed space.
struct PovFacet {
  std::vector<uint32_t> corners;  // points of the object, 3 or more
  std::vector<uint32_t> uvs;      // as many, or none
  std::vector<Vec3> normals;      // as many, of a smooth surface and of any length, or none
  uint32_t part = 0;
  bool no_shadow = false;
  PovSurfacePointer surface;  // null: that of the object around it
};

struct PovLight {
  std::string name;  // of its declaration
  PovPlace place;
  Vec3 location;
  Rgb colour;
  bool spotlight = false;
  Vec3 point_at{0, 0, 1};
  double radius = 30, falloff = 45, tightness = 0;  // degrees, POV-Ray's defaults
  bool area = false;
  Vec3 axis1, axis2;
  int size1 = 1, size2 = 1;
  double fade_distance = 0, fade_power = 0;
  std::vector<PovProblem> problems;
};

// Planes, and what is made of them, reach so far (in the units of the file) before they are cut.
constexpr double kEndless = 1e6;
struct PovPlane {
  Vec3 normal;  // unit
  double distance = 0;
};

// A closed surface of triangles, counter-clockwise seen from outside in a right-handed space.
struct PovHull {
  std::vector<Vec3> points;
  std::vector<std::array<uint32_t, 3>> triangles;
  Box box;                              // of the points
  std::shared_ptr<const BoxTree> tree;  // of the triangles; null where the hull is not settled
};

// What is inside an object, as a tree of simple solids.
struct PovSolid {
  enum Kind { kNothing, kHull, kBehindPlane, kUnion, kIntersection } kind = kNothing;
  bool inverse = false;
  std::vector<PovSolid> parts;  // of a union or an intersection
  std::shared_ptr<const PovHull> hull;
  PovTransform placed;  // of the hull's points
  PovPlane plane;       // its normal points outwards
};

// Negative inside.
using PovField = std::function<double(Vec3)>;

// A surface where a function is 0, of which it is not yet known how far it is wanted.
struct PovPending {
  std::string kind;
  PovField field;
  PovTransform placed;
};

struct PovObject {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  std::vector<PovFacet> facets;
  std::vector<std::string> parts{""};  // names of its parts; "": the object itself
  // Where the points of each simple shape in it begin, up to the next one's: shapes may move apart.
  std::vector<uint32_t> shapes{0};
  std::vector<PovLight> lights;
  PovSolid solid;
  std::optional<PovPending> pending;
  bool endless = false;  // facets reach far beyond the scene, where planes do; they are cut at the end
  std::vector<PovProblem> problems;  // what is missing from it
  std::vector<PovProblem> notes;
  bool compound = false;  // a later texture applies only to facets without one
  PovPlace place;
};

// An object that stands by itself in a file.
struct PovPlaced {
  std::string name;  // of its declaration, else its kind, such as "sphere"
  PovObject object;
};

struct PovCamera {
  std::string name;
  Vec3 location, direction{0, 0, 1}, right{4.0 / 3, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
  std::optional<Vec3> look_at;  // as the file gives it; later statements may have turned the camera away
  PovPlace place;
  std::optional<PovProblem> problem;
};

}  // namespace strad
