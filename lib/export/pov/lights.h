// The scene's lights as POV-Ray's own, of the same physical strength.
#pragma once

#include <string>
#include <vector>

#include "export/pov/text.h"
#include "scene/scene.h"
#include "scene/trajectory.h"

namespace strad {

// A piece of an emitting surface, in rest coordinates, with `samples` x `samples` lights of POV-Ray.
struct PovLamp {
  uint32_t material = 0;
  uint32_t body = 0;
  Vec3 centre, u, v;  // a parallelogram of these sides; unused where samples is 1
  Vec3 normal;        // unit, the side it emits from
  double area = 0;    // m^2
  int samples = 1;    // a power of two
};

// All emitting polygons in pieces, ordered by material. Pairs of triangles that make a parallelogram are
// joined. A polygon that is no parallelogram is cut into ever smaller ones. All pieces of one object and
// material together have about `samples`^2 lights.
std::vector<PovLamp> pov_lamps(const Scene& scene, int samples);

// Appends the declaration of an object that holds the light of a spot, or of the lamps [first, last).
void write_spot(const Spot& spot, const SpotState& state, const std::string& name, PovText* out);
void write_lamps(const PovLamp* first, const PovLamp* last, Rgb radiance,
                 const std::vector<Pose>& world_from_body, const std::string& name, PovText* out);

}  // namespace strad
