// The two ends of a link that joins a cluster with anything: points of the receiver and parts of the emitter,
// those of patches and clusters alike.
#pragma once

#include <algorithm>

#include "base/pose.h"
#include "solve/links/nodes.h"
#include "solve/links/patch_quarters.h"

namespace strad {

struct ReceiverPoint {
  Vec3 position, normal;  // world
  float response = 1;     // of the represented irradiance there, in units of its mean
};

struct EmitterPart {
  Vec3 position, normal;  // world
  float area = 0;         // m^2
  float represented = 0;  // share of the flux that the representation takes from it, from equal radiance
};

constexpr int kMostPoints = std::max(Cluster::kSamples, kQuadraturePoints + kMostControlPoints);
constexpr int kMostParts = std::max(Cluster::kSamples, 4);

// Return how many there are. `towards`: from the centre of this end to the other's, world.
int receiver_points(const NodeTree& tree, const Node& receiver, const Pose& pose, Vec3 towards, int control,
                    ReceiverPoint* points);
int emitter_parts(const NodeTree& tree, const Node& emitter, const Pose& pose, Vec3 towards,
                  EmitterPart* parts);

// Unoccluded irradiance at a point from a part of unit radiance, as from a disk of its area (Wallace,
// Elmquist & Haines 1989). So it is never more than that of a full view, however close the part is.
double unoccluded_irradiance(const ReceiverPoint& x, const EmitterPart& part);

}  // namespace strad
