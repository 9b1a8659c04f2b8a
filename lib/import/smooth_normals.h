// Normals of smooth surfaces: those that a file gives, and those that follow from which faces are smooth.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"

namespace strad {

enum class NormalsGiven : uint8_t {
  kSmooth,
  kFlat,      // they are all those of the polygon itself, which stays flat
  kContrary,  // they lie on both sides of the polygon, which stays flat
};

// Puts normals into a scene, equal ones once, as precisely as a stream keeps them.
class SmoothNormals {
 public:
  explicit SmoothNormals(Scene* scene) : scene_(scene) {}

  // Gives `polygon` the normals `given` at its corners, of any length above 0. Those of a file whose faces
  // are wound the other way are turned round.
  NormalsGiven set(Polygon* polygon, const Vec3* given);

 private:
  Scene* scene_;
  std::unordered_map<uint32_t, uint32_t> place_;  // by octahedral_code
};

// Which of a scene's polygons are parts of smooth surfaces.
struct SmoothFaces {
  std::vector<uint32_t> groups;  // by polygon: all of one group that meet are one surface; 0: none;
                                 // kNone: not to be smoothed
  double angle = 0;  // radians: polygons of no group that meet at up to this angle are one surface
};

// Gives normals to polygons that have none: at each corner, the mean of those of all polygons of the surface
// that meet there, weighted by their angle at the corner (Thuermer & Wuethrich 1998). Polygons meet where
// corners have equal positions, if they are of one body.
void smooth_by_faces(const SmoothFaces& faces, SmoothNormals* normals, Scene* scene);

// The same for all polygons of a scene that has no normals yet. `angle` in radians; 0: nothing is done.
void smooth_by_angle(double angle, Scene* scene);

}  // namespace strad
